//! A rubber of the library.

use super::window::Window;
use crate::rubber::Law;
use serde::{Deserialize, Serialize};

/// A rubber of the library.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct RubberEntry {
    /// Name, in kebab-case, such as `dragon-skin-30`.
    pub name: String,
    /// Other names it answers to.
    #[serde(default, skip_serializing)]
    #[schemars(skip)]
    pub aliases: Vec<String>,
    /// What it is, for people.
    pub title: String,
    /// Where the data come from.
    pub source: String,
    /// Terms under which the data may be used.
    #[serde(skip_deserializing)]
    pub terms: String,
    /// What else one should know.
    pub note: Option<String>,
    /// Factor within which its stiffness is known; 1 where a measured curve is behind it.
    #[serde(default = "one", skip_serializing)]
    #[schemars(skip)]
    pub factor: f64,
    /// Density in kg/m³, where it is known.
    #[serde(skip_serializing)]
    #[schemars(skip)]
    pub density_kg_per_m3: Option<f64>,
    /// Largest engineering strain of the test (failure, for the silicones).
    pub max_strain: Option<f64>,
    /// Nominal stress there, MPa.
    pub max_stress_mpa: Option<f64>,
    /// The laws fitted to it as they are published. Of a rubber with a curve they are for
    /// comparison.
    #[serde(skip_serializing)]
    #[schemars(skip)]
    pub fits: Vec<RubberFit>,
    /// Its measured curve, a path in `data/` of the repository, or
    /// [`TABLE_OF_FITS`](super::TABLE_OF_FITS).
    pub data: Option<String>,
    /// The laws fitted to that curve, from the smallest range of stretches to the widest.
    #[serde(skip)]
    pub windows: Vec<Window>,
    /// The law of these ranges that the name alone means; none without a curve.
    #[serde(skip)]
    pub usual_law: Option<String>,
}

fn one() -> f64 {
    1.0
}

/// A published law of a rubber.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct RubberFit {
    /// The law with its constants.
    #[serde(flatten)]
    pub law: Law,
    /// Engineering strain up to which data were used.
    pub up_to_strain: Option<f64>,
    /// R² of the fit, where it is known.
    pub r_squared: Option<f64>,
}
