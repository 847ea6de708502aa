//! Tubes that are drawn on plugs of another diameter than their bore.

use super::prestretch::slopes_are_those_of_differences;
use mckibben_core::{
    model::{ForceModel, ModelKind, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube, measures::PLUG_DIAMETER},
    random::{Random, rounds},
    rubber::{Law, NeoHookean},
};
use mckibben_fem::{
    axisymmetric::Axisymmetric,
    three_dimensional::{BrickSpec, ThreeDimensional},
};

fn muscle(stiffness: BraidStiffness) -> Muscle {
    let braid = Braid {
        angle_deg: 25.0,
        stiffness,
        ..Braid::paper()
    };
    let tube = Tube::new(
        19.0,
        1.5,
        120.0,
        Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.4 })),
    );
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

/// D0 10–60 mm, L0/D0 5–20, s/D0 .02–.17, θ0 18–37°, P/μ .05–5, strand strain up to 6 %.
fn random(r: &mut Random) -> Option<(Muscle, f64, f64)> {
    let d0 = r.log(10.0, 60.0);
    let (length_mm, wall_mm) = (d0 * r.log(5.0, 20.0), d0 * r.between(0.02, 0.17));
    let angle_deg = r.between(18.0, 37.0);
    let mu_mpa = r.log(0.05, 1.0);
    let p = mu_mpa * r.log(0.05, 5.0);
    let k = p * d0 / (4.0 * angle_deg.to_radians().sin().powi(2) * r.log(0.001, 0.06));
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa }));
    let tube = Tube::new(d0, wall_mm, length_mm, rubber);
    let braid = Braid {
        angle_deg,
        stiffness: BraidStiffness::NewtonPerMm(k),
        ..Braid::paper()
    };
    Some((
        Muscle::new(tube, braid, Terminals::default(), None).ok()?,
        p,
        p / mu_mpa,
    ))
}

fn force_n(muscle: &Muscle, pressure_mpa: f64, contraction: f64) -> f64 {
    Axisymmetric::between_ends(muscle)
        .unwrap()
        .force_n(&mut Workspace::new(), pressure_mpa, contraction)
        .unwrap()
}

/// A plug with the diameter of the bore is the one that every muscle has.
#[test]
fn a_plug_of_the_bore_changes_no_digit() {
    let plain = muscle(BraidStiffness::NewtonPerMm(300.0));
    let stated = plain.with(&PLUG_DIAMETER, 16.0).unwrap();
    for (p, e) in [(0.3, 0.0), (0.2, 0.1), (0.25, -0.02)] {
        assert_eq!(force_n(&stated, p, e), force_n(&plain, p, e));
    }
}

/// A braid that is laid over the tube on its plugs carries nothing there. Pulls at 2.5 bar of
/// independent finite elements.
#[test]
fn a_braid_laid_over_wide_plugs_pulls_as_in_independent_finite_elements_and_nothing_without_pressure()
 {
    let braid = Braid {
        angle_deg: 22.0,
        stiffness: BraidStiffness::NewtonPerMm(800.0),
        ..Braid::paper()
    };
    let tube = Tube::new(
        20.0,
        2.0,
        100.0,
        Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.4 })),
    );
    let plain = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
    for (plug_mm, pull_n) in [(16.0, 738.7), (20.8, 798.8), (25.6, 768.3)] {
        let muscle = plain.with(&PLUG_DIAMETER, plug_mm).unwrap();
        assert!(force_n(&muscle, 0.0, 0.0).abs() < 1e-6, "{plug_mm}");
        assert!(
            (force_n(&muscle, 0.25, 0.0) - pull_n).abs() < 0.0025 * pull_n,
            "{plug_mm}"
        );
    }
}

/// Thin and thick tubes on plugs from half of the bore to almost twice of it.
#[test]
fn tubes_are_drawn_on_plugs_of_all_sizes_and_pull_nothing_without_pressure() {
    for (outer_mm, wall_mm, length_mm) in [
        (30.0, 1.5, 200.0),
        (20.0, 3.0, 80.0),
        (8.0, 0.4, 60.0),
        (40.0, 9.0, 300.0),
    ] {
        let tube = Tube::new(
            outer_mm,
            wall_mm,
            length_mm,
            Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.3 })),
        );
        let braid = Braid {
            angle_deg: 25.0,
            stiffness: BraidStiffness::NewtonPerMm(600.0),
            ..Braid::paper()
        };
        let plain = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
        for factor in [0.5, 0.7, 1.1, 1.4, 1.7, 1.95] {
            let m = plain
                .with(&PLUG_DIAMETER, factor * (outer_mm - 2.0 * wall_mm))
                .unwrap();
            assert!(force_n(&m, 0.0, 0.0).abs() < 1e-6, "{outer_mm} {factor}");
        }
    }
}

