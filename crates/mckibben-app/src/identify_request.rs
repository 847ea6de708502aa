//! What `identify` is asked for.

use crate::fields::{Columns, ModelFields, MuscleFields, TextFile};
use crate::units::Units;
use mckibben_fit::least_squares::Loss;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Points, and the parameters of a muscle to identify from them.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct IdentifyRequest {
    /// The muscle, with a value for everything that is not free.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// The model.
    #[serde(flatten)]
    pub model: ModelFields,
    /// Tables of pressures, contractions (or shortenings, or lengths) and pulls, with their units, and more.
    pub data: Vec<TextFile>,
    /// Columns of `data` whose heading does not say what they are: quantity to "heading:unit".
    pub columns: Columns,
    /// A published formula as data: the name of a model, or of one of `formulas`.
    pub formula: Option<String>,
    /// Pressures P of `formula` in MPa; default 0.05 to 0.25 by 0.05.
    pub pressures_mpa: Option<Vec<f64>>,
    /// Contraction ratios ε of `formula`; default 0 to 0.2 by 0.05.
    pub contractions: Option<Vec<f64>>,
    /// Outer diameters D0 of `formula` in mm; default that of the muscle.
    pub outer_diameters_mm: Option<Vec<f64>>,
    /// Walls s of `formula` in mm; default that of the muscle.
    pub walls_mm: Option<Vec<f64>>,
    /// Weight of each of `data`, then of `formula`; default 1.
    pub weights: Vec<f64>,
    /// Treatment of the branches of the hysteresis.
    pub branches: Branches,
    /// Use points with a force of zero or below as measurements; by default the muscle counts as slack there.
    pub two_sided: bool,
    /// Free parameters: NAME, NAME=START or NAME=START:LOW:HIGH. Default: the modulus, and stiffness and friction
    /// if the data determine them.
    pub free: Vec<String>,
    /// Fix a parameter: NAME=VALUE.
    pub fix: Vec<String>,
    /// Bounds of free parameters: NAME=LOW:HIGH.
    pub bounds: Vec<String>,
    /// Loss function of the residuals.
    pub loss: Loss,
    /// Fit every rubber law, with all its constants free, together with the other free parameters.
    pub laws: bool,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}

/// Treatment of the branches of the hysteresis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Branches {
    /// Both branches, with the friction between them.
    #[default]
    Both,
    /// Mean of the branches.
    Mean,
    /// The rows of `data` are in time order: the friction builds up again after each reversal.
    History,
}
