//! Loads that are potentials.

pub mod bore;
pub mod cavity;
