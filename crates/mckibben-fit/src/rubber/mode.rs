//! The tests: uniaxial, planar, equibiaxial and general biaxial tension of incompressible rubber in plane stress.
//!
//!   uniaxial     λ1 = λ, λ2 = λ3 = λ^(−1/2)
//!   planar       λ1 = λ, λ2 = 1, λ3 = 1/λ         (wide strip; "pure shear")
//!   equibiaxial  λ1 = λ2 = λ, λ3 = λ⁻²
//!   general      λ1, λ2 as measured, λ3 = 1/(λ1 λ2)   (sheet pulled along both sides)
//!
//! Nominal stress (force over the area at rest) P = dŵ/dλ, in the equibiaxial test half of it (L. R. G. Treloar, The
//! Physics of Rubber Elasticity, 1975 \[treloar1975\], ch. 5). True stress σ = λ P in all of them. λ < 1 is compression.

use mckibben::rubber::RubberLaw;
use serde::{Deserialize, Serialize};

/// How a specimen is stretched.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "lowercase")]
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
    /// A sheet pulled along two axes, each by its own stretch.
    General,
}

impl Mode {
    pub const ALL: [Mode; 4] = [Mode::Uniaxial, Mode::Planar, Mode::Equibiaxial, Mode::General];
    /// Those in which one stretch says all.
    pub const OF_ONE_STRETCH: [Mode; 3] = [Mode::Uniaxial, Mode::Planar, Mode::Equibiaxial];
    pub const WORDS: &'static str = "uniaxial, planar (or pure shear), equibiaxial (or biaxial), general";

    pub fn name(self) -> &'static str {
        match self {
            Mode::Uniaxial => "uniaxial",
            Mode::Planar => "planar",
            Mode::Equibiaxial => "equibiaxial",
            Mode::General => "general",
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
            "general" | "generalbiaxial" | "generalbiaxialtension" | "bt" => Some(Mode::General),
            _ => None,
        }
    }

    /// λ2 for λ1; `None` in a general test, where it is measured.
    pub fn across(self, stretch: f64) -> Option<f64> {
        match self {
            Mode::Uniaxial => Some(stretch.powf(-0.5)),
            Mode::Planar => Some(1.0),
            Mode::Equibiaxial => Some(stretch),
            Mode::General => None,
        }
    }

    /// Nominal stress of a law, in MPa; `None` in a general test, where one stretch does not say it.
    pub fn nominal_stress_mpa<L: RubberLaw + ?Sized>(self, law: &L, stretch: f64) -> Option<f64> {
        match self {
            Mode::Uniaxial => Some(law.uniaxial_stress_mpa(stretch)),
            Mode::Planar => Some(law.planar_stress_mpa(stretch)),
            Mode::Equibiaxial => Some(law.equibiaxial_stress_mpa(stretch)),
            Mode::General => None,
        }
    }
}

impl std::fmt::Display for Mode {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
