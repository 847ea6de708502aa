//! A mass on a lever.

use super::GRAVITY_M_PER_S2;
use std::f64::consts::PI;

/// A mass M at a distance a from a pivot; the muscle pulls over a pulley of radius r about the
/// pivot:
///
/// F(x) = M g (a/r) cos φ, φ = φ0 + x/r, φ from the horizontal.
///
/// With a rising arm (φ above zero) the pull falls as the muscle shortens, and below it rises. Past
/// ±90° the mass pulls the arm over, and F is negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lever {
    /// M in kg.
    mass_kg: f64,
    /// a in mm.
    arm_mm: f64,
    /// r in mm.
    radius_mm: f64,
    /// φ0 in degrees.
    from_deg: f64,
}

impl Lever {
    /// A lever; `None` where a mass or a length is not above zero, or the angle is none between
    /// −180° and 180°.
    pub fn new(mass_kg: f64, arm_mm: f64, radius_mm: f64, from_deg: f64) -> Option<Self> {
        let lengths = [mass_kg, arm_mm, radius_mm]
            .iter()
            .all(|v| v.is_finite() && *v > 0.0);
        (lengths && from_deg.abs() <= 180.0).then_some(Self {
            mass_kg,
            arm_mm,
            radius_mm,
            from_deg,
        })
    }

    pub(super) fn times(self, factor: f64) -> Self {
        Self {
            mass_kg: factor * self.mass_kg,
            ..self
        }
    }

    fn weight(&self) -> f64 {
        self.mass_kg * GRAVITY_M_PER_S2 * self.arm_mm / self.radius_mm
    }

    fn angle(&self, x: f64) -> f64 {
        self.from_deg * PI / 180.0 + x / self.radius_mm
    }

    pub(super) fn force_n(&self, x: f64) -> f64 {
        self.weight() * self.angle(x).cos()
    }

    pub(super) fn slope_n_per_mm(&self, x: f64) -> f64 {
        -self.weight() * self.angle(x).sin() / self.radius_mm
    }

    pub(super) fn energy_n_mm(&self, x: f64) -> f64 {
        self.weight() * self.radius_mm * (self.angle(x).sin() - self.angle(0.0).sin())
    }

    /// M (a/r)² in kg.
    pub(super) fn felt_mass_kg(&self) -> f64 {
        self.mass_kg * (self.arm_mm / self.radius_mm).powi(2)
    }
}
