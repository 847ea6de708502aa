//! What is known of a model's error.

use std::fmt;

/// At which pressure the blocked force is taken that an error is a share of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BlockedAt {
    /// At the pressure of the question.
    SamePressure,
    /// At a fixed pressure in MPa.
    Pressure(f64),
}

/// Against what a model's error was measured, in a sentence; [`fmt::Display`] says it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reference {
    /// Against nothing.
    Unknown,
    /// The equations that all others are held against: nothing but the mesh is between them and
    /// their solution.
    Equations,
    /// Finite elements of the same muscles.
    Elements(&'static str),
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Unknown => "no systematic comparison of this model is known to us",
            Self::Equations => {
                "the reference for all other models; mesh: the difference from a fine mesh at the \
                 same point"
            }
            Self::Elements(sentence) => sentence,
        })
    }
}

/// A model's own error as a 95 % half-width, and how it is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    /// Half-width as a share of the muscle's blocked force; `None` where nobody has measured it.
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
        Self {
            share_of_blocked: Some(share),
            blocked_at: BlockedAt::SamePressure,
            reference,
        }
    }
}