/// Slopes against central differences, and ∂F/∂P at fixed L = −∂V/∂L at fixed P.
#[test]
fn slopes_are_those_of_differences_and_maxwell_holds() {
    for plug_mm in [13.0, 19.0] {
        let m = muscle(BraidStiffness::NewtonPerMm(300.0))
            .with(&PLUG_DIAMETER, plug_mm)
            .unwrap();
        slopes_are_those_of_differences(&m, (0.25, 0.1));
    }
}

/// A braid that is not wide enough for the tube on its plugs, and bricks, whose strands are
/// diagonals of a cylinder.
#[test]
fn plugs_that_a_braid_or_bricks_do_not_have_are_refused() {
    let braid = Braid {
        angle_deg: 60.0,
        ..Braid::paper()
    };
    let tube = Tube::new(
        19.0,
        1.5,
        120.0,
        Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.4 })),
    );
    let steep = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
    let message = steep.with(&PLUG_DIAMETER, 22.0).unwrap_err().to_string();
    assert!(message.contains("60 degrees does not widen"), "{message}");
    let wide = muscle(BraidStiffness::Inextensible)
        .with(&PLUG_DIAMETER, 18.0)
        .unwrap();
    assert!(
        ThreeDimensional::between_ends_with(&wide, &BrickSpec::default())
            .unwrap_err()
            .to_string()
            .contains("terminals.plug_diameter")
    );
}

/// A plug on which no tube is drawn is refused with both numbers.
#[test]
fn an_impossible_plug_is_refused() {
    let message = muscle(BraidStiffness::Inextensible)
        .with(&PLUG_DIAMETER, 40.0)
        .unwrap_err()
        .to_string();
    assert!(
        message.contains("40\u{a0}mm") && message.contains("bore of the tube 16\u{a0}mm"),
        "{message}"
    );
}

/// `universal` has plugs as wide as the bore: its ± covers 95 % of the pulls of finite elements
/// with other plugs, at up to three contractions of random muscles with plugs of 0.8 to 1.3 times
/// the bore.
#[test]
fn universal_leaves_out_the_plugs_of_finite_elements() {
    let mut r = Random(11);
    let mut ratios = vec![];
    for _ in 0..rounds(300) {
        let factor = r.between(0.8, 1.3);
        let Some((plain, p, _)) = random(&mut r) else {
            continue;
        };
        let plug_mm = factor * 2.0 * plain.tube().inner_radius_mm();
        let Ok(muscle) = plain.with(&PLUG_DIAMETER, plug_mm) else {
            continue;
        };
        let fe = Axisymmetric::between_ends(&muscle).unwrap();
        let universal = ModelKind::Universal.build(&muscle).unwrap();
        let share = universal.info().accuracy.share_of_blocked.unwrap();
        let w = &mut Workspace::new();
        let Some(blocked) = fe.force_n(w, p, 0.0).ok().filter(|f| *f > 0.0) else {
            continue;
        };
        for _ in 0..3 {
            let e = r.unit() * muscle.max_ideal_contraction();
            let Some(force) = fe.force_n(w, p, e).ok().filter(|f| *f > 0.0) else {
                continue;
            };
            let ours = universal.force_n(&mut Workspace::new(), p, e).unwrap();
            ratios.push((ours - force).abs() / blocked / share);
        }
    }
    ratios.sort_by(f64::total_cmp);
    let at = |share: f64| ratios[(share * ratios.len() as f64) as usize];
    println!(
        "{} pulls: errors over the ± {:.3} (50 %), {:.3} (95 %), {:.3} (99 %)",
        ratios.len(),
        at(0.5),
        at(0.95),
        at(0.99)
    );
    assert!(
        ratios.len() > 300 && at(0.95) <= 1.0,
        "{}: {}",
        ratios.len(),
        at(0.95)
    );
}
