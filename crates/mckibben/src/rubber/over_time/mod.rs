//! Rubber over time: softening by the first loading, and relaxation, each a wrapper over any law.
//!
//! [`OgdenRoxburgh`] is the Mullins effect: [`Softened`] is a law again, for a given largest energy that the point has seen. [`Prony`] is
//! linear viscoelasticity in the second Piola–Kirchhoff stress. [`Bar`] carries both along a uniaxial history;
//! [`fit_softening`] and [`fit_prony`] find their constants from one. Here the laws' constants are the *instantaneous* ones,
//! t → 0: those of long times are (1 − Σg) times as large ([`Prony::long_time`]).

mod bar;
mod erf;
mod fit_prony;
mod fit_softening;
mod prony;
mod softening;

pub use bar::{Bar, TimePoint, read_history};
pub use erf::{erf, erf_integral};
pub use fit_prony::{BranchFit, PronyFit, fit_prony};
pub use fit_softening::{SofteningFit, fit_softening};
pub use prony::{Branch, Held, Prony};
pub use softening::{OgdenRoxburgh, Softened};

use super::Law;
use super::fit::TensionFitError;
use crate::least_squares::EstimateError;
use serde::{Serialize, Serializer};
use thiserror::Error;

/// Why there is no rubber over time.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum OverTimeError {
    /// A constant that makes no rubber.
    #[error("{name} is {value}; it must be {expected}")]
    Constant {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it should be.
        expected: &'static str,
    },
    /// Times that go back, or stretches that are none.
    #[error("point {index} of the history (time {time_s} s, stretch {stretch}) does not follow: {why}")]
    History {
        /// Counted from zero.
        index: usize,
        /// Its time in s.
        time_s: f64,
        /// Its stretch.
        stretch: f64,
        /// What is wrong.
        why: &'static str,
    },
    /// No first loading, or nothing after it.
    #[error(
        "of {points} points {virgin} lie on the first loading and {later} below it: a law needs {needed} of the former, softening 4 of the latter. Give a test from the first loading on, with at least one unloading"
    )]
    NoVirginCycle {
        /// All.
        points: usize,
        /// On the first loading.
        virgin: usize,
        /// Below the largest energy so far.
        later: usize,
        /// Fewest of the first loading.
        needed: usize,
    },
    /// Not enough of a test.
    #[error(
        "{points} points over {duration_s} s do not tell {branches} branches; take fewer branches or a longer test"
    )]
    TooFew {
        /// Its points.
        points: usize,
        /// From the first to the last, in s.
        duration_s: f64,
        /// As wanted.
        branches: usize,
    },
    /// The law itself has no fit.
    #[error(transparent)]
    Law(#[from] TensionFitError),
    /// No minimum.
    #[error("{what}: {error}")]
    NotConverged {
        /// Which fit.
        what: &'static str,
        /// Why.
        error: EstimateError,
    },
}

/// The constants of a law by their names.
fn columns<S: Serializer>(law: &Law, serializer: S) -> Result<S::Ok, S::Error> {
    law.columns().serialize(serializer)
}

#[cfg(test)]
mod tests;
