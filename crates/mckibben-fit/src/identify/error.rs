//! Why nothing was identified.

use crate::least_squares::EstimateError;
use mckibben_core::{cancel::Cancelled, model::ModelError, muscle::MuscleError};
use thiserror::Error;

pub type Result<T, E = IdentifyError> = std::result::Result<T, E>;

/// Why nothing was identified. Lines are those of the data file.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum IdentifyError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// The caller wanted it to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Data that cannot be fitted.
    #[error(transparent)]
    Data(#[from] DataError),
    /// Data that no muscle of this size gives.
    #[error("{0}")]
    Implausible(String),
    /// A column with the wrong sign.
    #[error("{0}")]
    Flipped(String),
    /// Points that no rubber explains.
    #[error(
        "no constants were found: {0}, which no rubber has. The measured pull is higher, or \
         decreases less with contraction, than that of this muscle with any rubber"
    )]
    NoRubber(String),
    /// The model fails at the start.
    #[error("the model has no answer for {0}: {1}")]
    Start(String, ModelError),
    /// Starting values that make no muscle.
    #[error("the starting values give no valid muscle: {0}")]
    Muscle(#[from] MuscleError),
    /// The starting values give no valid model.
    #[error("the starting values give no valid model: {0}")]
    Model(ModelError),
    /// No minimum.
    #[error(
        "{0}; give better starts (name=START) or bounds (name=START:LOW:HIGH), or fix what the \
         data cannot determine"
    )]
    Estimate(EstimateError),
}

/// Why data cannot be fitted.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DataError {
    /// Not more points than parameters.
    #[error(
        "{points} points that pull{} do not determine {parameters} parameters: at least {} are \
         needed, and three for each parameter for a meaningful error bar; measure more, or free \
         fewer",
        left_out(*.dropped), .parameters + 1
    )]
    TooFew {
        /// Points that count.
        points: usize,
        /// Those left out because the muscle was slack.
        dropped: usize,
        /// Free parameters.
        parameters: usize,
    },
    /// A number that no muscle gives.
    #[error("line {line}: the {quantity} is {value}, which no muscle has; check number and unit")]
    Impossible {
        /// Line of the point.
        line: u64,
        /// Which of its numbers.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// Errors stated for some points only.
    #[error(
        "{stated} of {all} points state their error (first without: line {line}): state the errors \
         of all points, or of none"
    )]
    SomeErrors {
        /// Points that state their error.
        stated: usize,
        /// All points.
        all: usize,
        /// Line of the first without.
        line: u64,
    },
}

fn left_out(dropped: usize) -> String {
    match dropped {
        0 => String::new(),
        n => format!(" ({n} more points without a measured force were left out)"),
    }
}
