//! The tube where the strands lie at an angle: they keep their length, or are stretched by a share,
//! and the rubber keeps its volume.

use crate::muscle::{Muscle, StrandLay};

/// Radii of a muscle's tube over the angle of its strands.
pub struct Radii {
    lay: StrandLay,
    /// Outer and inner radius at rest in mm.
    rest_mm: (f64, f64),
}

impl Radii {
    pub fn new(muscle: &Muscle) -> Self {
        let tube = muscle.tube();
        Self {
            lay: muscle.strand_lay(),
            rest_mm: (tube.outer_radius_mm(), tube.inner_radius_mm()),
        }
    }

    /// Radius of the braid in mm at an angle in radians, with strands whose length is `stretch`
    /// times that at rest.
    pub fn braid_mm(&self, angle_rad: f64, stretch: f64) -> f64 {
        stretch * self.lay.radius_mm * angle_rad.sin() / self.lay.angle_rad.sin()
    }

    /// Outer and inner radius of the tube in mm.
    pub fn tube_mm(&self, angle_rad: f64, stretch: f64) -> (f64, f64) {
        let (outer_mm, inner_mm) = self.rest_mm;
        let shortened = stretch * angle_rad.cos() / self.lay.angle_rad.cos();
        let outer = self.braid_mm(angle_rad, stretch) - self.lay.offset_mm;
        let area = (outer_mm * outer_mm - inner_mm * inner_mm) / shortened;
        (outer, (outer * outer - area).max(0.0).sqrt())
    }

    /// The largest stretch of the rubber, around the tube or along it.
    pub fn largest_stretch(&self, angle_rad: f64, stretch: f64) -> f64 {
        let (outer, inner) = self.tube_mm(angle_rad, stretch);
        let axial = stretch * angle_rad.cos() / self.lay.angle_rad.cos();
        (inner / self.rest_mm.1)
            .max(outer / self.rest_mm.0)
            .max(axial)
    }
}
