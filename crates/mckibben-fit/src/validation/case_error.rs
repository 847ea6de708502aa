//! Why a folder is no case.

use crate::identify::ParameterError;
use mckibben_io::table::TableError;
use thiserror::Error;

/// Why a folder is no case.
#[derive(Debug, Error)]
pub enum CaseError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// A parameter that the muscle does not have.
    #[error("{case}/case.toml, fit \"{fit}\": {error}")]
    Parameter {
        /// Folder.
        case: String,
        /// Fit.
        fit: String,
        /// Why.
        error: ParameterError,
    },
    /// Points that cannot be read.
    #[error("{case}/points.csv: {error}")]
    Points {
        /// Folder.
        case: String,
        /// Why.
        error: TableError,
    },
}
