//! The rows of one muscle. They depend on the plan and the muscle's number alone.

use super::{
    error::Result,
    plan::{Inputs, Plan, Testing, constants, rounded},
    warnings::Heeded,
};
use crate::columns::PointRow;
use mckibben_core::{
    cancel::Cancelled, model::Workspace, progress::Progress, status::Status, threads,
};
use mckibben_fem::{FemError, simulation::Detail, solver::curve::CurvePoint};
use std::sync::atomic::{AtomicUsize, Ordering};

/// All rows of a plan, in its order and in memory: for plans of a moderate size, and where there
/// are no files.
pub fn compute(plan: &Plan, progress: &dyn Progress) -> Result<Vec<PointRow>> {
    let done = AtomicUsize::new(0);
    let total = plan.muscles() as usize;
    let rows_of = |&number: &u64| -> Result<Vec<PointRow>, Cancelled> {
        progress.check()?;
        let rows = rows(plan, number);
        progress.check()?;
        progress.report(done.fetch_add(1, Ordering::Relaxed) + 1, total);
        Ok(rows)
    };
    let numbers: Vec<u64> = (0..plan.muscles()).collect();
    let all: Vec<Vec<PointRow>> = threads::map(&numbers, rows_of)
        .into_iter()
        .collect::<Result<_, Cancelled>>()?;
    Ok(all.concat())
}

/// All rows of muscle `number`, contraction by contraction.
pub fn rows(plan: &Plan, number: u64) -> Vec<PointRow> {
    let inputs = plan.inputs(number);
    let testing = &plan.testing;
    let points = contractions(testing, &inputs);
    let blank = |p: f64, e: f64| blank(number, &inputs, p, e);
    let made = inputs.muscle().map_err(|e| e.to_string()).and_then(|m| {
        let model = testing.elements.build(&m).map_err(|e| e.to_string())?;
        Ok((m, model))
    });
    let (muscle, model) = match made {
        Ok(made) => made,
        Err(why) => {
            return points
                .flat_map(|e| testing.pressures_mpa.iter().map(move |&p| (p, e)))
                .map(|(p, e)| PointRow {
                    status: Status::NoMuscle,
                    cause: why.clone(),
                    ..blank(p, e)
                })
                .collect();
        }
    };
    let heeded = Heeded::new(plan, inputs.data_to_stretch, &muscle, &*model);
    let detail = if testing.sensitivities {
        Detail::Sensitivities
    } else {
        Detail::Tangent
    };
    let workspace = &mut Workspace::new();
    let mut out = Vec::with_capacity(plan.points_per_muscle());
    for e in points {
        let curve = model.isometric(workspace, e, &testing.pressures_mpa, detail);
        for (&p, point) in testing.pressures_mpa.iter().zip(curve) {
            out.push(filled(heeded.at_pressure(blank(p, e)), point, &heeded));
        }
    }
    out
}

/// The contractions of one muscle.
pub fn contractions(testing: &Testing, inputs: &Inputs) -> impl Iterator<Item = f64> {
    let largest = testing.of_ideal.then(|| largest(inputs));
    let of = move |&e: &f64| largest.map_or(e, |largest| rounded(e * largest));
    testing.contractions.iter().map(of)
}

/// 1 − 1/(√3 cosθ0)
fn largest(inputs: &Inputs) -> f64 {
    (1.0 - 1.0 / (3f64.sqrt() * inputs.parts.braid.angle_deg.to_radians().cos())).max(0.0)
}

/// A row without an answer.
pub fn blank(muscle: u64, inputs: &Inputs, pressure_mpa: f64, contraction: f64) -> PointRow {
    let tube = &inputs.parts.tube;
    let law = &tube.rubber.law;
    PointRow {
        muscle,
        outer_diameter_mm: tube.outer_diameter_mm,
        wall_mm: tube.wall_mm,
        length_mm: tube.length_mm,
        angle_deg: inputs.parts.braid.angle_deg,
        rubber: tube.rubber.name.clone().unwrap_or_default(),
        law: law.name().into(),
        constants: constants(law),
        measures: inputs.measures.clone(),
        braid_stiffness_n_per_mm: inputs.family_stiffness_n_per_mm(),
        pressure_mpa,
        contraction,
        ..PointRow::default()
    }
}

fn filled(row: PointRow, point: Result<CurvePoint, FemError>, heeded: &Heeded<'_>) -> PointRow {
    let count = |iterations: usize| u32::try_from(iterations).unwrap_or(u32::MAX);
    match point {
        Ok(CurvePoint {
            response: Some(r),
            sensitivities,
            iterations,
            ..
        }) if r.force_n.is_finite() => {
            let finite = |v: Option<f64>| v.filter(|v| v.is_finite());
            PointRow {
                force_n: Some(r.force_n),
                volume_mm3: finite(r.volume_mm3),
                stiffness_n_per_mm: finite(r.stiffness_n_per_mm),
                force_per_pressure_n_per_mpa: finite(r.force_per_pressure_mm2),
                braid_tension_n: finite(r.braid_tension_n),
                strand_tension_n: finite(r.strand_tension_n),
                bulged_diameter_mm: finite(r.bulged_diameter_mm),
                max_stretch: finite(r.max_stretch),
                sensitivities: sensitivities
                    .into_iter()
                    .filter(|s| s.force_n_per_unit.is_finite())
                    .map(|s| (s.name, s.force_n_per_unit))
                    .collect(),
                status: Status::Ok,
                iterations: count(iterations),
                ..heeded.of_answer(row, &r)
            }
        }
        Ok(_) => PointRow {
            status: Status::NotConverged,
            cause: "the pull is not finite".into(),
            ..row
        },
        Err(error) => {
            let (status, iterations) = match &error {
                FemError::Path {
                    status, iterations, ..
                } => (*status, count(*iterations)),
                _ => (Status::NotConverged, 0),
            };
            PointRow {
                status,
                cause: error.to_string(),
                iterations,
                ..row
            }
        }
    }
}
