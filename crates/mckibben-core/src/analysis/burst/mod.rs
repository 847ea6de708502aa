//! The burst pressure of a muscle: the least pressure at which one of its parts fails, one value
//! for each muscle and model.
//!
//! | failure | at | needs |
//! |---|---|---|
//! | [`strands`]: a strand breaks | T(P, 0) = T_max | number and strength of the strands |
//! | [`mesh`]: the tube bulges through an opening of the braid | P = 1.84 μ t/a | strands per carrier, their diameter |
//! | [`bladder`]: the rubber tears in the unloaded muscle | largest stretch = that at break | elongation at break |
//! | [`ends`]: tube and braid are pulled off the plug | F(P, 0) + π Ri² P = T_clamp | the clamps' pull-off force |
//!
//! Measured hand-made muscles with polyester sleeves failed at a tenth of what their strands bear:
//! the least of the four counts. All are those of new parts under a slow rise of the pressure:
//! abrasion, fatigue and ageing are no part of them. The allowed pressure is the least of each
//! divided by its safety factor, and at most that for which the fittings are rated. The factor is
//! [`SAFETY`] for strands and clamps, which let go suddenly, and half of it for the tube, which
//! leaks ([`FailureMode::share`]). Where number or strength of the strands are estimates, each
//! pressure has a least one; the allowed pressure keeps [`PROVED`] to it.

pub mod bladder;
pub mod ends;
mod failure;
mod limits;
pub mod mesh;
mod proof;
mod radii;
pub mod strands;

pub use failure::{
    Allowed, BUCKLING, Burst, FailureMode, FailurePressure, LEAST_SAFETY, NoBurst, PROOF_TO_BURST,
    PROOF_TO_WORKING, PROVED, RELIEF, SAFETY, Safety,
};
pub use limits::PressureLimits;
pub use proof::STRETCH;

use super::error::{AnalysisError, Result};
use crate::{
    built::HALF_95,
    model::{ForceModel, ModelKind},
    muscle::{Constant, Muscle},
};

/// The burst pressure of a model's muscle.
///
/// # Errors
/// [`AnalysisError`] where the work is cancelled, or the model has
/// no answer at all.
pub fn burst(model: &dyn ForceModel) -> Result<Burst> {
    burst_below(model, f64::INFINITY, 1.0)
}

/// [`burst`] of a muscle that works below a pressure in MPa: only failures below so many times it
/// matter. One answer of the model says that strands or clamps bear that, and those that do are not
/// solved for.
///
/// # Errors
/// Those of [`burst`].
pub fn burst_below(model: &dyn ForceModel, working_mpa: f64, factor: f64) -> Result<Burst> {
    let up_to_mpa = factor * working_mpa;
    let muscle = model.muscle();
    let (mut strands, from_thick_wall) = strands::breaking(model, up_to_mpa)?;
    let mut strained = strands::strained(model, working_mpa)?;
    let mut mesh = mesh::herniation(muscle);
    if let Some(weaker) = weaker(muscle) {
        let [found, bound] = [muscle, &weaker].map(|m| ModelKind::ThickWall.build(m));
        let (found, bound) = (found?, bound?);
        let share = |of: &dyn Fn(&dyn ForceModel) -> Result<FailurePressure>| {
            let at = |model| Ok::<_, AnalysisError>(of(model)?.mpa());
            let both = at(&*bound)?.zip(at(&*found)?);
            Ok::<_, AnalysisError>(both.map_or(1.0, |(bound, found)| (bound / found).min(1.0)))
        };
        strands = strands.times(share(&|m| Ok(strands::breaking(m, f64::INFINITY)?.0))?);
        strained = strained.times(share(&|m| strands::strained(m, f64::INFINITY))?);
        mesh = mesh::herniation(&weaker);
    }
    let ends = ends::pull_off(model, up_to_mpa)?;
    let least = [strands, mesh, ends]
        .into_iter()
        .filter_map(FailurePressure::mpa)
        .fold(up_to_mpa, f64::min);
    Ok(Burst {
        strands,
        mesh,
        bladder: bladder::tearing(muscle, least)?,
        ends,
        rated_mpa: muscle.terminals().rated_pressure_mpa,
        strained,
        safety: Safety::default(),
        overpressure: false,
        from_thick_wall,
    })
}

/// The muscle with the least angle that its measured pulls allow, and with angle, rubber and strands
/// of what was stated at most: a limit does not rise because a muscle pulled other than was thought.
fn weaker(muscle: &Muscle) -> Option<Muscle> {
    let bench = muscle.bench()?;
    let mut x = [0.0; Constant::ALL.len()];
    for (i, constant) in bench.constants.iter().enumerate() {
        let risen = bench.shift.get(i).map_or(0.0, |shift| shift.max(0.0));
        x[*constant as usize] = match constant {
            Constant::Angle => {
                let deviation_deg = bench.covariance.get(i)?.get(i)?.max(0.0).sqrt();
                -risen.max(HALF_95 * deviation_deg)
            }
            Constant::Modulus | Constant::Strands => -risen,
            _ => 0.0,
        };
    }
    // What lies beyond the plane braid is no muscle.
    muscle.with_constants(&x).ok()
}
