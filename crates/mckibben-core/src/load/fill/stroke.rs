//! Liquid that a stroke takes.

use crate::{
    analysis::{Evaluation, Result},
    liquid::LiquidSupply,
};

impl Evaluation<'_> {
    /// Liquid from rest (ε = 0, no pressure, filled without air) to (P, ε): ΔV in mm³ at
    /// atmospheric pressure ([`Liquid::pushed_mm3`](crate::liquid::Liquid::pushed_mm3)).
    ///
    /// # Errors
    /// [`AnalysisError::Unknown`](crate::analysis::AnalysisError::Unknown) for a model without
    /// volume; the model's own errors.
    pub fn liquid_per_stroke_mm3(
        &mut self,
        LiquidSupply {
            liquid,
            dead_volume_mm3,
        }: &LiquidSupply,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64> {
        let there_mm3 = self.cavity_mm3(pressure_mpa, contraction)?;
        Ok(liquid.pushed_mm3(
            (self.cavity_mm3(0.0, 0.0)?, there_mm3),
            *dead_volume_mm3,
            pressure_mpa,
        ))
    }
}
