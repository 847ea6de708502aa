//! How wrong a formula is, as its file says it. Shares are of the muscle's blocked force at the
//! highest pressure of the table.

use super::file::check::share;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Errors over points where the muscle pulls.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct ErrorSummary {
    /// How many points.
    pub points: usize,
    /// Root mean square as a share of the blocked force.
    #[serde(rename = "rms_of_blocked", deserialize_with = "share")]
    pub rms: f64,
    /// The share that 95 % of the points do not exceed.
    #[serde(rename = "p95_of_blocked", deserialize_with = "share")]
    pub p95: f64,
    /// Largest share.
    #[serde(rename = "max_of_blocked", deserialize_with = "share")]
    pub max: f64,
    /// Largest difference, N.
    #[serde(deserialize_with = "share")]
    pub max_n: f64,
    /// Largest by the paper's (12): share of the largest force of the same isobaric curve.
    #[serde(rename = "max_of_isobar", deserialize_with = "share")]
    pub max_12: f64,
}

/// Errors where one quantity has one value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct RegionErrors {
    /// `outer_diameter_mm`, `wall_mm`, `pressure_mpa` or `contraction`.
    pub quantity: String,
    /// Its value.
    pub value: f64,
    /// The errors there.
    #[serde(flatten)]
    pub errors: ErrorSummary,
}

/// Errors on muscles that the fit did not see.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct HeldOut {
    /// Their diameters in mm, where they were chosen by these.
    pub outer_diameters_mm: Vec<f64>,
    /// The errors there.
    #[serde(flatten)]
    pub errors: ErrorSummary,
}

/// Everything a formula's file says of its errors.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct FormulaErrors {
    /// Against what, in words.
    pub against: String,
    /// Over all points it was fitted to.
    pub fit: ErrorSummary,
    /// Over muscles it was not fitted to, where there are any.
    pub held_out: Option<HeldOut>,
    /// By regions.
    pub regions: Vec<RegionErrors>,
}

impl FormulaErrors {
    /// The half-width that 95 % of the points stay within, as a share of the blocked force at the
    /// highest pressure: the larger of fit and held-out muscles.
    pub fn half_width(&self) -> f64 {
        self.held_out
            .as_ref()
            .map_or(self.fit.p95, |h| self.fit.p95.max(h.errors.p95))
    }
}
