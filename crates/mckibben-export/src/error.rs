//! Why a muscle cannot be exported.

use mckibben::analysis::AnalysisError;
use mckibben::cancel::Cancelled;
use mckibben::model::ModelError;
use mckibben::muscle::MuscleError;
use thiserror::Error;

/// Why a muscle cannot be exported.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ExportError {
    /// No target of this name.
    #[error("there is no target \"{name}\"; the targets are {}", crate::Target::names())]
    Target {
        /// The name.
        name: String,
    },
    /// The muscle does not pull at the supply.
    #[error("the muscle does not pull at the supply of {supply_mpa} MPa: there is nothing to export")]
    NoPull {
        /// The supply in MPa.
        supply_mpa: f64,
    },
    /// The box is none.
    #[error(
        "the contractions from {low} to {high} are no box; the lower end lies at or below zero and above -0.2, the upper one above it and below 0.5"
    )]
    Box {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// The model gives no volume.
    #[error("the {model} model gives no volume, which an export states; `fe` and thick-wall do")]
    NoVolume {
        /// The model's name.
        model: String,
    },
    /// Too few points with an answer.
    #[error(
        "{points} points at which the muscle pulls are too few for the form; choose a higher supply or a wider box"
    )]
    Points {
        /// How many.
        points: usize,
    },
    /// The form misses the model.
    #[error(
        "the form misses the model by {percent:.1} % of the blocked force at worst, and more than {limit:.0} % is not exported; choose a smaller box (pressure or contractions)"
    )]
    Misses {
        /// By so many percent.
        percent: f64,
        /// The limit in percent.
        limit: f64,
    },
    /// The form pulls again behind a slack part: work could be had from a cycle there.
    #[error(
        "behind its free contraction the form pulls again; choose a smaller box (pressure or contractions)"
    )]
    Again,
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
