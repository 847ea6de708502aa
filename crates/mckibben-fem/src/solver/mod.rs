//! Linear and non-linear solvers, and the continuation that leads any body from equilibrium to
//! equilibrium.

pub mod body;
pub mod chain;
pub mod continuation;
pub mod curve;
pub mod dense;
mod descent;
pub mod dissection;
pub mod kernel;
mod lead_down;
pub mod newton;
mod panel;
mod search;
pub mod sparse;
mod substitution;
mod supernodal;
pub mod symbolic;
pub mod trail;
mod walk;
