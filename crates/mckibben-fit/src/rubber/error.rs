//! Why there is no fit.

use mckibben::cancel::Cancelled;
use thiserror::Error;

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TensionFitError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
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
