//! Why a table gives no formula.

use mckibben::cancel::Cancelled;
use thiserror::Error;

/// Why a table gives no formula.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// Nothing to fit.
    #[error("the table has no point with an answer{0}")]
    Empty(&'static str),
    /// Too few values of something.
    #[error("{place} has {found} different values of {quantity}; {needed} are needed at least")]
    TooFew {
        /// Of what: `contraction`, `pressure_mpa`, …
        quantity: &'static str,
        /// How many there are.
        found: usize,
        /// How many it takes.
        needed: usize,
        /// Where: the table, or one of its curves.
        place: String,
    },
    /// Muscles that one formula cannot describe.
    #[error(
        "the table mixes muscles of different {quantity} ({low} to {high}); a formula covers only one: fit them separately"
    )]
    Mixed {
        /// Of what.
        quantity: &'static str,
        /// Smallest value.
        low: f64,
        /// Largest value.
        high: f64,
    },
    /// Muscles of different make.
    #[error("the table mixes muscles of different {0}; a formula covers only one: fit them separately")]
    MixedMake(&'static str),
    /// A measure varies that no formula has.
    #[error(
        "in the table {0} varies, which is not a variable of the formula; fit a table in which it is constant"
    )]
    Varies(String),
    /// An error is a share of the blocked force, which is not in the table.
    #[error(
        "the muscle D0 {outer_diameter_mm} mm, s {wall_mm} mm has no point at contraction 0, so that its errors cannot be stated as shares of its blocked force"
    )]
    NoBlockedForce {
        /// D0 in mm.
        outer_diameter_mm: f64,
        /// s in mm.
        wall_mm: f64,
    },
    /// The caller wanted it to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Least squares without a finite answer.
    #[error("least squares have no finite answer for {0}")]
    Singular(String),
}
