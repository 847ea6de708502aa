//! The ± of what was sought of a joint, from that of its torque: of a rest angle ±τ/|∂τ/∂φ|, of a
//! pressure ±τ/|∂τ/∂P|.

use super::{BoundJoint, JointPoint};
use crate::{answer::FLAT_MPA, model::Workspace};

impl BoundJoint {
    /// 95 % half-width in degrees of the angle at which a joint rests; `None` where it is wider
    /// than the range of the angle, or not known.
    pub fn angle_uncertainty_deg(&self, point: &JointPoint) -> Option<f64> {
        let (low, high) = self.joint().range_deg();
        let half = (point.uncertainty_nm? / point.stiffness_nm_per_rad.abs()).to_degrees();
        (half <= high - low).then_some(half)
    }

    /// 95 % half-width in MPa of the pressure of each muscle, where the pressures were sought: by
    /// so much the pressure of this muscle alone makes up for the ± of the torque. `None` of a
    /// slack muscle, where it is wider than the pressure itself, or not known.
    pub fn pressure_uncertainties_mpa(
        &self,
        workspaces: &mut [Workspace],
        point: &JointPoint,
    ) -> Vec<Option<f64>> {
        let each = point.muscles.iter().zip(workspaces).enumerate();
        let one = |(i, (muscle, workspace)): (usize, (&super::MuscleState, &mut Workspace))| {
            let answer = &muscle.answer;
            let mut model = self.evaluation(i, workspace, answer.direction);
            let slope = model.force_per_pressure_mm2(&answer.response).ok()?;
            let half = 1e3 * point.uncertainty_nm? / (slope * muscle.arm_mm).abs();
            (!answer.slack && half <= answer.response.pressure_mpa.max(FLAT_MPA)).then_some(half)
        };
        each.map(one).collect()
    }
}
