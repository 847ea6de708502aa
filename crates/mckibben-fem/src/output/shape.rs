//! A muscle as bodies in space: the tube as hexahedra, the strands as lines, with numbers at their points.

use super::vtu::Grid;
use super::{helices, revolve};
use crate::axisymmetric::Section;

/// Tube and strands of one equilibrium.
#[derive(Debug, Clone)]
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
            for_display: section.strand_count().is_none(),
        }
    }
}
