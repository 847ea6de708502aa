//! The deficit of an end as data: a form and its terms. `model/universal/form.rs` says what the variables are.

/// What a correction is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// The membrane's end with a correction for the wall.
    Membrane,
    /// A polynomial in the bulge, for hand calculation.
    Bulge,
}

impl Form {
    /// Both.
    pub const ALL: [Form; 2] = [Form::Membrane, Form::Bulge];

    /// Its word in files.
    pub fn name(self) -> &'static str {
        match self {
            Form::Membrane => "membrane",
            Form::Bulge => "bulge",
        }
    }

    /// Words of its variables in files.
    pub fn variables(self) -> [&'static str; 5] {
        match self {
            Form::Membrane => ["wall", "angle", "slope", "modulus", "strain"],
            Form::Bulge => ["wall", "angle", "bulge", "modulus", "shortening"],
        }
    }

    /// Their letters.
    pub fn letters(self) -> [&'static str; 5] {
        match self {
            Form::Membrane => ["S", "A", "N", "M", "E"],
            Form::Bulge => ["S", "A", "B", "M", "L"],
        }
    }
}

/// One term of a form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UniversalTerm {
    /// Powers of the form's five variables.
    pub powers: [u8; 5],
    /// Its coefficient.
    pub value: f64,
}

/// A form with its coefficients.
#[derive(Debug, Clone, PartialEq)]
pub struct Deficit {
    /// Which.
    pub form: Form,
    /// The terms; none: the membrane alone, or no deficit.
    pub terms: Vec<UniversalTerm>,
}

/// Highest power of a variable.
pub(crate) const HIGHEST: u8 = 6;
