//! What a universal formula says of an end: its form and the terms of it.
//! [`crate::model::Universal`] computes with them.

use crate::formula::Term;
use serde::{Deserialize, Serialize};

/// What a correction is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// The membrane's end with a correction for the wall.
    Membrane,
    /// A polynomial in the bulge, for hand calculation.
    Bulge,
}

impl Form {
    /// Highest power of a variable.
    pub const HIGHEST: u8 = 6;

    /// Letters of its variables.
    pub fn letters(self) -> [&'static str; 5] {
        match self {
            Form::Membrane => ["S", "A", "N", "M", "E"],
            Form::Bulge => ["S", "A", "B", "M", "L"],
        }
    }
}

mckibben_units::display_as_serde_word!(Form);

/// One term of a form, in its five variables.
pub type UniversalTerm = Term<5>;

/// A form with its coefficients.
#[derive(Debug, Clone, PartialEq)]
pub struct Deficit {
    /// Which.
    pub form: Form,
    /// The terms; none: the membrane alone, or no deficit.
    pub terms: Vec<UniversalTerm>,
}
