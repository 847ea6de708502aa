//! A value that is not allowed.

use thiserror::Error;

/// A value that is refused: the fields to blame, the likeliest first, and a sentence of field,
/// value and what it must be.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{message}")]
pub struct Refused {
    /// Keys of the file, or fields of the request.
    pub fields: Vec<&'static str>,
    /// Field, value, and what it must be.
    pub message: String,
}

impl Refused {
    /// A value that is refused.
    pub fn new(fields: impl IntoIterator<Item = &'static str>, message: impl Into<String>) -> Self {
        Self {
            fields: fields.into_iter().collect(),
            message: message.into(),
        }
    }

    /// Refuses fields unless something holds.
    pub fn unless(
        holds: bool,
        fields: impl IntoIterator<Item = &'static str>,
        message: impl FnOnce() -> String,
    ) -> Result<(), Self> {
        if holds {
            Ok(())
        } else {
            Err(Self::new(fields, message()))
        }
    }

    /// The same of a part of something else: its fields come last, and its name is before the
    /// sentence.
    pub(crate) fn within(mut self, part: &'static str) -> Self {
        self.fields.push(part);
        self.message = format!("{part}: {}", self.message);
        self
    }
}
