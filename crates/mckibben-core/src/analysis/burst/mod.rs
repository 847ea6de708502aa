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
pub mod mesh;
mod radii;
pub mod strands;

pub use failure::{
    Allowed, BUCKLING, Burst, FailureMode, FailurePressure, LEAST_SAFETY, NoBurst, PROVED,
    QUIET_MPA, RELIEF, SAFETY, Safety,
};

use super::error::Result;
use crate::model::ForceModel;

/// The burst pressure of a model's muscle.
///
/// # Errors
/// [`AnalysisError`](crate::analysis::AnalysisError) where the work is cancelled, or the model has
/// no answer at all.
pub fn burst(model: &dyn ForceModel) -> Result<Burst> {
    burst_below(model, f64::INFINITY)
}

/// [`burst`], of which only failures below a pressure in MPa matter: one answer of the model says
/// that strands or clamps bear it, and those that do are not solved for.
///
/// # Errors
/// Those of [`burst`].
pub fn burst_below(model: &dyn ForceModel, up_to_mpa: f64) -> Result<Burst> {
    let muscle = model.muscle();
    let (strands, from_thick_wall) = strands::breaking(model, up_to_mpa)?;
    let mesh = mesh::herniation(muscle);
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
        safety: Safety::default(),
        from_thick_wall,
    })
}
