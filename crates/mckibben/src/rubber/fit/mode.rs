//! The three tests: uniaxial, planar and equibiaxial tension of incompressible rubber.
//!
//!   uniaxial     λ1 = λ, λ2 = λ3 = λ^(−1/2)
//!   planar       λ1 = λ, λ2 = 1, λ3 = 1/λ         (wide strip; "pure shear")
//!   equibiaxial  λ1 = λ2 = λ, λ3 = λ⁻²
//!
//! Nominal stress (force over the area at rest) P = dŵ/dλ, in the equibiaxial test half of it (L. R. G. Treloar, The
//! Physics of Rubber Elasticity, 1975 \[treloar1975\], ch. 5). True stress σ = λ P in all three. λ < 1 is compression.

use crate::rubber::RubberLaw;
use serde::{Deserialize, Serialize};

/// How a specimen is stretched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Mode {
    /// A narrow strip or dumb-bell, pulled along one axis.
    #[default]
    Uniaxial,
    /// A wide, short strip whose width cannot change ("pure shear").
    #[serde(alias = "pure-shear")]
    Planar,
    /// A sheet pulled alike along two axes, or a balloon.
    #[serde(alias = "biaxial")]
    Equibiaxial,
}

impl Mode {
    /// All of them.
    pub const ALL: [Mode; 3] = [Mode::Uniaxial, Mode::Planar, Mode::Equibiaxial];
    /// What is understood.
    pub const WORDS: &'static str = "uniaxial, planar (or pure shear), equibiaxial (or biaxial)";

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Mode::Uniaxial => "uniaxial",
            Mode::Planar => "planar",
            Mode::Equibiaxial => "equibiaxial",
        }
    }

    /// From a word, without regard to case, hyphens, underscores and spaces.
    pub fn parse(word: &str) -> Option<Self> {
        let plain: String = word.chars().filter(|c| c.is_alphanumeric()).collect();
        match plain.to_lowercase().as_str() {
            "uniaxial" | "uniaxialtension" | "simpletension" | "tension" | "tensile" | "ut" => {
                Some(Mode::Uniaxial)
            }
            "planar" | "planartension" | "pureshear" | "constrainedtension" | "pt" | "ps" => {
                Some(Mode::Planar)
            }
            "equibiaxial" | "equibiaxialtension" | "biaxial" | "biaxialtension" | "et" | "eb" => {
                Some(Mode::Equibiaxial)
            }
            _ => None,
        }
    }

    /// λ1 and λ2.
    pub fn stretches(self, stretch: f64) -> (f64, f64) {
        match self {
            Mode::Uniaxial => (stretch, stretch.powf(-0.5)),
            Mode::Planar => (stretch, 1.0),
            Mode::Equibiaxial => (stretch, stretch),
        }
    }

    /// The largest of the three principal stretches.
    pub fn largest_stretch(self, stretch: f64) -> f64 {
        let (a, b) = self.stretches(stretch);
        a.max(b).max(1.0 / (a * b))
    }

    /// I1 − 3.
    pub fn i1_minus_3(self, stretch: f64) -> f64 {
        let (a, b) = self.stretches(stretch);
        a * a + b * b + 1.0 / (a * a * b * b) - 3.0
    }

    /// m in λ3 = λ^(−m).
    pub(super) fn thinning(self) -> f64 {
        match self {
            Mode::Uniaxial => 0.5,
            Mode::Planar => 1.0,
            Mode::Equibiaxial => 2.0,
        }
    }

    /// Nominal stress of a law, in MPa.
    pub fn nominal_stress_mpa<L: RubberLaw + ?Sized>(self, law: &L, stretch: f64) -> f64 {
        match self {
            Mode::Uniaxial => law.uniaxial_stress_mpa(stretch),
            Mode::Planar => law.planar_stress_mpa(stretch),
            Mode::Equibiaxial => law.equibiaxial_stress_mpa(stretch),
        }
    }
}

impl std::fmt::Display for Mode {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
