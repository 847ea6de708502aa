//! The pulley of a joint against a dense grid of radii.

use crate::design_grid::of_parts;
use mckibben_core::{
    model::ModelKind,
    muscle::Muscle,
    progress::Silent,
    random::{Random, rounds},
    units::Values,
};
use mckibben_design::{
    Candidate, Demand, JointDemand, Limits, Models, Spec, TorqueWanted, design_with,
};
use rayon::prelude::*;

/// Muscles within 3 % of the smallest are equal; the rest is that of radii between the grid's.
const EQUAL: f64 = 1.06;
/// Radii of the search, and their step in the grid, mm.
const RADII_MM: (f64, f64) = (5.0, 35.0);
const STEP_MM: f64 = 1.0;

fn on(spec: &Spec, radius_mm: f64) -> Spec {
    let Demand::Joint(joint) = &spec.wanted else {
        panic!()
    };
    let joint = JointDemand {
        radii_mm: Values::List(vec![radius_mm]),
        ..joint.clone()
    };
    Spec {
        wanted: Demand::Joint(joint),
        ..spec.clone()
    }
}

/// Random torques, of parts.
fn job(seed: u64) -> Spec {
    let r = &mut Random(seed + 100);
    let (torque_nm, angle_deg) = (r.log(1.0, 12.0), r.log(20.0, 70.0));
    let farther_deg = angle_deg * r.log(1.0, 1.4);
    let torque = |(torque_nm, angle_deg)| TorqueWanted {
        torque_nm,
        angle_deg,
    };
    let torques = [(torque_nm, angle_deg), (0.4 * torque_nm, farther_deg)];
    let parts = of_parts(seed);
    Spec {
        wanted: Demand::Joint(JointDemand {
            torques: torques.map(torque).to_vec(),
            largest_angle_deg: farther_deg,
            radii_mm: Values::Interval(RADII_MM.0, RADII_MM.1),
            beside: true,
        }),
        length_mm: Some(Values::List(vec![r.log(200.0, 350.0)])),
        limits: Limits::safe(),
        max_pressure_mpa: 0.6,
        top: 10,
        ..parts
    }
}

#[test]
fn no_radius_has_a_smaller_pair() {
    let thick_wall = |muscle: &Muscle| ModelKind::ThickWall.build(muscle);
    let is_good = |muscle: &Muscle| muscle.length_mm() > 5.0 * muscle.outer_diameter_mm();
    let models = Models {
        screen: &thick_wall,
        settle: Some((&thick_wall, is_good)),
    };
    let one = |seed: &u64| {
        let spec = job(*seed);
        let outcome = design_with(&spec, models, &Silent).unwrap();
        let steps = ((RADII_MM.1 - RADII_MM.0) / STEP_MM) as usize;
        let all = (0..=steps).flat_map(|i| {
            let spec = on(&spec, RADII_MM.0 + STEP_MM * i as f64);
            design_with(&spec, models, &Silent).unwrap().candidates
        });
        let all: Vec<Candidate> = all.collect();
        let Some(best) = outcome.candidates.first() else {
            assert!(all.is_empty(), "{seed}: {:?}", all[0].tube);
            return false;
        };
        let radius_mm = best.radius_mm;
        let width_mm = |c: &Candidate| c.bulged_diameter_mm().unwrap();
        let room_mm = 4.0 * radius_mm - width_mm(best) - best.muscle.outer_diameter_mm();
        assert!(room_mm >= 8.0, "{seed}: {room_mm}");
        let make = |c: &&Candidate| c.is_cast == best.is_cast;
        let least_mm = all
            .iter()
            .filter(make)
            .map(width_mm)
            .fold(f64::INFINITY, f64::min);
        assert!(
            width_mm(best) <= EQUAL * least_mm,
            "{seed}: {radius_mm} {least_mm}"
        );
        true
    };
    let seeds: Vec<u64> = (0..rounds(4) as u64).collect();
    let found: Vec<bool> = seeds.par_iter().map(one).collect();
    assert!(
        found.iter().filter(|found| **found).count() >= seeds.len() / 3,
        "{found:?}"
    );
}
