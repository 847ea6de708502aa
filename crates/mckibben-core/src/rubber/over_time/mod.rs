//! Rubber over time: softening by the first loading, and relaxation, each a wrapper over any law.
//!
//! [`OgdenRoxburgh`] is the Mullins effect: [`Softened`] is a law again, for a given largest energy
//! that the point has seen. [`Prony`] is linear viscoelasticity in the second Piola–Kirchhoff
//! stress. Here the laws' constants are the *instantaneous* ones, t → 0: those of long times are (1
//! − Σg) times as large ([`Prony::long_time`]).

mod erf;
mod prony;
mod softening;

pub use erf::{erf, erf_integral};
pub use prony::{Branch, Prony};
pub use softening::OgdenRoxburgh;
pub use {prony::Held, softening::Softened};

use crate::refused::Refused;

/// A constant of rubber over time that is invalid.
fn constant(name: &str, value: f64, expected: &str) -> Refused {
    Refused::new([], format!("{name} is {value}; it must be {expected}"))
}
