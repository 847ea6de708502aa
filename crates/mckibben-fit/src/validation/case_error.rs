//! Why a folder is no case.

use crate::identify::ParameterError;
use mckibben::muscle::file::FileError;
use mckibben_io::table::TableError;
use thiserror::Error;

/// Why a folder is no case.
#[derive(Debug, Error)]
pub enum CaseError {
    /// No TOML.
    #[error("{case}/case.toml: not valid TOML: {message}")]
    Syntax {
        /// Folder.
        case: String,
        /// What the parser says.
        message: String,
    },
    /// A key that is missing or of another kind.
    #[error("{case}/case.toml: `{key}` must be {expected}")]
    Key {
        /// Folder.
        case: String,
        /// Key.
        key: String,
        /// What should stand there.
        expected: &'static str,
    },
    /// A key that means nothing.
    #[error("{case}/case.toml: `{key}` is not known; known here: {}", .known.join(", "))]
    Unknown {
        /// Folder.
        case: String,
        /// Key.
        key: String,
        /// What may stand there.
        known: &'static [&'static str],
    },
    /// A muscle that cannot be read.
    #[error("{case}/muscle.toml, fit \"{fit}\": {error}")]
    Muscle {
        /// Folder.
        case: String,
        /// Fit.
        fit: String,
        /// Why.
        error: Box<FileError>,
    },
    /// An identified muscle that cannot be read.
    #[error("{case}/identified.toml: {error}")]
    Identified {
        /// Folder.
        case: String,
        /// Why.
        error: Box<FileError>,
    },
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
    /// A law that a fit of a rubber does not have.
    #[error("{case}/case.toml, fit \"{fit}\": there is no law \"{law}\"; known: {}", .known.join(", "))]
    Law {
        /// Folder.
        case: String,
        /// Fit.
        fit: String,
        /// As written.
        law: String,
        /// What may stand there.
        known: Vec<String>,
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
