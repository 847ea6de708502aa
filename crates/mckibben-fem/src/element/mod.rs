//! Elements: what a piece of rubber or braid contributes to forces and tangent.

pub mod plane;
pub mod q2;
pub mod solid;
pub mod strand;
pub mod stretches;
pub mod truss;
