//! The axisymmetric muscle.

mod assembly;
mod body;
mod conditioning;
mod contact;
mod discretisation;
mod guess;
mod layout;
mod mesh;
mod model;
mod muscle;
mod neighbour;
mod results;
mod section;
mod sensitivity;

pub use body::Body;
pub use contact::Contact;
pub use discretisation::{BraidSpec, Discretisation, Ends, Memory, Problem};
pub use mesh::{Mesh, MeshSpec};
pub use model::Axisymmetric;
pub(crate) use model::ENTRY;
pub use section::{Section, SectionNode};
