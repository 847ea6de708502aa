use crate::simulation::{Elements, Simulation};
use mckibben::model::Workspace;
use mckibben::muscle::{Muscle, Terminals};
use mckibben::progress::Silent;

fn elements(seating_mm: f64) -> Box<dyn Simulation> {
    let terminals = Terminals { seating_mm: Some(seating_mm), ..Terminals::default() };
    let muscle = Muscle::prototype().with_terminals(terminals).unwrap();
    "fe".parse::<Elements>().unwrap().build(&muscle).unwrap()
}

/// F(P, ε) = F₀(P, ε + δ/L0) in every test and search, with the contraction of the whole muscle; seating 0 changes no digit.
#[test]
fn every_test_of_a_seated_muscle_is_that_of_the_muscle_between_its_ends() {
    let (held, none, gives) = (elements(0.0), elements(0.0), elements(2.85));
    let w = &mut Workspace::new();
    let (p, shift) = (0.2, 0.01);
    let here = held.solve(w, p, 0.1).unwrap().response;
    assert_eq!(none.solve(w, p, 0.1).unwrap().response, here);
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
    let found = gives.solve(w, p, 0.1 - shift).unwrap().response;
    close(found.force_n, here.force_n);
    close(found.contraction, 0.1 - shift);
    close(gives.contraction_at_force(w, here.force_n, p).unwrap(), 0.1 - shift);
    close(gives.pressure_at_force_mpa(w, here.force_n, 0.1 - shift).unwrap(), p);
    close(gives.at_force(w, here.force_n, p).unwrap().response.contraction, 0.1 - shift);
    close(gives.free_contraction(w, p).unwrap(), held.free_contraction(w, p).unwrap() - shift);
    let (pressures, contractions) = ([0.1, p], [0.05 - shift, 0.1 - shift]);
    let isometric = gives.isometric(w, 0.1 - shift, &pressures, &Silent);
    let isobaric = gives.isobaric(w, p, &contractions, &Silent);
    let isotonic = gives.isotonic(w, here.force_n, &pressures, &Silent);
    close(isometric[1].as_ref().unwrap().force_n, here.force_n);
    assert_eq!(isometric[1].as_ref().unwrap().contraction, 0.1 - shift);
    close(isobaric[1].as_ref().unwrap().force_n, here.force_n);
    close(isotonic[1].as_ref().unwrap().contraction, 0.1 - shift);
    let refused = gives.solve(w, p, 2.0).unwrap_err();
    assert!(
        matches!(refused, crate::FemError::Question { contraction, .. } if (contraction - 2.0).abs() < 1e-12)
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
        let model = "fe".parse::<Elements>().unwrap().build(&muscle).unwrap();
        model.force_n(w, 0.2, 0.1).unwrap()
    };
    let difference = (at(286.0, w) - at(284.0, w)) / 2.0;
    let names = ["terminals.seating".to_owned(), "tube.length".into()];
    let found = base.force_by(w, 0.2, 0.1, &names).unwrap().unwrap();
    assert!((found[1] - difference).abs() < 1e-3 * difference.abs(), "{found:?} {difference}");
    let stiffness = base.response(w, 0.2, 0.1).unwrap().stiffness_n_per_mm.unwrap();
    assert!((found[0] + stiffness).abs() < 1e-9 * stiffness);
}

fn slipping() -> Box<dyn Simulation> {
    let terminals = Terminals {
        seating_mm: Some(1.5),
        slip_mm_per_n: Some(4e-3),
        grip_mm: Some(5.0),
        ..Terminals::default()
    };
    "fe".parse::<Elements>().unwrap().build(&Muscle::prototype().with_terminals(terminals).unwrap()).unwrap()
}

/// The load of the ends is F + π Ri² P: the muscle between its ends, at the contraction that it is left with by hand, pulls alike; every
/// test and search says the same.
#[test]
fn ends_that_slip_are_a_spring_beside_the_muscle() {
    let (whole, w) = (slipping(), &mut Workspace::new());
    let inner = "fe".parse::<Elements>().unwrap().build(&whole.muscle().between_ends()).unwrap();
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
    let (p, e) = (0.2, 0.08);
    let found = whole.solve(w, p, e).unwrap().response;
    let load = found.force_n + p * std::f64::consts::PI * 144.0;
    let x = (e * 285.0 + 1.5 + 4e-3 * load) / 275.0;
    close(found.force_n, inner.solve(&mut Workspace::new(), p, x).unwrap().response.force_n);
    close(whole.response(w, p, e).unwrap().force_n, found.force_n);
    close(whole.contraction_at_force(w, found.force_n, p).unwrap(), e);
    close(whole.at_force(w, found.force_n, p).unwrap().response.contraction, e);
    close(whole.pressure_at_force_mpa(w, found.force_n, e).unwrap(), p);
    close(whole.at_pressure_for(w, found.force_n, e).unwrap().response.pressure_mpa, p);
    let curves = [
        whole.isometric(w, e, &[0.1, p], &Silent),
        whole.isobaric(w, p, &[0.05, e], &Silent),
        whole.isotonic(w, found.force_n, &[0.1, p], &Silent),
    ];
    for curve in curves {
        let at = curve[1].as_ref().unwrap();
        close(at.force_n, found.force_n);
        close(at.contraction, e);
        close(at.volume_mm3, found.volume_mm3.unwrap());
    }
    let slopes = whole.isometric_with_tangents(w, e, &[p], false, &Silent);
    let tangent = slopes[0].as_ref().unwrap().response;
    close(tangent.stiffness_n_per_mm.unwrap(), found.stiffness_n_per_mm.unwrap());
}

/// ∂F/∂c, ∂F/∂h, ∂F/∂L0 and ∂F/∂s of ends that slip against central differences.
#[test]
fn slopes_of_slipping_ends_are_those_of_differences() {
    let (base, w) = (slipping(), &mut Workspace::new());
    let pull = |muscle: &Muscle| {
        let model = "fe".parse::<Elements>().unwrap().build(muscle).unwrap();
        model.force_n(&mut Workspace::new(), 0.2, 0.08).unwrap()
    };
    let changed = |name: &str, h: f64| {
        let (mut tube, mut ends) = (base.muscle().tube().clone(), base.muscle().terminals().clone());
        match name {
            "terminals.slip" => ends.slip_mm_per_n = ends.slip_mm_per_n.map(|c| c + h),
            "terminals.grip" => ends.grip_mm = ends.grip_mm.map(|g| g + h),
            "tube.length" => tube.length_mm += h,
            _ => tube.wall_mm += h,
        }
        base.muscle().with_terminals(ends).unwrap().with_tube(tube).unwrap()
    };
    let names = ["terminals.slip", "terminals.grip", "tube.length", "tube.wall_thickness"];
    let found = base.force_by(w, 0.2, 0.08, &names.map(str::to_owned)).unwrap().unwrap();
    for ((name, found), h) in names.into_iter().zip(found).zip([1e-4, 0.2, 0.5, 0.02]) {
        let difference = (pull(&changed(name, h)) - pull(&changed(name, -h))) / (2.0 * h);
        assert!((found - difference).abs() < 2e-3 * difference.abs(), "{name} {found} {difference}");
    }
}
