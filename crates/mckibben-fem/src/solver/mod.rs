//! Linear and non-linear solvers, and the continuation that leads any body from equilibrium to equilibrium.

pub mod body;
pub mod chain;
pub mod continuation;
pub mod curve;
pub mod dense;
mod descent;
pub mod dissection;
mod form;
mod growth;
mod interrupted;
mod kernel;
mod lead_down;
pub mod newton;
mod panel;
mod path;
mod pattern;
mod search;
pub mod sparse;
mod substitution;
mod supernodal;
mod symbolic;
pub mod trail;
mod walk;

use thiserror::Error;

/// A factorisation that meets a pivot of zero or one that is no number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("the muscle has no stiffness against some change of its shape: it buckles")]
pub struct Singular {
    /// Block, counted from zero.
    pub block: usize,
    /// Pivot inside of the block.
    pub pivot: usize,
}
