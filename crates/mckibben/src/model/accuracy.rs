//! What is known of a model's error.

use serde::{Serialize, Serializer};
use std::fmt;

/// At which pressure the blocked force is taken that an error is a share of.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum BlockedAt {
    /// At the pressure of the question.
    SamePressure,
    /// At a fixed pressure in MPa.
    #[serde(rename = "pressure_mpa")]
    Pressure(f64),
}

/// Against what a model's error was measured. [`fmt::Display`] says it in a sentence; it is serialised as that sentence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reference {
    /// Against nothing.
    Unknown,
    /// 5491 points on 1000 random muscles by axisymmetric finite elements.
    RandomMuscles(Where),
    /// The equations that all others are held against: nothing but the mesh is between them and their solution.
    Equations,
    /// The static force map of a bought muscle (Martens & Boblan 2017).
    ForceMap {
        /// Its name.
        muscle: &'static str,
        /// Points compared.
        points: u32,
        /// Root mean square of the error in N.
        rms_n: f64,
        /// How it differs from the muscle of the formula.
        specimen: Specimen,
    },
    /// The muscles left out of the fit of a formula for every make.
    HeldOut,
    /// The table of a formula for one make, and muscles held out of it.
    OwnTable,
    /// The paper's own statement, and this program's finite elements over its box.
    Paper,
}

/// Where a model errs most on the random muscles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Where {
    /// With soft strands.
    SoftStrands,
    /// It promises too much, most with soft strands and thick walls.
    SoftStrandsAndThickWalls,
    /// At the ends: a share of D0/L0.
    Ends {
        /// The error over D0/L0.
        per_slenderness: f64,
        /// With strands that stretch.
        stretching: bool,
    },
}

/// How the specimen of a force map differs from that of a formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Specimen {
    /// Its largest contraction was taken from its length.
    ContractionFromLength,
    /// It pulls less.
    PullsLess,
    /// It is longer.
    Longer,
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const MUSCLES: &str = "95 % of 5491 points on 1000 random muscles (L0/D0 5–20";
        const ELEMENTS: &str = "against axisymmetric finite elements";
        match *self {
            Self::Unknown => f.write_str("no systematic comparison of this model is known to us"),
            Self::RandomMuscles(Where::SoftStrands) => {
                write!(f, "{MUSCLES}, strand strain up to 6 %) {ELEMENTS}; largest for soft strands")
            }
            Self::RandomMuscles(Where::SoftStrandsAndThickWalls) => write!(
                f,
                "{MUSCLES}, strand strain up to 6 %) {ELEMENTS}; the error is one of excess, largest for soft strands and thick walls"
            ),
            Self::RandomMuscles(Where::Ends { per_slenderness, stretching: true }) => write!(
                f,
                "{per_slenderness} D0/L0 of the blocked force covers {MUSCLES}, strand strain up to 6 %) {ELEMENTS}: the ends, which this model neglects; it mostly predicts too much pull"
            ),
            Self::RandomMuscles(Where::Ends { per_slenderness, stretching: false }) => write!(
                f,
                "{per_slenderness} D0/L0 of the blocked force covers {MUSCLES}) {ELEMENTS} with inextensible strands: the ends, which this model neglects"
            ),
            Self::Equations => f.write_str(
                "the reference for all other models; mesh: the difference from a fine mesh at the same point",
            ),
            Self::ForceMap { muscle, points, rms_n, specimen } => {
                let (the, differs) = match specimen {
                    Specimen::ContractionFromLength => (
                        "the ",
                        " that lie in the box, with the largest contraction taken from the length",
                    ),
                    Specimen::PullsLess => {
                        ("the ", ", another specimen than the fitted one, which pulls less")
                    }
                    Specimen::Longer => ("", ", another and longer specimen than the fitted one"),
                };
                write!(
                    f,
                    "rms {rms_n} N on {the}{points} points of the static force map of a {muscle} (Martens & Boblan 2017){differs}"
                )
            }
            Self::HeldOut => f.write_str(
                "covers 95 % of the points of its campaign on muscles left out of the fit, against axisymmetric finite elements, as stated in the formula's file",
            ),
            Self::OwnTable => f.write_str(
                "covers 95 % of the points of its own table, and of the muscles held out of it, as stated in the formula's file",
            ),
            Self::Paper => f.write_str(
                "its authors state about 2 % and at most 50 N against their own finite elements; against this program's axisymmetric finite elements (rubber and braid `paper`) 95 % of 1889 points over its box lie within 3.9 %, the worst at 5.9 % near D0 37.5 mm, and the published C block, linear in D0, is weakest near D0 35–40 mm",
            ),
        }
    }
}

impl Serialize for Reference {
    fn serialize<S: Serializer>(&self, out: S) -> Result<S::Ok, S::Error> {
        out.collect_str(self)
    }
}

/// A model's own error as a 95 % half-width, and how it is known.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Accuracy {
    /// Half-width as a share of the muscle's blocked force; `None` where nobody has measured it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub share_of_blocked: Option<f64>,
    /// Which blocked force.
    pub blocked_at: BlockedAt,
    /// Against what it was measured.
    pub reference: Reference,
}

impl Accuracy {
    /// Nothing is known.
    pub const UNKNOWN: Accuracy = Accuracy {
        share_of_blocked: None,
        blocked_at: BlockedAt::SamePressure,
        reference: Reference::Unknown,
    };

    /// A share of the blocked force at the pressure of the question.
    pub const fn share(share: f64, reference: Reference) -> Self {
        Self { share_of_blocked: Some(share), blocked_at: BlockedAt::SamePressure, reference }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_are_sentences() {
        let map = |muscle, points, rms_n, specimen| Reference::ForceMap { muscle, points, rms_n, specimen };
        for (reference, sentence) in [
            (
                map("DMSP-10-250", 24, 17.0, Specimen::ContractionFromLength),
                "rms 17 N on the 24 points of the static force map of a DMSP-10-250 (Martens & Boblan 2017) that lie in the box, with the largest contraction taken from the length",
            ),
            (
                map("DMSP-20-300", 55, 98.0, Specimen::Longer),
                "rms 98 N on 55 points of the static force map of a DMSP-20-300 (Martens & Boblan 2017), another and longer specimen than the fitted one",
            ),
            (
                Reference::RandomMuscles(Where::Ends { per_slenderness: 0.65, stretching: false }),
                "0.65 D0/L0 of the blocked force covers 95 % of 5491 points on 1000 random muscles (L0/D0 5–20) against axisymmetric finite elements with inextensible strands: the ends, which this model neglects",
            ),
        ] {
            assert_eq!(reference.to_string(), sentence);
        }
    }
}
