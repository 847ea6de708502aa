//! Constants of rubber over time, found from tests.
//!
//! [`Bar`] carries softening and relaxation ([`mckibben::rubber::over_time`]) along a uniaxial history; [`fit_softening`] and [`fit_prony`]
//! find their constants from one.

mod bar;
mod fit_prony;
mod fit_softening;

pub use bar::{Bar, TimePoint, read_history};
pub use fit_prony::{BranchFit, PronyFit, fit_prony};
pub use fit_softening::{SofteningFit, fit_softening};

use crate::least_squares::EstimateError;
use crate::rubber::TensionFitError;
use mckibben::rubber::Law;
use mckibben::rubber::over_time::OverTimeError;
use serde::{Serialize, Serializer};
use thiserror::Error;

/// Why no constants of rubber over time were found.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum OverTimeFitError {
    /// A constant that was found is invalid.
    #[error(transparent)]
    Constant(#[from] OverTimeError),
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
        "{points} points over {duration_s} s do not determine {branches} branches; take fewer branches or a longer test"
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
