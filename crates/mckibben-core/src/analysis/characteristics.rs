//! Free contraction, dead pressure and work.

use super::{error::Result, evaluation::Evaluation};

impl Evaluation<'_> {
    /// Free contraction: the ε at which a muscle at this pressure no longer pulls.
    ///
    /// # Errors
    /// As [`Evaluation::contraction_at`]; a model whose range ends while it still pulls has no free
    /// contraction.
    pub fn free_contraction(&mut self, pressure_mpa: f64) -> Result<f64> {
        let known = self.options.extrapolate || self.model.info().range.pressure_mpa.0 <= 0.0;
        if pressure_mpa == 0.0 && known && self.model.muscle().tube().prestretch == 1.0 {
            return Ok(0.0);
        }
        self.contraction_at(0.0, pressure_mpa)
    }

    /// Dead pressure P′ in MPa: below it the muscle does not pull at this contraction. Zero where
    /// it pulls from the start.
    ///
    /// # Errors
    /// As [`Evaluation::pressure_at`]: no pressure in the model's range makes it pull at this
    /// contraction; also where it pulls already at the lowest pressure of a range that does not
    /// begin at zero, since P′ lies below.
    pub fn start_pressure_mpa(&mut self, contraction: f64) -> Result<f64> {
        let lowest = self.model.info().range.pressure_mpa.0;
        // Without pressure a shortened muscle may have no equilibrium at all: then it does not pull
        // either.
        let extends = self.model.muscle().is_extensile();
        let acts = |force: f64| if extends { force <= 0.0 } else { force >= 0.0 };
        if lowest <= 0.0 && self.force_n(lowest, contraction).is_ok_and(acts) {
            return Ok(lowest);
        }
        self.pressure_at(0.0, contraction)
    }

    /// Work in J that the muscle does at constant pressure from ε = `from` to ε = `to`: L0 ∫ F dε.
    pub fn work_per_stroke_j(&mut self, pressure_mpa: f64, from: f64, to: f64) -> Result<f64> {
        // Ten panels of four-point Gauss; the curves are smooth.
        const PANELS: usize = 10;
        let h = (to - from) / PANELS as f64;
        let mut sum = 0.0;
        for panel in 0..PANELS {
            let mid = from + h * (panel as f64 + 0.5);
            for &(x, weight) in crate::model::gauss(4) {
                sum += 0.5 * h * weight * self.force_n(pressure_mpa, mid + 0.5 * h * x)?;
            }
        }
        Ok(sum * self.model.muscle().length_mm() * 1e-3)
    }
}
