//! Files for other programs: the deformed muscle for ParaView.
//!
//! Open `muscle.pvd`: one step for each equilibrium, the tube as a solid and the strands as lines.
//! Points are where they are now; `displacement` leads there from rest. Lengths in mm, stresses in
//! MPa, forces in N.

mod deck;
mod eighth;
pub(crate) mod helices;
mod revolve;
mod series;
mod stations;
pub mod vtu;

pub use deck::{deck, increments};
pub use eighth::Extent;
pub use series::{VtuFile, VtuSeries};
pub use stations::{FIELDS, Field, Stations};
pub use vtu::VtuError;

use crate::axisymmetric::Section;
use vtu::Grid;

/// Tube and strands of one equilibrium.
#[derive(Debug)]
pub struct Shape {
    /// Hexahedra.
    pub tube: Grid,
    /// Lines.
    pub braid: Grid,
    /// The terminals as hexahedra, where they are bodies.
    pub plug: Option<Grid>,
    /// Strands of both families that are drawn, where not every one of a mesh is.
    pub strands_drawn: Option<u32>,
    /// Whether the number of strands is not the muscle's but for display.
    pub for_display: bool,
}

impl Shape {
    /// The whole muscle from the half section of the axisymmetric model.
    pub fn of_section(section: &Section) -> Self {
        Self {
            tube: revolve::tube(section),
            braid: helices::braid(section),
            plug: None,
            strands_drawn: Some(2 * helices::drawn(section)),
            for_display: section.count.is_none(),
        }
    }
}
