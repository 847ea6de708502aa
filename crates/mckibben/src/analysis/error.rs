//! Why a question about a model has no answer.

use crate::model::ModelError;
use crate::status::Status;
use thiserror::Error;

/// Why a question about a model has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum AnalysisError {
    /// The model itself has none.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// No pressure gives this pull at this contraction.
    #[error(
        "no pressure gives {force_n} N at a contraction of {contraction}; the nearest the {model} model reaches is {nearest_force_n:.4} N at {nearest_pressure_mpa:.6} MPa"
    )]
    NoPressure {
        /// The model's name.
        model: String,
        /// The pull wanted, in N.
        force_n: f64,
        /// At this contraction.
        contraction: f64,
        /// The nearest pull there is, in N.
        nearest_force_n: f64,
        /// The pressure it needs, in MPa.
        nearest_pressure_mpa: f64,
    },
    /// No contraction gives this pull at this pressure.
    #[error(
        "no contraction gives {force_n} N at {pressure_mpa} MPa; the nearest the {model} model reaches is {nearest_force_n:.4} N at a contraction of {nearest_contraction:.6}"
    )]
    NoContraction {
        /// The model's name.
        model: String,
        /// The pull wanted, in N.
        force_n: f64,
        /// At this pressure in MPa.
        pressure_mpa: f64,
        /// The nearest pull there is, in N.
        nearest_force_n: f64,
        /// The contraction it has.
        nearest_contraction: f64,
    },
    /// The model does not know a quantity that the question needs.
    #[error("the {model} model does not give {quantity}")]
    Unknown {
        /// The model's name.
        model: String,
        /// What is missing.
        quantity: &'static str,
    },
}

impl From<&ModelError> for Status {
    fn from(error: &ModelError) -> Self {
        match error {
            ModelError::OutOfRange { .. } => Self::OutOfRange,
            ModelError::NotConverged { .. } => Self::NotConverged,
            ModelError::Stopped { status, .. } => *status,
            _ => Self::NoAnswer,
        }
    }
}

impl From<&AnalysisError> for Status {
    fn from(error: &AnalysisError) -> Self {
        match error {
            AnalysisError::Model(error) => error.into(),
            _ => Self::NoAnswer,
        }
    }
}
