//! Formulas as data: fitted force formulas that are files. [`crate::model::FormulaModel`] and
//! [`crate::model::Universal`] answer with them like any other model.
//!
//! A file says its terms, for which muscles they were made, over which range, how wrong they are,
//! and where they come from. Two kinds:
//!
//!   paper    F = a ε² + b ε + c with the 48 numbers of the paper's (11)
//!   global   F = D0² Σ c · xᵃ pᵇ eᶜ dᵈ,   x = s/D0, p = P, e = ε, d = D0, each divided by its scale
//!
//! F in N, P in MPa, lengths in mm. A third kind, `universal`, is for muscles of every make: it
//! holds the terms of the end deficit of [`crate::model::Universal`], over a dimensionless range
//! ([`UniversalFormula`]). [`Document`] is any of them.

mod error;
mod errors;
mod file;
mod made;
mod paper;
mod show;
mod terms;
mod universal;

pub use error::FormulaError;
pub use errors::{ErrorSummary, FormulaErrors, HeldOut, RegionErrors};
pub use file::powers;
pub(crate) use made::alike;
pub use made::{Made, MadeBraid, MadeRubber, MadeStrands, NamedBraid};
pub use paper::{Coefficients, Section};
pub use terms::{GlobalSection, GlobalTerms, Scales, Term, paper_terms};
pub use universal::{
    UniversalErrors, UniversalFormula, UniversalRange, UniversalSummary, UniversalTerm,
};

use file::{File, check::interval};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The terms of a formula.
#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// The paper's (11).
    Paper(Box<Coefficients>),
    /// A sum of products of powers.
    Global(GlobalTerms),
}

/// Where a formula was fitted; both ends belong to it.
#[serde_with_macros::apply(crate = "serde_with_macros", (f64, f64) => #[serde(deserialize_with = "interval")])]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(expecting = "an object")]
pub struct FormulaRange {
    /// D0 in mm.
    pub outer_diameter_mm: (f64, f64),
    /// s in mm.
    pub wall_mm: (f64, f64),
    /// P in MPa.
    pub pressure_mpa: (f64, f64),
    /// ε
    pub contraction: (f64, f64),
}

/// Where a formula comes from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(expecting = "an object")]
pub struct Provenance {
    /// The program that made it.
    #[serde(default)]
    pub program: String,
    /// Version of the program that made it.
    pub version: String,
    /// The method with its rules, in words.
    pub method: String,
    /// Points it was fitted to.
    pub points: usize,
    /// Hash of these points.
    pub data_hash: String,
    /// Name of the table, where it had one.
    pub table: Option<String>,
    /// Hash of the campaign's plan, where it is known.
    pub plan_hash: Option<String>,
    /// Seed of the plan, where it has one.
    pub seed: Option<u64>,
}

impl Default for Provenance {
    /// By this version of this program, from nothing yet.
    fn default() -> Self {
        Self {
            program: "mckibben".into(),
            version: env!("CARGO_PKG_VERSION").into(),
            method: String::new(),
            points: 0,
            data_hash: String::new(),
            table: None,
            plan_hash: None,
            seed: None,
        }
    }
}

/// A formula with its data; it is written as its file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(into = "File")]
pub struct Formula {
    /// Its name, which answers carry.
    pub name: String,
    /// Its terms.
    pub body: Body,
    /// The muscles it was made for.
    pub made_for: Made,
    /// Where it was fitted.
    pub range: FormulaRange,
    /// How wrong it is.
    pub errors: FormulaErrors,
    /// Where it comes from.
    pub provenance: Provenance,
}

/// The longest file of a formula in bytes.
pub const MAX_BYTES: u64 = 4 << 20;

/// What a formula's file holds.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Document {
    /// A formula for muscles of one make.
    Section(Box<Formula>),
    /// A formula for muscles of every make.
    Universal(Box<UniversalFormula>),
}

/// The text of a formula's file.
pub fn read_text(path: &Path) -> Result<String, FormulaError> {
    let bytes =
        mckibben_units::read(path, MAX_BYTES).map_err(|e| FormulaError::new(e.to_string()))?;
    String::from_utf8(bytes).map_err(FormulaError::json)
}

impl Formula {
    /// F in N, two-sided; does not look at the range.
    pub fn force_n(
        &self,
        outer_diameter_mm: f64,
        wall_mm: f64,
        pressure_mpa: f64,
        contraction: f64,
    ) -> f64 {
        match &self.body {
            Body::Paper(c) => c
                .section(outer_diameter_mm, wall_mm)
                .force_n(pressure_mpa, contraction),
            Body::Global(t) => t
                .section(outer_diameter_mm, wall_mm)
                .force_and_slopes(pressure_mpa, contraction)[0],
        }
    }
}

#[cfg(test)]
mod tests;
