//! The muscles a formula was made for: everything but diameter and wall.

use super::{
    FormulaRange,
    file::check::{maybe_positive, positive},
};
use crate::{
    joined,
    muscle::{Braid, BraidStiffness, Bulk, Muscle, MuscleError, Rubber, Strands, Terminals, Tube},
    rubber::{Law, library},
};
use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Stiffness k of one strand family of the muscles of a formula.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub enum MadeBraid {
    /// A braid with a name.
    #[serde(rename = "stiffness")]
    Named(NamedBraid),
    /// One k in N/mm for all diameters.
    #[serde(rename = "stiffness_n_per_mm", deserialize_with = "positive")]
    Stiffness(f64),
    /// One strand count for all diameters: k·D0 in N.
    #[serde(rename = "stiffness_times_diameter_n", deserialize_with = "positive")]
    TimesDiameter(f64),
}

/// A braid with a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum NamedBraid {
    /// k = 452 N/mm · (D0/40 mm)^1.2
    Paper,
    /// Strands that do not stretch.
    Inextensible,
}

/// Strands by which a braid is described.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct MadeStrands {
    /// Their number, both families together.
    pub count: u32,
    /// Cross-section of one in mm².
    #[serde(deserialize_with = "positive")]
    pub area_mm2: f64,
    /// Young's modulus in MPa.
    #[serde(deserialize_with = "positive")]
    pub modulus_mpa: f64,
    /// Force at which one breaks in N, where it is known.
    #[serde(default, deserialize_with = "maybe_positive")]
    pub strength_n: Option<f64>,
}

/// What a formula's muscles have in common.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct Made {
    /// L0 in mm.
    #[serde(deserialize_with = "positive")]
    pub length_mm: f64,
    /// θ0 in degrees.
    #[serde(deserialize_with = "positive")]
    pub angle_deg: f64,
    /// The rubber.
    pub rubber: MadeRubber,
    /// The braid.
    pub braid: MadeBraid,
    /// Its strands, where they state its stiffness.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strands: Option<MadeStrands>,
}

/// The rubber of a formula's muscles.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct MadeRubber {
    /// Its name, where it has one.
    pub name: Option<String>,
    /// Its law.
    pub law: String,
    /// Constants of the law; those in MPa end in `_mpa`.
    #[schemars(with = "std::collections::BTreeMap<String, f64>")]
    pub constants: IndexMap<String, f64>,
    /// Bulk modulus in MPa; `None` for an incompressible rubber.
    #[serde(default, deserialize_with = "maybe_positive")]
    pub bulk_modulus_mpa: Option<f64>,
}

impl From<&Rubber> for MadeRubber {
    fn from(rubber: &Rubber) -> Self {
        let constants = rubber.law.constants().into_iter();
        Self {
            name: rubber.name.clone(),
            law: rubber.law.name().to_owned(),
            constants: constants.map(|c| (c.column(), c.value)).collect(),
            bulk_modulus_mpa: match rubber.bulk {
                Bulk::Incompressible => None,
                Bulk::Modulus(k) => Some(k),
            },
        }
    }
}

impl Made {
    /// What a muscle says, but for its diameter and wall.
    pub fn from_muscle(muscle: &Muscle) -> Self {
        let rubber = muscle.rubber();
        let braid = match (muscle.braid().stiffness, muscle.family_stiffness_n_per_mm()) {
            (BraidStiffness::Paper, _) => MadeBraid::Named(NamedBraid::Paper),
            (BraidStiffness::NewtonPerMm(k), _) => MadeBraid::Stiffness(k),
            (BraidStiffness::OfStrands, Some(k)) => {
                MadeBraid::TimesDiameter(k * muscle.outer_diameter_mm())
            }
            _ => MadeBraid::Named(NamedBraid::Inextensible),
        };
        Self {
            length_mm: muscle.length_mm(),
            angle_deg: muscle.braid().angle_deg,
            rubber: rubber.into(),
            braid,
            strands: muscle.braid().strands.and_then(|s| {
                Some(MadeStrands {
                    count: s.count,
                    area_mm2: s.area_mm2?,
                    modulus_mpa: s.modulus_mpa?,
                    strength_n: s.strength_n,
                })
            }),
        }
    }

    /// The same with the strands of a muscle, where these give its stiffness.
    #[must_use]
    pub fn with_strands_of(self, muscle: &Muscle) -> Self {
        let theirs = Self::from_muscle(muscle);
        match (self.braid, theirs.braid) {
            (MadeBraid::TimesDiameter(a), MadeBraid::TimesDiameter(b))
                if alike(Some(a), Some(b), 1e-6) =>
            {
                Self {
                    strands: theirs.strands,
                    ..self
                }
            }
            _ => self,
        }
    }

