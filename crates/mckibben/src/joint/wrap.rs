//! A muscle that lies on the pulley itself, instead of a rope: its model is that of a bent muscle.

use super::{JointError, JointMuscle, Path};
use crate::model::{Bent, ForceModel, OnPulley, Strands};
use crate::muscle::Muscle;

/// How a muscle lies on a pulley about the joint's axis.
///
/// Of its end at the link that carries the pulley it lies on it over the angle α, which shrinks as the muscle shortens, α = α0 − Δ/(R + Ro); the rest of it is
/// straight. Δ(φ) = (R + Ro) φ is that of its axis at rest, with the muscle's outer radius Ro; what the bulge and the bend change is in the pull of [`Bent`].
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

impl JointMuscle {
    /// The model of the muscle at the joint, from that of the straight muscle: of a muscle that lies on its pulley with the bend, else the model itself.
    pub fn model(&self, straight: Box<dyn ForceModel>) -> Box<dyn ForceModel> {
        let Path::Wrap(wrap) = self.path else { return straight };
        let on = OnPulley {
            radius_mm: wrap.radius_mm.abs(),
            angle_rad: wrap.angle_deg.to_radians(),
            straight_mm: self.straight_mm(&wrap),
        };
        Box::new(Bent::new(straight, on, self.contraction_at_neutral, wrap.friction, wrap.strands))
    }

    /// What of the muscle is straight at rest radius, in mm.
    fn straight_mm(&self, wrap: &Wrap) -> f64 {
        let length = self.muscle.length_mm() * (1.0 - self.contraction_at_neutral);
        length - wrap.angle_deg.to_radians() * wrap.arm_mm().abs()
    }

    /// That a wrap leaves a straight part and that the muscle stays on the pulley over the range of the joint.
    pub(super) fn check_wrap(&self, i: usize, (low_deg, high_deg): (f64, f64)) -> Result<(), JointError> {
        let Path::Wrap(wrap) = self.path else { return Ok(()) };
        let muscle = i + 1;
        if !(wrap.friction.is_finite() && wrap.friction >= 0.0) {
            return Err(JointError::Negative { what: "wrap_friction", value: wrap.friction });
        }
        let (angle_deg, straight_mm) = (wrap.angle_deg, self.straight_mm(&wrap));
        // Unwound at the end of the range towards which the muscle turns.
        let unwound_deg = if wrap.radius_mm > 0.0 { high_deg } else { -low_deg };
        if !(angle_deg > unwound_deg && angle_deg.is_finite()) {
            return Err(JointError::LeavesPulley { muscle, angle_deg, unwound_deg });
        }
        if straight_mm <= 0.0 {
            return Err(JointError::AllOnPulley { muscle, angle_deg, short_mm: -straight_mm });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
