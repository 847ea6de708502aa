//! Ends that seat and slip: the muscle between them, its slopes and its energies.

use mckibben_core::{
    model::{Response, Workspace},
    muscle::{Muscle, Terminals},
};
use mckibben_fem::{
    elements::Elements,
    simulation::{Detail, ElementModel, Given, free_contraction},
};

fn pull(pressure_mpa: f64, force_n: f64) -> Given {
    Given::PressureAndPull {
        pressure_mpa,
        force_n,
    }
}

fn blocked(contraction: f64, force_n: f64) -> Given {
    Given::ContractionAndPull {
        contraction,
        force_n,
    }
}

fn fe(muscle: &Muscle) -> Box<dyn ElementModel> {
    "fe".parse::<Elements>().unwrap().build(muscle).unwrap()
}

fn with_ends(terminals: Terminals) -> Box<dyn ElementModel> {
    fe(&Muscle::prototype().with_terminals(terminals).unwrap())
}

fn elements(seating_mm: f64) -> Box<dyn ElementModel> {
    with_ends(Terminals {
        seating_mm: Some(seating_mm),
        ..Terminals::default()
    })
}

/// Searches and curves of a muscle through a point give its pull, contraction, pressure and volume,
/// within a relative difference.
fn searches_and_curves_meet(
    model: &dyn ElementModel,
    (p, e): (f64, f64),
    point: &Response,
    most: f64,
) {
    let w = &mut Workspace::new();
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < most, "{a} {b}");
    let force_n = point.force_n;
    close(model.reach(w, pull(p, force_n)).unwrap().contraction, e);
    close(
        model
            .solve(w, pull(p, force_n))
            .unwrap()
            .response
            .contraction,
        e,
    );
    close(model.reach(w, blocked(e, force_n)).unwrap().pressure_mpa, p);
    let curve = model.isometric(w, e, &[0.1, p], Detail::Point);
    let at = curve[1].as_ref().unwrap();
    close(at.force_n, force_n);
    close(at.contraction, e);
    close(at.volume_mm3, point.volume_mm3.unwrap());
}

/// F(P, ε) = F₀(P, ε + δ/L0) in every test and search, with the contraction of the whole muscle;
/// seating 0 changes no digit.
#[test]
fn every_test_of_a_seated_muscle_is_that_of_the_muscle_between_its_ends() {
    let (held, none, gives) = (elements(0.0), elements(0.0), elements(2.85));
    let w = &mut Workspace::new();
    let (p, shift) = (0.2, 0.01);
    let here = held.solve(w, Given::at(p, 0.1)).unwrap().response;
    assert_eq!(none.solve(w, Given::at(p, 0.1)).unwrap().response, here);
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
    let response = gives.solve(w, Given::at(p, 0.1 - shift)).unwrap().response;
    close(response.force_n, here.force_n);
    close(response.contraction, 0.1 - shift);
    close(
        gives.reach(w, pull(p, here.force_n)).unwrap().contraction,
        0.1 - shift,
    );
    close(
        gives
            .reach(w, blocked(0.1 - shift, here.force_n))
            .unwrap()
            .pressure_mpa,
        p,
    );
    close(
        gives
            .solve(w, pull(p, here.force_n))
            .unwrap()
            .response
            .contraction,
        0.1 - shift,
    );
    close(
        free_contraction(&*gives, w, p).unwrap(),
        free_contraction(&*held, w, p).unwrap() - shift,
    );
    let isometric = gives.isometric(w, 0.1 - shift, &[0.1, p], Detail::Point);
    close(isometric[1].as_ref().unwrap().force_n, here.force_n);
    assert_eq!(isometric[1].as_ref().unwrap().contraction, 0.1 - shift);
    let refused = gives.solve(w, Given::at(p, 2.0)).unwrap_err();
    assert!(
        matches!(refused, mckibben_fem::FemError::Question { contraction, .. } if (contraction - 2.0).abs() < 1e-12)
    );
}

/// ∂F/∂L0 at fixed ε, with the way of the ends in it, against central differences.
#[test]
fn the_slope_by_length_is_that_of_differences() {
    let w = &mut Workspace::new();
    let base = elements(2.85);
    let at = |length_mm: f64, w: &mut Workspace| {
        let mut tube = base.muscle().tube().clone();
        tube.length_mm = length_mm;
        let muscle = base.muscle().with_tube(tube).unwrap();
        let model = fe(&muscle);
        model.force_n(w, 0.2, 0.1).unwrap()
    };
    let difference = (at(286.0, w) - at(284.0, w)) / 2.0;
    let names = ["terminals.seating".to_owned(), "tube.length".into()];
    let slopes = base.force_by(w, 0.2, 0.1, &names).unwrap().unwrap();
    assert!(
        (slopes[1] - difference).abs() < 1e-3 * difference.abs(),
        "{slopes:?} {difference}"
    );
    let stiffness = base
        .response(w, 0.2, 0.1)
        .unwrap()
        .stiffness_n_per_mm
        .unwrap();
    assert!((slopes[0] + stiffness).abs() < 1e-9 * stiffness);
}

