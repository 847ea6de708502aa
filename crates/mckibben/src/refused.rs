//! A value that is refused.

use thiserror::Error;

/// A value that is refused: the fields to blame, the likeliest first, and a sentence of field, value and what it must be.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{message}")]
pub struct Refused {
    /// Keys of the file, or fields of the request.
    pub fields: Vec<&'static str>,
    /// Field, value, and what it must be.
    pub message: String,
}
