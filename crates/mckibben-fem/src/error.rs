//! Why there is no answer.

use crate::solver::newton::Stopped;
use mckibben::model::ModelError;
use thiserror::Error;

/// The last equilibrium that was found on the way to one that was not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LastConverged {
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction ratio.
    pub contraction: f64,
    /// Pull in N.
    pub force_n: f64,
    /// Smallest volume ratio of the rubber.
    pub smallest_j: f64,
}

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FemError {
    /// Numbers that make no mesh.
    #[error("mesh: {name} is {value}; it must lie between {low} and {high}")]
    Mesh {
        /// Which number: `through`, `along`, `grading`, a measure of the terminal.
        name: &'static str,
        /// What was given.
        value: f64,
        /// Least.
        low: f64,
        /// Most.
        high: f64,
    },
    /// An element of the undeformed mesh that is turned inside out.
    #[error("mesh: element {element} is turned inside out at rest")]
    Element {
        /// Which element.
        element: usize,
    },
    /// More unknowns than there is memory for.
    #[error("mesh: there is not enough memory for {unknowns} unknowns; take fewer elements")]
    TooLarge {
        /// Number of unknowns.
        unknowns: usize,
    },
    /// A question that is no number, a pressure that is not finite, a contraction of 1 or more.
    #[error("no muscle has a pressure of {pressure_mpa} MPa and a contraction of {contraction}")]
    Question {
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// Contraction ratio.
        contraction: f64,
    },
    /// The path to the answer ended before it.
    #[error(
        "no equilibrium found at {pressure_mpa} MPa and contraction {contraction}: {reason}; the last one stands at {} MPa, contraction {} (smallest J {:.4})",
        .last.pressure_mpa, .last.contraction, .last.smallest_j
    )]
    Path {
        /// Pressure asked for, in MPa.
        pressure_mpa: f64,
        /// Contraction asked for.
        contraction: f64,
        /// Why the last step was given up.
        reason: Stopped,
        /// Newton iterations done in all.
        iterations: usize,
        /// The last equilibrium.
        last: LastConverged,
    },
    /// No pressure or contraction gives the force.
    #[error("no equilibrium with a pull of {force_n} N was found: {reason}")]
    Force {
        /// The pull asked for in N.
        force_n: f64,
        /// Why the search ended.
        reason: Stopped,
    },
}

impl FemError {
    /// The same as an error of the library's models.
    pub fn into_model(self, pressure_mpa: f64, contraction: f64) -> ModelError {
        match self {
            Self::Question { .. } => ModelError::Geometry { contraction, lowest: -1.0, highest: 1.0 },
            Self::Path { iterations, reason, last, .. } => ModelError::Stopped {
                pressure_mpa,
                contraction,
                iterations,
                reason: reason.to_string(),
                last_pressure_mpa: last.pressure_mpa,
                last_contraction: last.contraction,
                smallest_volume_ratio: last.smallest_j,
            },
            Self::Mesh { .. } | Self::Element { .. } | Self::TooLarge { .. } => {
                ModelError::Elements { reason: self.to_string() }
            }
            Self::Force { .. } => ModelError::NotFinite { model: "fe".into(), pressure_mpa, contraction },
        }
    }
}
