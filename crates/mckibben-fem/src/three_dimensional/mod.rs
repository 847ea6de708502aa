//! The three-dimensional muscle: one eighth in bricks, strands one by one.
//!
//! | type | what it holds |
//! |---|---|
//! | [`BrickSpec`], [`BrickMesh`] | how one eighth is divided; nodes, bricks, strands and bore faces at rest |
//! | [`Plug`], [`PlugGrid`] | the terminal as a body |
//! | [`Parts`] | any body: nodes, bricks, strands, faces under pressure, supports, order of elimination |
//! | [`Discrete`], [`Body`], [`State`] | unknowns numbered; tangent and Newton's method; displacements, pressures, tensions |
//! | [`Engine`], [`ThreeDimensional`] | ways to an equilibrium; the muscle as a force model and its tests |
//!
//! The deformed place of node n is `mesh.nodes()[n] + state.u[3n..3n + 3]`.

mod assembly;
pub mod body;
mod curves;
pub mod discrete;
pub mod engine;
mod field;
mod guess;
pub mod mesh;
mod model;
pub mod parts;
pub mod plug;
mod results;
mod saddle;
mod state;

pub use assembly::{Totals, Work};
pub use body::Body;
pub use discrete::Discrete;
pub use engine::{Engine, Unstable};
pub use field::{Field, NodeField, PieceField, PlugField};
pub use mesh::{Brick, BrickMesh, BrickSpec, Match, Ring};
pub use model::ThreeDimensional;
pub use parts::{Freedom, Other, Parts};
pub use plug::{Plug, PlugGrid, PlugMaterial};
pub use state::State;
