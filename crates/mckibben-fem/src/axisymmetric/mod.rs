//! The axisymmetric muscle.

pub mod assembly;
mod curves;
pub mod discrete;
mod engine;
pub mod equilibrium;
mod guess;
pub mod layout;
pub mod mesh;
mod model;
pub mod path;
mod results;
mod section;
mod sensitivity;
pub mod study;
pub mod sweep;

pub use curves::{Curve, CurvePoint, TangentPoint};
pub use engine::{Along, Engine};
pub use mesh::{Mesh, MeshSpec};
pub use model::Axisymmetric;
pub use results::{Energies, ProfilePoint, Solution, StrandState, StretchAt};
pub use section::{Section, SectionNode};
pub use sensitivity::Sensitivity;
