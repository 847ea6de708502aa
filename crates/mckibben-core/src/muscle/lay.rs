//! Where the strands lie: on the tube's surface, half a braid's thickness off it, or in a sleeve
//! that is wider than the tube.
//!
//! With t the thickness of the braid, Ds the inner diameter at which the sleeve has the angle θ0
//! (D0 where nothing else is said), r the tube's outer radius now and λ its axial stretch,
//!
//!   λf² = cos²θ0 λ² + sin²θ0 (rb/Rs)²,   rb = r + t/2,   Rs = (Ds + t)/2
//!
//! is the square of a strand's stretch: Rs and rb are the radii of its midline in the sleeve as
//! made, and now. Where the sleeve is wider than the tube, λf < 1 at rest, and strands that carry
//! no compression are slack until the tube has filled it. Strands keep to the points of the tube
//! that they lie over at rest; how a slack sleeve slides along the tube is neglected.

use super::{Braid, Tube};

/// The helix of the strands and how far off the tube it runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrandLay {
    /// θ0 in radians.
    pub angle_rad: f64,
    /// Rs: radius of the midline in the sleeve as made, in mm.
    pub radius_mm: f64,
    /// t/2: how far the midline runs outside of the tube's surface, in mm.
    pub offset_mm: f64,
}

impl StrandLay {
    /// Of a braid with a thickness t in mm in a sleeve of an inner diameter Ds in mm.
    pub fn new(angle_rad: f64, diameter_mm: f64, thickness_mm: f64) -> Self {
        let offset_mm = 0.5 * thickness_mm;
        Self {
            angle_rad,
            radius_mm: 0.5 * diameter_mm + offset_mm,
            offset_mm,
        }
    }

    /// rb/Rs at an outer radius of the tube in mm.
    pub fn hoop_stretch(&self, outer_radius_mm: f64) -> f64 {
        (outer_radius_mm + self.offset_mm) / self.radius_mm
    }

    /// The outer radius of the tube in mm at which rb/Rs has a value.
    pub fn outer_radius_mm(&self, hoop_stretch: f64) -> f64 {
        hoop_stretch * self.radius_mm - self.offset_mm
    }

    /// Whether the strands lie on the surface of a tube that fills the sleeve.
    pub fn is_on(&self, tube: &Tube) -> bool {
        self.offset_mm == 0.0 && self.radius_mm == tube.outer_radius_mm()
    }
}

impl Braid {
    /// How the strands lie on a tube.
    #[doc(hidden)]
    pub fn lay(&self, tube: &Tube) -> StrandLay {
        let diameter_mm = self.diameter_mm.unwrap_or(tube.outer_diameter_mm);
        StrandLay::new(self.angle_rad(), diameter_mm, self.thickness_mm)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::muscle::Muscle;

    /// A tube fills its own sleeve: a midline of D0 + t, at rest rb = Rs; a wider sleeve is slack
    /// by the ratio of the radii.
    #[test]
    fn at_rest_the_midline_is_that_of_the_sleeve_unless_the_sleeve_is_wider() {
        let tube = Muscle::prototype().tube().clone();
        let thick = Braid {
            thickness_mm: 0.6,
            ..Braid::paper()
        }
        .lay(&tube);
        assert_eq!((thick.radius_mm, thick.offset_mm), (15.3, 0.3));
        assert_eq!(thick.hoop_stretch(tube.outer_radius_mm()), 1.0);
        assert!((thick.outer_radius_mm(1.0) - 15.0).abs() < 1e-14);
        let wide = Braid {
            diameter_mm: Some(32.0),
            ..Braid::paper()
        }
        .lay(&tube);
        assert_eq!(wide.hoop_stretch(15.0), 15.0 / 16.0);
        assert!(
            Braid::paper().lay(&tube).is_on(&tube) && !thick.is_on(&tube) && !wide.is_on(&tube)
        );
    }
}
