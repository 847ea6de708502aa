//! The results of a model at one pressure and contraction.

use super::{ModelError, Result};
use crate::muscle::Muscle;
use serde::Serialize;

/// One point of a muscle's behaviour. What a model does not have is `None`.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Response {
    /// Gauge pressure P in MPa.
    pub pressure_mpa: f64,
    /// Contraction ratio ε = ΔL/L0.
    pub contraction: f64,
    /// Pull F in N, tension positive; negative where the muscle would have to push.
    pub force_n: f64,
    /// Volume of the whole cavity between the terminals in mm³.
    pub volume_mm3: Option<f64>,
    /// ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    pub volume_per_pressure_mm3_per_mpa: Option<f64>,
    /// ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    pub volume_per_contraction_mm3: Option<f64>,
    /// ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    pub stiffness_n_per_mm: Option<f64>,
    /// ∂F/∂P at fixed ε, in mm² (N/MPa).
    #[serde(rename = "force_per_pressure_n_per_mpa")]
    pub force_per_pressure_mm2: Option<f64>,
    /// Tension of all strands together in N.
    pub braid_tension_n: Option<f64>,
    /// Tension of one strand in N, where the number of strands is known.
    pub strand_tension_n: Option<f64>,
    /// Largest outer diameter in mm.
    pub bulged_diameter_mm: Option<f64>,
    /// The largest principal stretch in the middle of the muscle, at the bore as a rule.
    pub middle_stretch: Option<f64>,
    /// The principal stretch below which 99 % of the rubber lies by volume; of models without ends
    /// that of the middle. (The largest of all is none: at the bonded corner it grows without bound
    /// as the mesh gets finer.)
    pub max_stretch: Option<f64>,
}

impl Response {
    /// The larger of the stretch in the middle and of that below which 99 % of the rubber lies.
    pub fn rubber_stretch(&self) -> Option<f64> {
        self.middle_stretch
            .into_iter()
            .chain(self.max_stretch)
            .reduce(f64::max)
    }

    /// That of a muscle that hangs at its free contraction: it does not pull, and slopes of a
    /// muscle that is held there do not apply.
    #[must_use]
    pub fn hanging(self) -> Self {
        Self {
            force_n: 0.0,
            volume_per_pressure_mm3_per_mpa: None,
            volume_per_contraction_mm3: None,
            stiffness_n_per_mm: None,
            force_per_pressure_mm2: None,
            ..self
        }
    }

    /// Fills in the tension of one strand from that of all, where the number of strands is known.
    pub(crate) fn with_braid_tension(mut self, tension_n: f64, muscle: &Muscle) -> Self {
        self.braid_tension_n = Some(tension_n);
        self.strand_tension_n = muscle
            .braid()
            .strands
            .map(|s| tension_n / f64::from(s.count));
        self
    }

    /// The response, or [`ModelError::NotFinite`] where its force is none (a pressure that is not a
    /// number).
    pub(crate) fn finite(self, model: &str) -> Result<Self> {
        ModelError::finite(self.force_n, model, self.pressure_mpa, self.contraction).map(|_| self)
    }
}
