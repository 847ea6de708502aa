//! A measured point: two stretches in the plane of the specimen and one stress. A sheet with two
//! stresses is two points.
//!
//! With λ1 along the stress, λ2 across and λ3 = 1/(λ1 λ2) through the thickness, σ3 = 0 and wᵢ =
//! ∂w/∂λᵢ,
//!
//!   P1 = w1 − (λ3/λ1) w3,      σ1 − σ2 = λ1 w1 − λ2 w2.
//!
//! A difference of true stresses is kept as (σ1 − σ2)/max(λ1, λ2): the nominal stress along the
//! longer side of a specimen that is pulled with its thickness held, so that squares of it compare
//! with those of nominal stresses.

use mckibben_core::{
    extremes::peak,
    rubber::{MUSCLE_AXIAL_STRETCH, RubberLaw},
};
use serde::{Deserialize, Serialize};

/// How a specimen is stretched.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Default,
    Serialize,
    Deserialize,
    schemars::JsonSchema,
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
    /// A sheet pulled along two axes by different stretches.
    General,
}

impl Mode {
    /// Every mode.
    pub const ALL: [Mode; 4] = [
        Mode::Uniaxial,
        Mode::Planar,
        Mode::Equibiaxial,
        Mode::General,
    ];
    /// Those with one independent stretch.
    pub const OF_ONE_STRETCH: [Mode; 3] = [Mode::Uniaxial, Mode::Planar, Mode::Equibiaxial];
    /// The names for messages.
    pub const WORDS: &'static str =
        "uniaxial, planar (or pure shear), equibiaxial (or biaxial), general";
    /// The spellings of each, its name first.
    const SPELLINGS: [&'static [&'static str]; 4] = [
        &[
            "uniaxial",
            "uniaxialtension",
            "simpletension",
            "tension",
            "tensile",
            "ut",
        ],
        &[
            "planar",
            "planartension",
            "pureshear",
            "constrainedtension",
            "pt",
            "ps",
        ],
        &[
            "equibiaxial",
            "equibiaxialtension",
            "biaxial",
            "biaxialtension",
            "et",
            "eb",
        ],
        &["general", "generalbiaxial", "generalbiaxialtension", "bt"],
    ];

    /// As tables write it.
    pub fn name(self) -> &'static str {
        Self::SPELLINGS[self as usize][0]
    }

    /// From a word, without regard to case, hyphens, underscores and spaces.
    pub fn parse(word: &str) -> Option<Self> {
        let plain: String = word.chars().filter(|c| c.is_alphanumeric()).collect();
        let plain = plain.to_lowercase();
        Self::ALL
            .into_iter()
            .find(|mode| Self::SPELLINGS[*mode as usize].contains(&plain.as_str()))
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

    /// Nominal stress of a law, in MPa; `None` in a general test, which has two independent
    /// stretches.
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

/// One point of a test.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TensionPoint {
    /// How the specimen was stretched.
    pub mode: Mode,
    /// L/L0 along the stress.
    pub stretch: f64,
    /// L/L0 across it, in the plane of the specimen.
    pub across: f64,
    /// Force over the area at rest, in MPa; of a difference (σ1 − σ2)/max(λ1, λ2).
    pub nominal_stress_mpa: f64,
    /// Whether the stress is a difference of true stresses.
    #[serde(default)]
    pub difference: bool,
}

impl TensionPoint {
    /// A point of a mode with one independent stretch; in a general test a sheet that is not
    /// stretched across.
    pub fn new(mode: Mode, stretch: f64, nominal_stress_mpa: f64) -> Self {
        let across = mode.across(stretch).unwrap_or(1.0);
        Self {
            mode,
            ..Self::general(stretch, across, nominal_stress_mpa)
        }
    }

    /// A point of a sheet with one stretch along and one across the stress.
    pub fn general(stretch: f64, across: f64, nominal_stress_mpa: f64) -> Self {
        Self {
            mode: Mode::General,
            stretch,
            across,
            nominal_stress_mpa,
            difference: false,
        }
    }

    /// A point of a sheet of which σ1 − σ2 is known, in MPa.
    pub fn from_difference(stretch_1: f64, stretch_2: f64, true_difference_mpa: f64) -> Self {
        let nominal_stress_mpa = true_difference_mpa / stretch_1.max(stretch_2);
        Self {
            difference: true,
            ..Self::general(stretch_1, stretch_2, nominal_stress_mpa)
        }
    }

    /// λ1, λ2, λ3.
    pub fn stretches(&self) -> [f64; 3] {
        [
            self.stretch,
            self.across,
            1.0 / (self.stretch * self.across),
        ]
    }

    /// The largest of the three.
    pub fn largest_stretch(&self) -> f64 {
        peak(self.stretches())
    }

    /// The larger stretch in the plane; in a mode of one stretch that one.
    pub fn plane_stretch(&self) -> f64 {
        if self.mode == Mode::General {
            self.stretch.max(self.across)
        } else {
            self.stretch
        }
    }

    /// I1 − 3.
    pub fn i1_minus_3(&self) -> f64 {
        self.stretches().iter().map(|l| l * l).sum::<f64>() - 3.0
    }

    /// The stress of a law in place of the measured one, in MPa.
    pub fn stress_mpa<L: RubberLaw + ?Sized>(&self, law: &L) -> f64 {
        if let (Some(stress), false) = (
            self.mode.nominal_stress_mpa(law, self.stretch),
            self.difference,
        ) {
            return stress;
        }
        let [l1, l2, l3] = self.stretches();
        let p = law.principal([l1, l2, l3]);
        if self.difference {
            (l1 * p.d[0] - l2 * p.d[1]) / l1.max(l2)
        } else {
            p.d[0] - l3 / l1 * p.d[2]
        }
    }

    /// The reference of relative differences: the measured stress of a specimen of one stretch, if
    /// it pulls where that is longer than at rest; in a general test, where a stress may pass
    /// through zero, the larger of the two stresses that a neo-Hookean rubber of this modulus has
    /// in the same state.
    pub(super) fn reference_mpa(&self, modulus_mpa: f64) -> Option<f64> {
        if self.mode != Mode::General {
            let pulls = self.nominal_stress_mpa * (self.stretch - 1.0) > 0.0;
            return pulls.then_some(self.nominal_stress_mpa.abs());
        }
        let [l1, l2, l3] = self.stretches();
        let size = (l1 - l3 * l3 / l1).abs().max((l2 - l3 * l3 / l2).abs());
        (size > 0.0).then_some(modulus_mpa * size)
    }

    /// Whether a muscle's wall comes into this state: in some order of the axes the hoop stretch
    /// lies between 1 and `hoop`, the axial one between 0.6 and 1.1.
    pub fn is_of_a_muscle(&self, hoop: f64) -> bool {
        let l = self.stretches();
        let (low, high) = MUSCLE_AXIAL_STRETCH;
        let is = |h: usize, z: usize| (1.0..=hoop).contains(&l[h]) && (low..=high).contains(&l[z]);
        (0..3).any(|h| (0..3).any(|z| h != z && is(h, z)))
    }
}
