//! Formulas whose pull is in proportion to the pressure: F = P f(ε).

use super::{ForceModel, ModelInfo, Response, Result, Workspace};

/// What such a formula says at a contraction, per unit of pressure.
pub struct PerPressure {
    /// F/P
    pub f: f64,
    /// ∂(F/P)/∂λ
    pub f_l: f64,
    /// Volume of the cavity, at any pressure
    pub volume_mm3: f64,
    /// Outer diameter, at any pressure
    pub diameter_mm: f64,
    /// Sum of strand tensions over P
    pub tension: Option<f64>,
}

/// A formula of this kind.
struct Proportional<F> {
    info: ModelInfo,
    per_pressure: F,
}

/// The model of such a formula.
pub fn proportional(
    info: ModelInfo,
    per_pressure: impl Fn(f64) -> Result<PerPressure> + Send + Sync + 'static,
) -> Result<Box<dyn ForceModel>> {
    Ok(Box::new(Proportional { info, per_pressure }))
}

impl<F: Fn(f64) -> Result<PerPressure> + Send + Sync> ForceModel for Proportional<F> {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<Response> {
        let muscle = self.muscle();
        let at = (self.per_pressure)(contraction)?;
        let response = Response {
            pressure_mpa,
            contraction,
            force_n: pressure_mpa * at.f,
            volume_mm3: Some(at.volume_mm3),
            stiffness_n_per_mm: Some(pressure_mpa * at.f_l / muscle.length_mm()),
            force_per_pressure_mm2: Some(at.f),
            bulged_diameter_mm: Some(at.diameter_mm),
            ..Response::default()
        };
        at.tension
            .map(|tension| pressure_mpa * tension)
            .map_or(response, |n| response.with_braid_tension(n, muscle))
            .finite(&self.info.name)
    }
}
