//! The pressure at which tube and braid are pulled off a plug.
//!
//!   F(P, 0) + π rp² P = T_clamp
//!
//! F is the pull of the blocked muscle. The pressure pushes the plug, of the radius rp, out of the
//! tube, so that the clamp carries both. T_clamp is the force at which it lets go, measured or of
//! its maker.

use super::{
    failure::{FailurePressure, NoBurst},
    strands::overloaded,
};
use crate::{
    analysis::error::Result,
    model::{ForceModel, Response},
    muscle::Muscle,
};
use std::f64::consts::PI;

/// The pressure at which the clamps of a model's muscle let go, where they do not bear a pressure
/// in MPa.
///
/// # Errors
/// [`AnalysisError`](crate::analysis::AnalysisError) where the work is cancelled, or the model has
/// no answer at all.
pub fn pull_off(model: &dyn ForceModel, up_to_mpa: f64) -> Result<FailurePressure> {
    let muscle = model.muscle();
    let Some(bears) = muscle.terminals().pull_off_n else {
        return Ok(FailurePressure::Unknown(NoBurst::Missing(
            "the pull-off force of the clamps is not stated; give `pull_off` in [terminals] of the \
             muscle file",
        )));
    };
    let load = |r: &Response| Some(clamp_load_n(muscle, r.force_n, r.pressure_mpa));
    Ok(overloaded(model, &load, bears, up_to_mpa)?.0)
}

/// What each clamp carries at a pull in N and a pressure in MPa, in N.
pub fn clamp_load_n(muscle: &Muscle, force_n: f64, pressure_mpa: f64) -> f64 {
    force_n + PI * muscle.parts().plug_radius_mm().powi(2) * pressure_mpa
}
