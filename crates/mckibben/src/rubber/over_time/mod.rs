//! Rubber over time: softening by the first loading, and relaxation, each a wrapper over any law.
//!
//! [`OgdenRoxburgh`] is the Mullins effect: [`Softened`] is a law again, for a given largest energy that the point has seen. [`Prony`] is
//! linear viscoelasticity in the second Piola–Kirchhoff stress. Here the laws' constants are the *instantaneous* ones, t → 0: those of long times are (1 − Σg) times as large ([`Prony::long_time`]).

mod erf;
mod prony;
mod softening;

pub use erf::{erf, erf_integral};
pub use prony::{Branch, Held, Prony};
pub use softening::{OgdenRoxburgh, Softened};

use thiserror::Error;

/// A constant of rubber over time that is invalid.
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
}
