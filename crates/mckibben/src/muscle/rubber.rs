//! The rubber of a tube: a law, its bulk behaviour, and where the constants come from.

use super::error::{MuscleError, positive};
use crate::rubber::{Law, MooneyRivlin};

/// How a rubber answers to a change of volume.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bulk {
    /// Volume stays.
    Incompressible,
    /// Bulk modulus in MPa.
    Modulus(f64),
}

/// A rubber with its origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Rubber {
    /// Name in the library of rubbers (`paper`, `dragon-skin-30`), where it has one.
    pub name: Option<String>,
    /// The law and its constants.
    pub law: Law,
    /// Incompressible, or a bulk modulus. The closed-form models take every rubber as incompressible.
    pub bulk: Bulk,
    /// Largest stretch of the data the constants were fitted to, where it is known.
    pub fitted_to_stretch: Option<f64>,
}

impl Rubber {
    /// The rubber `paper`: Mooney–Rivlin C10 0.112 MPa, C01 0, incompressible. Identified with axisymmetric finite elements from
    /// the paper's Table 1 and formula (11) (`docs/identify/paper.md`).
    pub fn paper() -> Self {
        Self {
            name: Some("paper".into()),
            law: Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.112, c01_mpa: 0.0 }),
            bulk: Bulk::Incompressible,
            fitted_to_stretch: None,
        }
    }

    /// An unnamed incompressible rubber.
    pub fn of(law: Law) -> Self {
        Self { name: None, law, bulk: Bulk::Incompressible, fitted_to_stretch: None }
    }

    /// Whether this is the paper's rubber, unchanged.
    pub fn is_paper(&self) -> bool {
        self.law == Self::paper().law && self.bulk == Bulk::Incompressible
    }

    pub(super) fn check(&self) -> Result<(), MuscleError> {
        self.law.clone().validated()?;
        match self.bulk {
            Bulk::Incompressible => Ok(()),
            Bulk::Modulus(k) => positive("tube.material.bulk_modulus", k, "MPa"),
        }
    }
}
