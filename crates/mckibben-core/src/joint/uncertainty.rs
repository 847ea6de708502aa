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
            Some(parts.each(|n| 1e-3 * m.arm_mm * n))
        });
        let first = each.next().flatten()?;
        let joined = each.try_fold(first, |first, second| {
            Some(first.joined(second?, |name, a, b| match name {
                "friction" => a.abs() + b.abs(),
                "rubber" | "angle" | "stiffness of the braid" if self.alike => a + b,
                _ => a.hypot(b),
            }))
        })?;
        Some(joined.each(f64::abs))
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
        // Torques in N m while the joint turns to + and to −, and that of the model. A branch on which
        // a muscle is slack pulls nothing.
        let torques = |m: &MuscleState| {
            let built = m.answer.built?;
            let shift = built.predicted_shift_n;
            let mean_n = built.mean_n + shift.take_up + shift.ends + shift.factor;
            let half_n = m.arm_mm.signum() * shift.friction.abs();
            let [there_n, back_n] = if m.answer.direction.is_mean() {
                [mean_n - half_n, mean_n + half_n].map(|n| n.max(0.0))
            } else {
                [built.predicted_n; 2]
            };
            let arm_m = 1e-3 * m.arm_mm;
            Some([there_n, back_n, m.answer.response.force_n].map(|n| arm_m * n))
        };
        let torques: Option<Vec<[f64; 3]>> = self.muscles.iter().map(torques).collect();
        let predicted_nm = torques.map(|torques| {
            let sum = |i: usize| torques.iter().map(|t| t[i]).sum::<f64>();
            self.torque_nm - sum(2) + sum(0).max(0.0) + sum(1).min(0.0)
        });
        Self {
            predicted_nm,
            predicted_low_nm: predicted_nm.zip(self.uncertainty_nm).map(|(t, u)| t - u),
            predicted_high_nm: predicted_nm.zip(self.uncertainty_nm).map(|(t, u)| t + u),
            ..self
        }
    }
}