fn slipping() -> Box<dyn ElementModel> {
    let terminals = Terminals {
        seating_mm: Some(1.5),
        slip_mm_per_n: Some(4e-3),
        grip_mm: Some(5.0),
        ..Terminals::default()
    };
    with_ends(terminals)
}

/// The load of the ends is F + π Ri² P: the muscle between its ends, at the contraction that it is
/// left with by hand, pulls alike; every test and search says the same.
#[test]
fn ends_that_slip_are_a_spring_beside_the_muscle() {
    let (whole, w) = (slipping(), &mut Workspace::new());
    let inner = fe(&whole.muscle().between_ends());
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
    let (p, e) = (0.2, 0.08);
    let response = whole.solve(w, Given::at(p, e)).unwrap().response;
    let load = response.force_n + p * std::f64::consts::PI * 144.0;
    let x = (e * 285.0 + 1.5 + 4e-3 * load) / 275.0;
    close(
        response.force_n,
        inner
            .solve(&mut Workspace::new(), Given::at(p, x))
            .unwrap()
            .response
            .force_n,
    );
    close(whole.response(w, p, e).unwrap().force_n, response.force_n);
    close(
        whole
            .solve(w, blocked(e, response.force_n))
            .unwrap()
            .response
            .pressure_mpa,
        p,
    );
    searches_and_curves_meet(&*whole, (p, e), &response, 1e-8);
    let slopes = whole.isometric(w, e, &[p], Detail::Tangent);
    let tangent = slopes[0].as_ref().unwrap().response.unwrap();
    close(
        tangent.stiffness_n_per_mm.unwrap(),
        response.stiffness_n_per_mm.unwrap(),
    );
}

/// ∂F/∂c, ∂F/∂h, ∂F/∂L0 and ∂F/∂s of ends that slip against central differences.
#[test]
fn slopes_of_slipping_ends_are_those_of_differences() {
    let (base, w) = (slipping(), &mut Workspace::new());
    let pull = |muscle: &Muscle| {
        let model = fe(muscle);
        model.force_n(&mut Workspace::new(), 0.2, 0.08).unwrap()
    };
    let changed = |name: &str, h: f64| {
        let (mut tube, mut ends) = (
            base.muscle().tube().clone(),
            base.muscle().terminals().clone(),
        );
        match name {
            "terminals.slip" => ends.slip_mm_per_n = ends.slip_mm_per_n.map(|c| c + h),
            "terminals.grip" => ends.grip_mm = ends.grip_mm.map(|g| g + h),
            "tube.length" => tube.length_mm += h,
            _ => tube.wall_mm += h,
        }
        base.muscle()
            .with_terminals(ends)
            .unwrap()
            .with_tube(tube)
            .unwrap()
    };
    let names = [
        "terminals.slip",
        "terminals.grip",
        "tube.length",
        "tube.wall_thickness",
    ];
    let slopes = base
        .force_by(w, 0.2, 0.08, &names.map(str::to_owned))
        .unwrap()
        .unwrap();
    for ((name, slope), h) in names.into_iter().zip(slopes).zip([1e-4, 0.2, 0.5, 0.02]) {
        let difference = (pull(&changed(name, h)) - pull(&changed(name, -h))) / (2.0 * h);
        assert!(
            (slope - difference).abs() < 2e-3 * difference.abs(),
            "{name} {slope} {difference}"
        );
    }
}

/// Held at its rest length, a muscle stores what the air does: the energies of rubber, strands and
/// ends that slip rise by ∫ P dV.
#[test]
fn the_energy_of_ends_that_slip_is_part_of_the_balance() {
    let terminals = Terminals {
        slip_mm_per_n: Some(5e-3),
        ..Terminals::default()
    };
    let model = with_ends(terminals);
    let w = &mut Workspace::new();
    let mut at = |p: f64| model.solve(w, Given::at(p, 0.0)).unwrap();
    const STEPS: usize = 40;
    let (low, high) = (0.05, 0.25);
    let places: Vec<_> = (0..=STEPS)
        .map(|i| at(low + (high - low) * i as f64 / STEPS as f64))
        .collect();
    // ∫ P dV = [P V] − ∫ V dP, by Simpson's rule.
    let volume = |i: usize| places[i].response.volume_mm3.unwrap();
    let weight = |i: usize| {
        if i == 0 || i == STEPS {
            1.0
        } else {
            [2.0, 4.0][i % 2]
        }
    };
    let integral: f64 =
        (0..=STEPS).map(|i| weight(i) * volume(i)).sum::<f64>() * (high - low) / STEPS as f64 / 3.0;
    let work = high * volume(STEPS) - low * volume(0) - integral;
    let stored = |i: usize| {
        let e = places[i].energies;
        e.rubber_n_mm + e.braid_n_mm + e.ends_n_mm
    };
    let gained = stored(STEPS) - stored(0);
    let of_ends = places[STEPS].energies.ends_n_mm - places[0].energies.ends_n_mm;
    assert!(
        (gained / work - 1.0).abs() < 1e-5 && of_ends > 0.05 * work,
        "{gained} {work} {of_ends}"
    );
}
