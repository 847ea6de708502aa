//! The three-dimensional muscle: one eighth in bricks, strands one by one.

mod assembly;
pub mod body;
pub mod discrete;
pub mod mesh;
pub mod parts;
mod saddle;
mod state;

pub use assembly::{Totals, Work};
pub use body::Body;
pub use discrete::Discrete;
pub use mesh::{Brick, BrickMesh, BrickSpec, Match, Ring};
pub use parts::{Freedom, Parts};
pub use state::State;
