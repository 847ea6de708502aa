//! A word, or a quantity: `"antonelli2018"` or `"321 N/mm"`.

use super::{
    dimension::Dimension,
    nearest::{meant, nearest},
    quantity::{QuantityError, parse_quantity},
    typed::text_or_number,
};
use serde::Deserializer;
use std::fmt;

/// The words for values of a type that is a quantity else.
pub struct Words<T: 'static> {
    /// Each word and its value.
    pub words: &'static [(&'static str, T)],
    /// What the quantity measures.
    pub dimension: Dimension,
    /// The value of a quantity, in the unit inside.
    pub quantity: fn(f64) -> T,
}

impl<T: Copy> Words<T> {
    /// The value of a text.
    pub fn parse(&self, text: &str) -> Result<T, QuantityError> {
        let text = text.trim();
        if let Some((_, value)) = self.words.iter().find(|(word, _)| *word == text) {
            return Ok(*value);
        }
        if text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
            return parse_quantity(text, self.dimension).map(self.quantity);
        }
        let near = meant(nearest(text, self.words.iter().map(|(word, _)| *word)));
        Err(QuantityError::about(
            text,
            format!("is not known{near}; expected {self}"),
        ))
    }

    /// Reads a text, or a number in the unit inside.
    pub fn read<'de, D: Deserializer<'de>>(&self, from: D) -> Result<T, D::Error> {
        text_or_number(self, |text| self.parse(text), self.quantity, from)
    }
}

/// What may be written, for messages.
impl<T> fmt::Display for Words<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (word, _) in self.words {
            write!(f, "\"{word}\", ")?;
        }
        write!(f, "or {}", self.dimension.expectation())
    }
}
