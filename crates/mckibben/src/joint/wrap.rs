//! A muscle that lies on the pulley itself, instead of a rope: its model is that of a bent muscle.

use crate::model::Strands;
use crate::muscle::Muscle;

/// How a muscle lies on a pulley about the joint's axis.
///
/// Of its end at the link that carries the pulley it lies on it over the angle α, which shrinks as the muscle shortens, α = α0 − Δ/(R + Ro); the rest of it is
/// straight. Δ(φ) = (R + Ro) φ is that of its axis at rest, with the muscle's outer radius Ro; what the bulge and the bend change is in the pull of [`Bent`](crate::model::Bent).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrap {
    /// R in mm; negative on the other side.
    pub radius_mm: f64,
    /// Ro in mm.
    pub outer_radius_mm: f64,
    /// α0 in degrees, at the neutral angle.
    pub angle_deg: f64,
    /// Coefficient of friction between sleeve and pulley.
    pub friction: f64,
    /// How strands follow the bend; between both limits where it is not known.
    pub strands: Option<Strands>,
}

impl Wrap {
    /// R + Ro with the sign of R.
    pub fn arm_mm(&self) -> f64 {
        self.radius_mm + self.outer_radius_mm.copysign(self.radius_mm)
    }

    /// The same for a muscle.
    pub(super) fn of(self, muscle: &Muscle) -> Self {
        Self { outer_radius_mm: muscle.tube().outer_radius_mm(), ..self }
    }
}
