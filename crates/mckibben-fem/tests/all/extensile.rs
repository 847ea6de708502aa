//! Muscles that extend: strands at more than 54.7° to the axis.

use super::prestretch::slopes_are_those_of_differences;
use mckibben_core::{
    analysis::{Evaluation, Options},
    model::{ForceModel, ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube},
    random::{Random, rounds},
    rubber::{Law, NeoHookean, RubberLaw},
};
use mckibben_fem::{
    axisymmetric::Axisymmetric,
    three_dimensional::{BrickSpec, ThreeDimensional},
};
use std::f64::consts::PI;

fn muscle(angle_deg: f64, length_mm: f64) -> Muscle {
    let stiffness = BraidStiffness::NewtonPerMm(300.0);
    let braid = Braid {
        angle_deg,
        stiffness,
        ..Braid::paper()
    };
    let tube = Tube::new(
        20.0,
        2.0,
        length_mm,
        Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.3 })),
    );
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

/// Without its ends a muscle is the infinitely long one: what 100 mm more of length change, at
/// equal strokes, is a slice of that.
#[test]
fn a_slice_of_a_long_muscle_is_the_thick_wall() {
    for (angle, e) in [(57.0, -0.01), (60.0, -0.05), (65.0, -0.15), (65.0, 0.0)] {
        let (long, longer) = (muscle(angle, 300.0), muscle(angle, 400.0));
        let (w, p) = (&mut Workspace::new(), 0.2);
        // ΔΠ per mm of length is that of the infinitely long muscle at the same pull.
        let slice = ThickWall::between_ends(&long);
        let at = slice.force_n(w, p, e).unwrap();
        let shortened = |m: &Muscle| {
            let model = Axisymmetric::between_ends(m).unwrap();
            Evaluation::new(&model, &mut Workspace::new(), Options::default())
                .contraction_at(at, p)
                .unwrap()
                * m.length_mm()
        };
        let limit = (shortened(&longer) - shortened(&long)) / 100.0;
        // The stations of the mesh are set by the length: what that changes is some 1e-6 of the
        // slice.
        assert!((limit - e).abs() < 5e-6, "{angle} {e}: {limit}");
    }
}

/// Slopes against central differences, and ∂F/∂P at fixed L = −∂V/∂L at fixed P.
#[test]
fn slopes_are_those_of_differences_and_maxwell_holds() {
    for (angle, e) in [(60.0, -0.06), (65.0, -0.1)] {
        slopes_are_those_of_differences(&muscle(angle, 120.0), (0.2, e));
    }
}

#[test]
fn bricks_agree() {
    let m = muscle(62.0, 60.0);
    for e in [0.0, -0.08] {
        let plane = Axisymmetric::between_ends(&m)
            .unwrap()
            .force_n(&mut Workspace::new(), 0.2, e)
            .unwrap();
        let bricks = ThreeDimensional::between_ends_with(&m, &BrickSpec::default())
            .unwrap()
            .force_n(&mut Workspace::new(), 0.2, e)
            .unwrap();
        assert!(
            (bricks - plane).abs() < 0.01 * plane.abs().max(5.0),
            "{e}: {bricks} {plane}"
        );
    }
}

/// Inverses give back the given point, and an unloaded muscle extends.
#[test]
fn inverses_come_back_and_free_muscles_are_longer_than_at_rest() {
    for angle in [57.0, 60.0, 70.0] {
        let m = muscle(angle, 150.0);
        let fe = Axisymmetric::between_ends(&m).unwrap();
        for model in [&ThickWall::between_ends(&m) as &dyn ForceModel, &fe] {
            let (w, options) = (&mut Workspace::new(), Options::default());
            let free = Evaluation::new(model, w, options)
                .free_contraction(0.2)
                .unwrap();
            assert!(
                free < 0.0 && free > m.max_ideal_contraction(),
                "{angle} {free}"
            );
            assert!(model.force_n(w, 0.2, free).unwrap().abs() < 1e-4);
            let e = 0.5 * free;
            let push = model.force_n(w, 0.2, e).unwrap();
            assert!(push < 0.0, "{angle} {push}");
            assert!(
                (Evaluation::new(model, w, options)
                    .contraction_at(push, 0.2)
                    .unwrap()
                    - e)
                    .abs()
                    < 1e-7,
                "{angle}"
            );
            assert!(
                (Evaluation::new(model, w, options)
                    .pressure_at(push, e)
                    .unwrap()
                    - 0.2)
                    .abs()
                    < 1e-7,
                "{angle}"
            );
        }
    }
}

/// A thick wall with strands that go slack one after the other: 45.5, 43.1, 29.5 and 21.4 N by an
/// independent implementation of the same elements.
#[test]
fn partly_slack_strands_of_a_stretched_muscle_have_an_answer() {
    let stiffness = BraidStiffness::NewtonPerMm(426.0);
    let tube = Tube::new(
        38.09,
        10.0,
        120.0,
        Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.18 })),
    );
    let braid = Braid {
        angle_deg: 72.0,
        stiffness,
        ..Braid::paper()
    };
    let m = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
    let (fe, w) = (
        Axisymmetric::between_ends(&m).unwrap(),
        &mut Workspace::new(),
    );
    for (p, pull) in [(0.0, 45.5), (0.03, 43.1), (0.05, 29.5), (0.06, 21.4)] {
        let force = fe.force_n(w, p, -0.1).unwrap();
        assert!((force - pull).abs() < 0.051, "{p} MPa: {force}");
    }
    let push = -30.0;
    let p = Evaluation::new(&fe, w, Options::default())
        .pressure_at(push, -0.1)
        .unwrap();
    assert!(
        (fe.force_n(w, p, -0.1).unwrap() - push).abs() < 1e-6 && p < 0.13,
        "{p}"
    );
}

/// A tube that is stretched and pulls has one equilibrium: no random one is without an answer, and
/// without its ends it would be the thick wall.
#[test]
fn stretched_muscles_always_have_an_answer() {
    let mut random = Random(18);
    for _ in 0..rounds(40) {
        let outer = random.between(8.0, 45.0);
        let law = Law::NeoHookean(NeoHookean {
            mu_mpa: random.between(0.05, 0.6),
        });
        let length_mm = outer * random.between(3.0, 12.0);
        let tube = Tube::new(
            outer,
            outer * random.between(0.12, 0.3),
            length_mm,
            Rubber::new(law.clone()),
        );
        let stiffness = BraidStiffness::NewtonPerMm(random.between(200.0, 2000.0));
        let braid = Braid {
            angle_deg: random.between(56.0, 75.0),
            stiffness,
            ..Braid::paper()
        };
        let m = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
        let (fe, long) = (
            Axisymmetric::between_ends(&m).unwrap(),
            ThickWall::between_ends(&m),
        );
        for e in [-0.03, -0.1] {
            let drawn = long.force_n(&mut Workspace::new(), 0.0, e).unwrap();
            for share in [0.0, 0.06, 0.2, 0.6] {
                let p = share * law.shear_modulus_mpa();
                let pull = fe.force_n(&mut Workspace::new(), p, e).unwrap();
                let endless = long.force_n(&mut Workspace::new(), p, e).unwrap();
                assert!(
                    (pull - endless).abs() < 0.1 * (drawn + p * PI * (0.5 * outer).powi(2)),
                    "{p} {e}: {pull} {endless} {m:?}"
                );
            }
        }
    }
}
