//! Why there is no such rubber.

use thiserror::Error;

/// Why there is no such rubber.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{0}")]
pub struct LibraryError(pub(super) String);

impl LibraryError {
    /// The built-in table cannot be read.
    pub fn damaged(what: impl std::fmt::Display) -> Self {
        Self(format!("the built-in table of rubbers is damaged: {what}"))
    }
}
