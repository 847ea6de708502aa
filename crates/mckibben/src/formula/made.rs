//! The muscles a formula was made for: everything but diameter and wall.

use crate::muscle::{Braid, BraidStiffness, Bulk, Muscle, Tube};
use crate::rubber::RubberLaw;

/// Stiffness k of one strand family of the muscles of a formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MadeBraid {
    /// The braid `paper`: k = 452 N/mm · (D0/40 mm)^1.2.
    Paper,
    /// Strands that do not stretch.
    Inextensible,
    /// One k in N/mm for all diameters.
    Stiffness(f64),
    /// One strand count for all diameters: k·D0 in N.
    TimesDiameter(f64),
}

/// What a formula's muscles have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// L0 in mm.
    pub length_mm: f64,
    /// θ0 in degrees.
    pub angle_deg: f64,
    /// Name of the rubber, where it has one.
    pub rubber: Option<String>,
    /// Law of the rubber.
    pub law: String,
    /// Constants of the law; those in MPa end in `_mpa`.
    pub constants: Vec<(String, f64)>,
    /// Bulk modulus in MPa; `None` for an incompressible rubber.
    pub bulk_modulus_mpa: Option<f64>,
    /// The braid.
    pub braid: MadeBraid,
}

/// Constants of a law with their unit in the name.
fn constants(muscle: &Muscle) -> Vec<(String, f64)> {
    let name = |(name, value, unit): (String, f64, &str)| match unit {
        "MPa" if !name.ends_with("_mpa") => (format!("{name}_mpa").to_lowercase(), value),
        _ => (name.to_lowercase(), value),
    };
    muscle.tube().rubber.law.constants().into_iter().map(name).collect()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * a.abs().max(b.abs())
}

impl Made {
    /// What a muscle says, but for its diameter and wall.
    pub fn of(muscle: &Muscle) -> Self {
        let rubber = &muscle.tube().rubber;
        let braid = match (muscle.braid().stiffness, muscle.family_stiffness_n_per_mm()) {
            (BraidStiffness::Paper, _) => MadeBraid::Paper,
            (BraidStiffness::NewtonPerMm(k), _) => MadeBraid::Stiffness(k),
            (BraidStiffness::OfStrands, Some(k)) => MadeBraid::TimesDiameter(k * muscle.outer_diameter_mm()),
            _ => MadeBraid::Inextensible,
        };
        Self {
            length_mm: muscle.length_mm(),
            angle_deg: muscle.braid().angle_deg,
            rubber: rubber.name.clone(),
            law: rubber.law.name().to_owned(),
            constants: constants(muscle),
            bulk_modulus_mpa: match rubber.bulk {
                Bulk::Incompressible => None,
                Bulk::Modulus(k) => Some(k),
            },
            braid,
        }
    }

    /// k of one family in N/mm at a diameter; `None` for strands that do not stretch.
    pub fn stiffness_n_per_mm(&self, outer_diameter_mm: f64) -> Option<f64> {
        match self.braid {
            MadeBraid::Paper => {
                Braid::paper().family_stiffness_n_per_mm(&Tube { outer_diameter_mm, ..Tube::prototype() })
            }
            MadeBraid::Inextensible => None,
            MadeBraid::Stiffness(k) => Some(k),
            MadeBraid::TimesDiameter(k) => Some(k / outer_diameter_mm),
        }
    }

    /// What of a muscle's parts differs, in words.
    pub fn differences(&self, muscle: &Muscle) -> Vec<String> {
        let theirs = Self::of(muscle);
        let same_law = self.law == theirs.law
            && self.constants.len() == theirs.constants.len()
            && self.constants.iter().zip(&theirs.constants).all(|(a, b)| a.0 == b.0 && close(a.1, b.1));
        let same_bulk = match (self.bulk_modulus_mpa, theirs.bulk_modulus_mpa) {
            (None, None) => true,
            (Some(a), Some(b)) => close(a, b),
            _ => false,
        };
        let mut make = vec![];
        if !(same_law && same_bulk) {
            let (ours, theirs) = (self.rubber_text(), theirs.rubber_text());
            make.push(format!("the rubber is {theirs}, the formula is for {ours}"));
        }
        let d = muscle.outer_diameter_mm();
        let same_braid = match (self.stiffness_n_per_mm(d), muscle.family_stiffness_n_per_mm()) {
            (None, None) => true,
            (Some(a), Some(b)) => close(a, b),
            _ => false,
        };
        if !same_braid {
            let text = |k: Option<f64>| k.map_or_else(|| "inextensible".into(), |k| format!("{k:.4} N/mm"));
            let (ours, theirs) = (text(self.stiffness_n_per_mm(d)), text(muscle.family_stiffness_n_per_mm()));
            make.push(format!("the braid's stiffness is {theirs}, the formula is for {ours}"));
        }
        make
    }

    /// The rubber in words: `paper (mooney-rivlin, c10_mpa 0.12, c01_mpa 0)`.
    pub fn rubber_text(&self) -> String {
        let list: Vec<String> = self.constants.iter().map(|(name, v)| format!("{name} {v}")).collect();
        let bulk = self.bulk_modulus_mpa.map_or_else(String::new, |k| format!(", bulk modulus {k} MPa"));
        let law = format!("{}, {}{bulk}", self.law, list.join(", "));
        self.rubber.as_ref().map_or_else(|| law.clone(), |name| format!("{name} ({law})"))
    }

    /// The braid in words.
    pub fn braid_text(&self) -> String {
        match self.braid {
            MadeBraid::Paper => "paper".into(),
            MadeBraid::Inextensible => "inextensible".into(),
            MadeBraid::Stiffness(k) => format!("{k} N/mm"),
            MadeBraid::TimesDiameter(k) => format!("{k} N / D0"),
        }
    }
}
