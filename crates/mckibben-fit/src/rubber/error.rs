//! Why there is no fit.

use mckibben::cancel::Cancelled;
use thiserror::Error;

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TensionFitError {
    /// Not enough points for a law.
    #[error("{points} points are too few for {law}: it takes {needed} or more")]
    TooFew {
        /// Which law.
        law: String,
        /// Points that count.
        points: usize,
        /// Points it takes.
        needed: usize,
    },
    /// The stress does not grow with the stretch.
    #[error(
        "the points give a modulus of {modulus_mpa} MPa: stress must be above zero where the stretch is above 1; check the columns and their signs"
    )]
    NoStiffness {
        /// The neo-Hookean modulus that fits best.
        modulus_mpa: f64,
    },
    /// An invalid setting.
    #[error("{what} is {value}; it must be {expected}")]
    Setting {
        /// Which.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it should be.
        expected: &'static str,
    },
    /// A term too many.
    #[error("{law}: this number of terms fits these data no better than fewer terms")]
    NoBetter {
        /// Which law.
        law: String,
    },
    /// The work was ended.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// No minimum was found.
    #[error("{law}: no fit was found: {why}")]
    NotConverged {
        /// Which law.
        law: String,
        /// Why.
        why: String,
    },
}
