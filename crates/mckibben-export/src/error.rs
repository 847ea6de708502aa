//! Why a muscle cannot be exported.

use mckibben_core::{
    analysis::AnalysisError, cancel::Cancelled, model::ModelError, muscle::MuscleError,
};
use thiserror::Error;

/// What an export gives, or why it gives nothing.
pub type Result<T, E = ExportError> = std::result::Result<T, E>;

/// Why a muscle cannot be exported.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ExportError {
    /// No target of this name.
    #[error("there is no target \"{0}\"; the targets are {names}", names = crate::ExportTarget::names())]
    Target(String),
    /// The muscle does not pull at the supply.
    #[error("the muscle does not pull at the supply of {0}\u{a0}MPa: there is nothing to export")]
    NoPull(f64),
    /// The contractions do not bound a box.
    #[error(
        "the contractions from {0} to {1} do not bound a box; the lower end lies at or below zero \
         and above -0.2, the upper one above it and below 0.5"
    )]
    Box(f64, f64),
    /// The model gives no volume.
    #[error("the {0} model gives no volume, which an export states; `fe` and thick-wall do")]
    NoVolume(String),
    /// Too few points with an answer.
    #[error(
        "{0} points at which the muscle pulls are too few for the form; choose a higher supply or \
         a wider box"
    )]
    Points(usize),
    /// The form misses the model, or pulls again behind a slack part: work could be had from a
    /// cycle there.
    #[error("{0}; choose a smaller box (pressure or contractions)")]
    Misses(String),
    /// A host-specific file that cannot be made.
    #[error("{0}")]
    Host(String),
    /// A muscle that the form is not for.
    #[error(transparent)]
    Muscle(#[from] MuscleError),
    /// The model has no answer.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The model has no answer.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
    /// The caller wanted the work to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
