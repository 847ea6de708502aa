//! Constants of rubber over time, from tests.
//!
//! [`Bar`] carries softening and relaxation ([`mckibben_core::rubber::over_time`]) along a uniaxial
//! history; [`fit_softening`] and [`fit_prony`] find their constants from one.

mod bar;
mod fit_prony;
mod fit_softening;

pub use bar::Bar;
pub use bar::{TimePoint, read_history};
pub use fit_prony::{BranchFit, PronyFit, fit_prony};
pub use fit_softening::{SofteningFit, fit_softening};

use crate::{
    least_squares::EstimateError,
    rubber::{FitSettings, FittedLaw, Form, TensionFitError, TensionPoint, fit_tension},
};
use mckibben_core::{refused::Refused, rubber::Law};
use serde::{Serialize, Serializer};
use thiserror::Error;

pub(crate) type Result<T, E = OverTimeFitError> = std::result::Result<T, E>;

/// Why there are no constants of rubber over time.
#[derive(Debug, PartialEq, Error)]
pub enum OverTimeFitError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// A fitted constant is invalid.
    #[error(transparent)]
    Constant(#[from] Refused),
    /// The law itself has no fit.
    #[error(transparent)]
    Law(#[from] TensionFitError),
    /// No minimum.
    #[error("{0}: {1}")]
    NotConverged(&'static str, EstimateError),
}

/// A law from all points of a history, without time.
fn elastic(points: &[TensionPoint], form: Form, stable: bool) -> Result<FittedLaw> {
    let settings = FitSettings {
        forms: vec![form],
        stable,
        history: true,
        up_to_stretch: None,
        ..FitSettings::default()
    };
    Ok(fit_tension(points, &settings)?.laws.swap_remove(0))
}

/// The constants of a law by their names.
fn columns<S: Serializer>(law: &Law, serializer: S) -> Result<S::Ok, S::Error> {
    law.columns().serialize(serializer)
}

#[cfg(test)]
mod tests;
