//! Why a muscle does not fit.

use crate::{Check, Show};
use mckibben_core::{model::ModelError, muscle::Muscle};
use serde::Serialize;

/// The bound that a muscle breaks.
#[derive(Debug, Clone, PartialEq)]
pub enum Reason {
    /// A limit is missed.
    Limit(Check),
    /// The model has no answer.
    Model(ModelError),
}

impl Reason {
    /// The sentence, with pressures, forces and lengths written by `show` ("2.5 bar", "700 N", "30
    /// mm").
    pub fn describe(&self, show: Show<'_>) -> String {
        match self {
            Self::Limit(check) => check.describe(show),
            Self::Model(error) => error.to_string(),
        }
    }

    /// The limit that is missed; `None` where there is no answer at all.
    pub fn check(&self) -> Option<&Check> {
        if let Self::Limit(check) = self {
            Some(check)
        } else {
            None
        }
    }
}

/// A muscle that does not fit, and why.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Rejected {
    /// Outer diameter D0, mm.
    pub outer_diameter_mm: f64,
    /// Wall s, mm.
    pub wall_mm: f64,
    /// Length L0, mm.
    pub length_mm: f64,
    /// Braid angle θ0, degrees.
    pub angle_deg: f64,
    /// Name of the rubber, where it has one.
    pub rubber: Option<String>,
    /// Name of the sleeve, where it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sleeve: Option<String>,
    /// The shares by which it misses its limits, summed; none where the model has no answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub misses_by: Option<f64>,
    /// The bound it breaks by most.
    #[serde(skip)]
    pub reason: Reason,
    #[serde(skip)]
    pub muscle: Muscle,
}

impl Rejected {
    pub(super) fn new(muscle: Muscle, reason: Reason, misses_by: Option<f64>) -> Self {
        Self {
            outer_diameter_mm: muscle.outer_diameter_mm(),
            wall_mm: muscle.wall_mm(),
            length_mm: muscle.length_mm(),
            angle_deg: muscle.braid().angle_deg,
            rubber: muscle.tube().rubber.name.clone(),
            sleeve: muscle.braid().sleeve.as_ref().map(|s| s.name.clone()),
            misses_by,
            reason,
            muscle,
        }
    }
}
