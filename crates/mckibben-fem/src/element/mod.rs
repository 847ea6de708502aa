//! Elements: what a piece of rubber or braid contributes to forces and tangent.

pub mod brick;
pub mod hexahedron;
pub mod lanes;
pub mod law;
pub mod plane;
mod plane_law;
pub mod q2;
pub mod softened;
pub mod solid;
pub mod spatial;
pub mod spatial_stretches;
pub mod strand;
pub mod stretches;
mod tensor;
pub mod truss;
