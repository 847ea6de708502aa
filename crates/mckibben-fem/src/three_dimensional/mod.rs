//! The three-dimensional muscle: one eighth in bricks, strands one by one.

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
mod results;
mod saddle;
mod state;

pub use assembly::{Totals, Work};
pub use body::Body;
pub use discrete::Discrete;
pub use engine::Engine;
pub use field::{Field, NodeField, PieceField};
pub use mesh::{Brick, BrickMesh, BrickSpec, Match, Ring};
pub use model::ThreeDimensional;
pub use parts::{Freedom, Parts};
pub use state::State;
