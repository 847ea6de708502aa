//! The model of a muscle that lies on its pulley, and whether it stays there.

use super::{JointError, JointMuscle, Path, Wrap};
use crate::model::{Bent, ForceModel, OnPulley};

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
