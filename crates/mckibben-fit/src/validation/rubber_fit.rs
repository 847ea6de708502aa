//! A fit of a measured rubber, and what it leaves.

use crate::rubber::{Form, Mode, Parameter};
use serde::Serialize;

/// A law, and which points it is fitted to.
#[derive(Debug, Clone, PartialEq)]
pub struct RubberCaseFit {
    pub name: String,
    pub form: Form,
    /// Modes that are fitted, all where none is named; the others are blind.
    pub modes: Vec<Mode>,
    /// Stretch up to which it is fitted; what is stretched further is blind.
    pub up_to_stretch: Option<f64>,
    /// Branches of a Prony series beside it, of a test over time.
    pub relaxation: Option<usize>,
}

/// A fit, and what it leaves.
#[derive(Debug, Clone, Default)]
pub struct RubberFitResult {
    pub case: usize,
    pub fit: usize,
    /// Constants found; with a Prony series those at once.
    pub parameters: Vec<Parameter>,
    /// gᵢ and τᵢ in s.
    pub prony: Vec<(f64, f64)>,
    /// Whether the law is stable in a muscle.
    pub stable: bool,
    /// What is left, group by group: fitted points before those that are predicted.
    pub groups: Vec<RubberGroup>,
}

/// What is left of some nominal stresses: measured less computed.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct RubberGroup {
    /// The points that are compared: a mode, a mode `further` than the law was fitted, or a branch of a test over time.
    pub of: String,
    /// Whether nothing was fitted to them.
    pub blind: bool,
    /// How many.
    pub points: usize,
    /// Their largest stretch.
    pub to_stretch: f64,
    /// Root mean square of the differences in MPa.
    pub rms_mpa: f64,
    /// The same over the root mean square of the measured stresses.
    pub relative: f64,
    /// Mean of measured − computed in MPa.
    pub bias_mpa: f64,
    /// Largest difference in MPa.
    pub largest_mpa: f64,
}
