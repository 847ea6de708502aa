//! Braid angles from 7° to 18°: such tubes become several times as wide. Every question at which
//! the muscle pulls is answered, alone as along a curve.
//!
//! `MCKIBBEN_TIMES=20` asks 1000 of them.

use mckibben_core::{
    model::{ForceModel, ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube},
    random::{Random, rounds},
    rubber::{Law, NeoHookean},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use std::f64::consts::PI;

/// Largest strain of strands; beyond it they break.
const STRAIN: f64 = 0.05;
/// Most factorisations of a question.
const COST: usize = 400;

fn muscle(
    [outer_diameter_mm, wall_mm, length_mm, angle_deg, mu_mpa]: [f64; 5],
    stiffness: BraidStiffness,
) -> Option<Muscle> {
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa }));
    let tube = Tube::new(outer_diameter_mm, wall_mm, length_mm, rubber);
    Muscle::new(
        tube,
        Braid {
            angle_deg,
            stiffness,
            ..Braid::paper()
        },
        Terminals::default(),
        None,
    )
    .ok()
}

/// A random muscle, a pressure in MPa and a contraction at which the infinitely long muscle pulls
/// and its strands hold.
fn question(r: &mut Random) -> Option<(Muscle, f64, f64)> {
    let d0 = r.log(5.0, 60.0);
    let measures = [
        d0,
        d0 * r.log(0.02, 0.15),
        d0 * r.log(3.0, 25.0),
        r.between(7.0, 18.0),
        r.log(0.05, 1.5),
    ];
    let stiffness = if r.unit() < 0.2 {
        BraidStiffness::Inextensible
    } else {
        BraidStiffness::NewtonPerMm(d0 * r.log(5.0, 100.0))
    };
    let (p, share) = (r.between(0.0, 0.8), r.between(0.0, 0.95));
    let muscle = muscle(measures, stiffness)?;
    let e = share * muscle.max_ideal_contraction();
    let endless = ThickWall::between_ends(&muscle)
        .response(&mut Workspace::new(), p, e)
        .ok()?;
    let width = 2.0 * PI * d0 * muscle.braid().angle_rad().cos();
    let strain = muscle.family_stiffness_n_per_mm().map_or(0.0, |k| {
        endless.braid_tension_n.unwrap_or(0.0) / (width * k)
    });
    (endless.force_n > 0.0 && strain < STRAIN).then_some((muscle, p, e))
}

/// The curve at the pressure of the question goes from rest length to its contraction.
#[test]
fn single_questions_at_small_angles_are_answered_as_along_a_curve() {
    let mut r = Random(5);
    let questions = std::iter::repeat_with(|| question(&mut r)).flatten();
    let mut failed = vec![];
    for (muscle, p, e) in questions.take(rounds(50)) {
        let model = Axisymmetric::between_ends(&muscle).unwrap();
        let workspace = &mut Workspace::new();
        let alone = model.force_n(workspace, p, e);
        let (along, mut curve) = (&mut Workspace::new(), Ok(0.0));
        for step in 0..=20 {
            curve = model.force_n(along, p, e * f64::from(step) / 20.0);
        }
        let scale = p * PI * muscle.tube().outer_radius_mm().powi(2);
        let cost = model.known(workspace).unwrap().effort.factorisations;
        match (alone, curve) {
            (Ok(a), Ok(b)) if (a - b).abs() < 1e-6 * scale && cost <= COST => {}
            (alone, curve) => failed.push(format!(
                "{alone:?}, {curve:?}, {cost}: {p} MPa, ε {e} of {muscle:?}"
            )),
        }
    }
    assert!(failed.is_empty(), "{} questions: {failed:#?}", failed.len());
}

/// 2 F(2 L0) − F(L0) leaves out what the ends do to first order in 1/L0: it tends to the pull of
/// the infinitely long muscle. (At 8° the ends make 6 % of the pull of the longer one; of second
/// order some tenths of a per cent are left.)
#[test]
fn long_muscles_with_small_angles_tend_to_the_infinitely_long_one() {
    for (angle, e) in [(8.0, 0.3), (10.0, 0.3), (12.0, 0.25)] {
        let pull = |length: f64| {
            let stiffness = BraidStiffness::NewtonPerMm(400.0);
            let muscle = muscle([14.0, 1.0, length, angle, 0.24], stiffness).unwrap();
            let endless = ThickWall::between_ends(&muscle)
                .force_n(&mut Workspace::new(), 0.3, e)
                .unwrap();
            (
                Axisymmetric::between_ends(&muscle)
                    .unwrap()
                    .force_n(&mut Workspace::new(), 0.3, e)
                    .unwrap(),
                endless,
            )
        };
        let ((short, endless), (long, _)) = (pull(1400.0), pull(2800.0));
        let limit = 2.0 * long - short;
        assert!(
            (limit / endless - 1.0).abs() < 0.01,
            "{angle}: {short} {long} {limit}, {endless}"
        );
    }
}
