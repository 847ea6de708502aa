//! The rubber tube.

use super::error::MuscleError;
use super::rubber::Rubber;

/// A tube at rest, between the terminals.
#[derive(Debug, Clone, PartialEq)]
pub struct Tube {
    /// Outer diameter D0 in mm; the braid lies on it.
    pub outer_diameter_mm: f64,
    /// Wall thickness s in mm.
    pub wall_mm: f64,
    /// Length L0 between the terminals in mm.
    pub length_mm: f64,
    /// What it is made of.
    pub rubber: Rubber,
}

impl Tube {
    /// A tube by its outer diameter, wall and length in mm, and its rubber.
    pub fn new(outer_diameter_mm: f64, wall_mm: f64, length_mm: f64, rubber: Rubber) -> Self {
        Self { outer_diameter_mm, wall_mm, length_mm, rubber }
    }

    /// The tube of the paper's prototype.
    pub fn prototype() -> Self {
        Self::new(30.0, 3.0, 285.0, Rubber::paper())
    }

    pub(super) fn check(&self) -> Result<(), MuscleError> {
        let radius_mm = self.outer_radius_mm();
        if self.wall_mm >= radius_mm {
            return Err(MuscleError::WallTooThick { wall_mm: self.wall_mm, radius_mm });
        }
        self.rubber.check()
    }

    /// Ro = D0/2 in mm.
    pub fn outer_radius_mm(&self) -> f64 {
        0.5 * self.outer_diameter_mm
    }

    /// Ri = D0/2 − s in mm.
    pub fn inner_radius_mm(&self) -> f64 {
        self.outer_radius_mm() - self.wall_mm
    }
}
