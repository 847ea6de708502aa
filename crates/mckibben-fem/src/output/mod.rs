//! Files for other programs: the deformed muscle for ParaView.
//!
//! Open `muscle.pvd`: one step for each equilibrium, the tube as a solid and the strands as lines. Points stand where
//! they are now; `displacement` leads there from rest. Lengths in mm, stresses in MPa, forces in N.

mod deck;
mod eighth;
mod error;
mod fields;
mod helices;
mod revolve;
mod series;
mod shape;
mod stations;
pub mod vtu;

pub use deck::{DeckError, deck, increments};
pub use eighth::Extent;
pub use error::VtuError;
pub use fields::{FIELDS, Field};
pub use series::{VtuFile, VtuSeries};
pub use shape::Shape;
pub use stations::Stations;
