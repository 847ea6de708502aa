//! What is known of a model's error.

/// At which pressure the blocked force is taken that an error is a share of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BlockedAt {
    /// At the pressure of the question.
    SamePressure,
    /// At a fixed pressure in MPa.
    Pressure(f64),
}

/// A model's error as a 95 % half-width, and how it is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    /// Half-width as a share of the muscle's blocked force; `None` where nobody has measured it.
    pub share_of_blocked: Option<f64>,
    /// Which blocked force.
    pub blocked_at: BlockedAt,
    /// Against what it was measured, in one sentence.
    pub basis: &'static str,
}

impl Accuracy {
    /// Nothing is known.
    pub const UNKNOWN: Accuracy = Accuracy {
        share_of_blocked: None,
        blocked_at: BlockedAt::SamePressure,
        basis: "no systematic comparison of this model is known to us",
    };

    /// A share of the blocked force at the pressure of the question.
    pub const fn share(share: f64, basis: &'static str) -> Self {
        Self { share_of_blocked: Some(share), blocked_at: BlockedAt::SamePressure, basis }
    }
}
