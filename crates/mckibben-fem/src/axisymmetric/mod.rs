//! The axisymmetric muscle.

pub mod assembly;
pub mod discrete;
pub mod equilibrium;
mod error;
pub mod path;
pub mod layout;
pub mod mesh;

pub use error::{FemError, LastConverged};
