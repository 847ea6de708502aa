//! Loads that are potentials.

pub mod cavity;
pub mod cavity_faces;