    /// A muscle of this make: diameter and wall are the prototype's where the formula holds for
    /// them, else in the middle of its range. Strands that the formula does not state have their
    /// stiffness on this diameter.
    pub fn muscle(&self, range: &FormulaRange) -> Result<Muscle, MuscleError> {
        let near = |value: f64, (low, high): (f64, f64)| {
            if (low..=high).contains(&value) {
                value
            } else {
                0.5 * (low + high)
            }
        };
        let prototype = Tube::prototype();
        let constants: Vec<f64> = self.rubber.constants.values().copied().collect();
        let rubber = match Law::named(&self.rubber.law, &constants) {
            Some(law) => Rubber {
                name: self.rubber.name.clone(),
                bulk: self
                    .rubber
                    .bulk_modulus_mpa
                    .map_or(Bulk::Incompressible, Bulk::Modulus),
                ..Rubber::new(law)
            },
            None => prototype.rubber.clone(),
        };
        let tube = Tube {
            outer_diameter_mm: near(prototype.outer_diameter_mm, range.outer_diameter_mm),
            wall_mm: near(prototype.wall_mm, range.wall_mm),
            length_mm: self.length_mm,
            rubber,
            ..prototype
        };
        let strands = self
            .strands
            .map(|s| Strands::new(s.count, Some((s.area_mm2, s.modulus_mpa)), s.strength_n));
        let braid = Braid {
            angle_deg: self.angle_deg,
            stiffness: match self.braid {
                MadeBraid::Named(NamedBraid::Inextensible) => BraidStiffness::Inextensible,
                MadeBraid::Named(NamedBraid::Paper) => BraidStiffness::Paper,
                MadeBraid::Stiffness(k) => BraidStiffness::NewtonPerMm(k),
                MadeBraid::TimesDiameter(_) if strands.is_some() => BraidStiffness::OfStrands,
                MadeBraid::TimesDiameter(k) => {
                    BraidStiffness::NewtonPerMm(k / tube.outer_diameter_mm)
                }
            },
            strands,
            ..Braid::paper()
        };
        Muscle::new(tube, braid, Terminals::default(), None)
    }

    /// k of one family in N/mm at a diameter; `None` for strands that do not stretch.
    pub fn stiffness_n_per_mm(&self, outer_diameter_mm: f64) -> Option<f64> {
        match self.braid {
            MadeBraid::Named(NamedBraid::Paper) => {
                Braid::paper().family_stiffness_n_per_mm(&Tube {
                    outer_diameter_mm,
                    ..Tube::prototype()
                })
            }
            MadeBraid::Named(NamedBraid::Inextensible) => None,
            MadeBraid::Stiffness(k) => Some(k),
            MadeBraid::TimesDiameter(k) => Some(k / outer_diameter_mm),
        }
    }
}

/// Whether two values are alike, relative to the larger: both none, or near to each other.
pub fn alike(a: Option<f64>, b: Option<f64>, tolerance: f64) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= tolerance * a.abs().max(b.abs()),
        (a, b) => a.is_none() && b.is_none(),
    }
}

impl MadeRubber {
    /// Whether two are the same but for their names, their constants within a relative tolerance.
    pub fn is_like(&self, other: &Self, tolerance: f64) -> bool {
        let same = |(name, a): (&String, &f64)| {
            let other = other.constants.get(name).copied();
            alike(Some(*a), other, tolerance)
        };
        self.law == other.law
            && self.constants.len() == other.constants.len()
            && self.constants.iter().all(same)
            && alike(self.bulk_modulus_mpa, other.bulk_modulus_mpa, tolerance)
    }

    /// Whether a rubber is the one of this name in the library, with the law for its own muscle.
    pub fn is_named(&self, rubber: &Rubber) -> bool {
        self.name == rubber.name && library::follows(rubber)
    }

    /// In words: `antonelli2018 (mooney-rivlin, c10_mpa 0.12, c01_mpa 0)`.
    pub fn text(&self) -> String {
        let bulk = self
            .bulk_modulus_mpa
            .map_or_else(String::new, |k| format!(", bulk modulus {k} MPa"));
        let constants = self.constants.iter().map(|(name, v)| format!("{name} {v}"));
        let law = format!("{}, {}{bulk}", self.law, joined(constants, ", "));
        self.name
            .as_ref()
            .map_or_else(|| law.clone(), |name| format!("{name} ({law})"))
    }
}
