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
    Data(
        #[doc(hidden)]
        #[from]
        DataError,
    ),
    /// Data that no muscle of this size gives.
    #[error("{0}")]
    Implausible(String),
    /// A column with the wrong sign.
    #[error("{0}")]
    Flipped(String),
    /// Starting values that make no muscle.
    #[error("the starting values give no valid muscle: {0}")]
    Muscle(#[from] MuscleError),
    /// The starting values give no valid model.
    #[error("the starting values give no valid model: {0}")]
    Model(ModelError),
    /// No minimum.
    #[error("{0}; fix what the data cannot determine")]
    Estimate(#[doc(hidden)] EstimateError),
}

/// Why data cannot be fitted.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DataError {
    /// No point that tells a pull.
    #[error("there is no point with a pull{}", left_out(*.slack))]
    NoPull {
        /// Points that were left out because the muscle was slack.
        slack: usize,
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
}

fn left_out(dropped: usize) -> String {
    match dropped {
        0 => String::new(),
        n => format!(" ({n} more points without a measured force were left out)"),
    }
}
