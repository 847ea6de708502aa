//! Loads that are potentials.

pub mod cavity;
