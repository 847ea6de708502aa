//! The three-dimensional muscle: one eighth in bricks, strands one by one.
//!
//! | type | what it holds |
//! |---|---|
//! | [`BrickSpec`], [`BrickMesh`] | how one eighth is divided; nodes, bricks, strands and faces of the cavity at rest |
//! | [`Plug`], [`PlugGrid`] | the terminal as a body |
//! | [`Problem`] | any body: nodes, bricks, strands, faces under pressure, supports, order of elimination |
//! | [`Discretisation`], [`Body`] | unknowns numbered; state, tangent and Newton's method |
//! | [`MuscleMesh`], [`MuscleInBricks`], [`ThreeDimensional`] | the muscle divided; the muscle with a state; the muscle as a force model |
//!
//! The deformed place of node n is `mesh.nodes[n] + state.u[3n..3n + 3]`.

mod assembly;
mod body;
mod discretisation;
mod divisions;
pub(crate) mod estimate;
mod field;
mod guess;
mod kinematics;
mod mesh;
mod model;
mod muscle;
mod plug;
mod plug_in_mesh;
mod problem;
mod results;
mod saddle;

pub use assembly::Assembled;
pub use body::Body;
pub use discretisation::Discretisation;
pub use field::{Field, NodeField, PieceField};
pub use mesh::{Brick, BrickMesh, BrickSpec, Match, Quarter};
pub(crate) use model::ENTRY;
pub use model::ThreeDimensional;
pub use muscle::{MuscleInBricks, MuscleMesh};
pub use plug::{Plug, PlugGrid, PlugMaterial};
pub use problem::{Freedom, Other, Problem};
