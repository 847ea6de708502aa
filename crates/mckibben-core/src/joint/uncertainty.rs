//! What a joint that is built turns, and the ± of its torque and stiffness, from those of its
//! muscles' pulls.
//!
//! A part of the ± of a pull makes Δ′ times as much of the torque. How the parts of two muscles add
//! follows from their cause:
//!
//! - `friction` adds fully: while the joint turns, one of two opposed muscles shortens and the
//!   other lengthens, and the friction of both opposes the turn;
//! - `rubber`, `angle` and `braid` of muscles of the same construction have the same cause: another
//!   stiffness shifts both pulls at once, so that those of opposed muscles cancel in part;
//! - the others add as squares. As far as an error of the model is the same in both muscles, it
//!   would cancel too; that is not counted.
//!
//! The ± of the stiffness is Σ Δ′² ±K, with ±K of [`stiffness_uncertainty_n_per_mm`]: an error of
//! the model, of a rubber or of a braid makes both muscles stiffer, so that it adds fully; and as a
//! square beside it Σ Δ″ ±F.

use super::{BoundJoint, JointPoint, model::MuscleState};
use crate::built::{UncertaintyParts, stiffness_uncertainty_n_per_mm};

impl BoundJoint {
    /// The parts of the ± of the torque in N m; `None` where that of a muscle's pull is not known.
    pub(super) fn torque_uncertainty(&self, muscles: &[MuscleState]) -> Option<UncertaintyParts> {
        let mut each = muscles.iter().map(|m| {
            let parts = m.answer.uncertainty_parts_n?;
            Some(parts.times(1e-3 * m.arm_mm))
        });
        let first = each.next().flatten()?;
        let joined = each.try_fold(first, |first, second| {
            Some(first.joined(second?, |name, a, b| match name {
                "friction" => a.abs() + b.abs(),
                "rubber" | "angle" | "stiffness of the braid" if self.alike => a + b,
                _ => a.hypot(b),
            }))
        })?;
        Some(joined.sizes())
    }

    /// 95 % half-width of the stiffness in N m/rad; `None` where that of a muscle's pull is not
    /// known. A slack muscle has no part in it.
    pub(super) fn stiffness_uncertainty(&self, muscles: &[MuscleState]) -> Option<f64> {
        let mut stiffness = 0.0;
        let mut pull = 0.0;
        for (i, m) in muscles.iter().enumerate().filter(|(_, m)| !m.answer.slack) {
            let parts = m.answer.uncertainty_parts_n?;
            let of_muscle = stiffness_uncertainty_n_per_mm(self.model(i).muscle(), &parts);
            stiffness += 1e-3 * of_muscle * m.arm_mm * m.arm_mm;
            pull += 1e-3 * parts.total() * m.arm_by_angle_mm.abs();
        }
        Some(f64::hypot(stiffness, pull))
    }
}

impl JointPoint {
    /// With the torque that a joint which is built will give: each muscle pulls as the median of one
    /// that is built, on its branch. The joint turns to where its muscles turn it: those that pull
    /// there shorten, the others lengthen. Where they turn it by less than their friction, that holds it.
    pub(super) fn with_built_torque(self) -> Self {
        // Torque of the mean of both branches and half of what lies between them, N m, and the
        // model's.
        let torques = |m: &MuscleState| {
            let built = m.answer.built?;
            let friction_n = built.predicted_shift_n.friction;
            let half_n = if m.answer.direction.is_mean() {
                friction_n.abs()
            } else {
                0.0
            };
            let mean_n = if m.answer.direction.is_mean() {
                built.predicted_n - friction_n
            } else {
                built.predicted_n
            };
            let arm_m = 1e-3 * m.arm_mm;
            let half_n = half_n.min(mean_n.max(0.0));
            let pulls = [mean_n.max(0.0), half_n, m.answer.response.force_n];
            Some(pulls.map(|n| arm_m * n))
        };
        let torques: Option<Vec<[f64; 3]>> = self.muscles.iter().map(torques).collect();
        let predicted_nm = torques.map(|torques| {
            let sum = |of: &dyn Fn(&[f64; 3]) -> f64| torques.iter().map(of).sum::<f64>();
            let (turns, friction) = (sum(&|t| t[0]), sum(&|t| t[1].abs()));
            self.torque_nm + sum(&|t| t[0] - t[2]) - turns.clamp(-friction, friction)
        });
        Self {
            predicted_nm,
            predicted_low_nm: predicted_nm.zip(self.uncertainty_nm).map(|(t, u)| t - u),
            predicted_high_nm: predicted_nm.zip(self.uncertainty_nm).map(|(t, u)| t + u),
            ..self
        }
    }
}
