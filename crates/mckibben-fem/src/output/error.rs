//! Why a step is not written.

use thiserror::Error;

/// A number that is none.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{file} is not written: its {name} contains a value that is not a finite number")]
pub struct VtuError {
    /// The file that would hold it.
    pub file: String,
    /// The data.
    pub name: &'static str,
}
