//! Liquid that a stroke takes.

use crate::analysis::{Evaluation, Result};
use crate::liquid::LiquidSupply;

/// Liquid that brings a muscle from rest to a working point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LiquidStroke {
    /// ΔV in mm³ at atmospheric pressure ([`Liquid::pushed_mm3`](crate::liquid::Liquid::pushed_mm3)).
    pub volume_mm3: f64,
    /// Mass of the liquid in muscle and dead volume there, g.
    pub mass_g: f64,
}

impl Evaluation<'_> {
    /// Liquid from rest (ε = 0, no pressure, filled without air) to (P, ε).
    ///
    /// # Errors
    /// [`AnalysisError::Unknown`](crate::analysis::AnalysisError::Unknown) for a model without volume; the model's own errors.
    pub fn liquid_per_stroke(
        &mut self,
        LiquidSupply { liquid, dead_volume_mm3 }: &LiquidSupply,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<LiquidStroke> {
        let there_mm3 = self.cavity_mm3(pressure_mpa, contraction)?;
        let rest_mm3 = self.cavity_mm3(0.0, 0.0)?;
        let volume_mm3 = liquid.pushed_mm3((rest_mm3, there_mm3), *dead_volume_mm3, pressure_mpa);
        Ok(LiquidStroke { volume_mm3, mass_g: liquid.mass_g(rest_mm3 + dead_volume_mm3 + volume_mm3) })
    }
}
