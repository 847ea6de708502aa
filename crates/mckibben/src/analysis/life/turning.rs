//! How far strands that cross turn against each other in a cycle, and the work of their friction.
//!
//!   S/(μw) = 2 ∫ G dL,   G = (2/3) ∫ pc |dθ/dL| dA   ([`pivoting_n_per_mm`])
//!
//! S is the area of the hysteresis loop: there and back, with the half-width μw G ([`Friction`](crate::muscle::Friction)). Between the two states pressure
//! and contraction change together in proportion. Over the area of the sleeve as made, S/(μw A) is contact pressure times angle, (4/3) pc |Δθ|, where both are uniform.

use crate::model::{ForceModel, ModelError, Workspace, pivoting_n_per_mm};
use serde::Serialize;
use std::f64::consts::PI;

/// Weights of Boole's rule: the work of a cycle from 2 % to 18 % of contraction is good to 0.03 %.
const WEIGHTS: [f64; 5] = [7.0 / 90.0, 32.0 / 90.0, 12.0 / 90.0, 32.0 / 90.0, 7.0 / 90.0];

/// The strands' crossings in one cycle, there and back.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Turning {
    /// Work of friction per μw of the muscle's crossings, N (mJ for each mm of μw).
    pub friction_work_per_lever_n: f64,
    /// The same per area of the sleeve as made, MPa (mJ/mm² for each mm of μw): contact pressure times sliding.
    pub friction_work_per_lever_area_mpa: f64,
    /// Work of friction, J, where the muscle states its μw (`friction.lever`).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_work_j: Option<f64>,
}

/// The crossings in a cycle between two states, each a pressure in MPa and a contraction.
///
/// # Errors
/// [`ModelError`] where there is no answer between them.
pub fn turning<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    low: (f64, f64),
    high: (f64, f64),
) -> Result<Turning, ModelError> {
    let muscle = model.muscle();
    let mut mean = 0.0;
    for (i, weight) in WEIGHTS.into_iter().enumerate() {
        let t = i as f64 / (WEIGHTS.len() - 1) as f64;
        let (p, e) = (low.0 + t * (high.0 - low.0), low.1 + t * (high.1 - low.1));
        // Without pressure strands press on nothing.
        if p > 0.0 {
            mean += weight * pivoting_n_per_mm(model, workspace, p, e)?;
        }
    }
    let way_mm = muscle.length_mm() * (high.1 - low.1).abs();
    let friction_work_per_lever_n = 2.0 * mean * way_mm;
    let area_mm2 = 2.0 * PI * muscle.strand_lay().radius_mm * muscle.length_mm();
    let lever_mm = muscle.friction().map(|f| f.lever_mm).filter(|lever| *lever > 0.0);
    Ok(Turning {
        friction_work_per_lever_n,
        friction_work_per_lever_area_mpa: friction_work_per_lever_n / area_mm2,
        friction_work_j: lever_mm.map(|lever| 1e-3 * lever * friction_work_per_lever_n),
    })
}
