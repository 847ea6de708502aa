//! Air that a stroke takes.

use super::{
    error::{AnalysisError, Result},
    evaluation::Evaluation,
};
use serde::Serialize;

/// Atmospheric pressure in MPa (ISO 2533).
pub const ATMOSPHERE_MPA: f64 = 0.101_325;
/// γ = cp/cv of air.
pub const HEAT_RATIO: f64 = 1.4;
/// Normal litres are counted at 0 °C and 101.325 kPa (DIN 1343); the air in the muscle is at 20 °C.
const NORMAL_PER_ACTUAL: f64 = 273.15 / 293.15;

/// A volume in mm³ at 20 °C and atmospheric pressure, in normal litres.
pub fn normal_litres(volume_mm3: f64) -> f64 {
    volume_mm3 * 1e-6 * NORMAL_PER_ACTUAL
}

/// Air in a muscle that was filled from rest to a working point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Air {
    /// Cavity at the working point in mm³.
    pub volume_mm3: f64,
    /// Air to be supplied from the muscle at rest (cavity V0 at atmospheric pressure) to the
    /// working point, in normal litres: ((P + Pa) V − Pa V0)/Pa · 273.15/293.15, isothermal, air as
    /// an ideal gas at 20 °C.
    pub normal_litres: f64,
}

impl Evaluation<'_> {
    /// Air per stroke from rest (ε = 0, no pressure) to (P, ε).
    ///
    /// # Errors
    /// [`AnalysisError::Unknown`] for a model without volume; the model's own errors.
    pub fn air_per_stroke(&mut self, pressure_mpa: f64, contraction: f64) -> Result<Air> {
        let volume_mm3 = self.cavity_mm3(pressure_mpa, contraction)?;
        let rest = self.cavity_mm3(0.0, 0.0)?;
        let free_mm3 =
            ((pressure_mpa + ATMOSPHERE_MPA) * volume_mm3 - ATMOSPHERE_MPA * rest) / ATMOSPHERE_MPA;
        Ok(Air {
            volume_mm3,
            normal_litres: normal_litres(free_mm3),
        })
    }

    /// The cavity at a pressure and contraction, in mm³.
    ///
    /// # Errors
    /// As [`Evaluation::air_per_stroke`].
    pub fn cavity_mm3(&mut self, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        let model = self.model;
        let unknown = || AnalysisError::Unknown {
            model: model.info().name.to_string(),
            quantity: "the volume",
        };
        model
            .response(self.workspace, pressure_mpa, contraction)?
            .volume_mm3
            .ok_or_else(unknown)
    }
}
