//! Liquid that a stroke takes.

use super::way::cavity_mm3;
use crate::analysis::Result;
use crate::liquid::LiquidSupply;
use crate::model::{ForceModel, Workspace};

/// Liquid that brings a muscle from rest to a working point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LiquidStroke {
    /// ΔV in mm³ at atmospheric pressure ([`Liquid::pushed_mm3`](crate::liquid::Liquid::pushed_mm3)).
    pub volume_mm3: f64,
    /// Mass of the liquid in muscle and dead volume there, g.
    pub mass_g: f64,
}

/// Liquid from rest (ε = 0, no pressure, filled without air) to (P, ε).
///
/// # Errors
/// [`AnalysisError::Unknown`](crate::analysis::AnalysisError::Unknown) for a model without volume; the model's own errors.
pub fn liquid_per_stroke(
    model: &dyn ForceModel,
    workspace: &mut Workspace,
    LiquidSupply { liquid, dead_volume_mm3 }: &LiquidSupply,
    pressure_mpa: f64,
    contraction: f64,
) -> Result<LiquidStroke> {
    let there_mm3 = cavity_mm3(model, workspace, pressure_mpa, contraction)?;
    let rest_mm3 = cavity_mm3(model, workspace, 0.0, 0.0)?;
    let volume_mm3 = liquid.pushed_mm3((rest_mm3, there_mm3), *dead_volume_mm3, pressure_mpa);
    Ok(LiquidStroke { volume_mm3, mass_g: liquid.mass_g(rest_mm3 + dead_volume_mm3 + volume_mm3) })
}
