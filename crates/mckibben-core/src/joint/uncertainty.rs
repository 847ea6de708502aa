//! The ± of a joint's torque and stiffness, from those of its muscles' pulls.
//!
//! A part of the ± of a pull makes Δ′ times as much of the torque. How the parts of two muscles add
//! follows from their cause:
//!
//! - `friction` adds fully: while the joint turns, one of two opposed muscles shortens and the
//!   other lengthens, and the friction of both opposes the turn;
//! - `rubber` and `braid` of muscles of the same construction have the same cause: another
//!   stiffness shifts both pulls at once, so that the shifts add with their signs ([`Shifts`]), and
//!   those of opposed muscles cancel in part;
//! - the others add as squares. As far as an error of the model is the same in both muscles, it
//!   would cancel too; that is not counted.
//!
//! The ± of the stiffness is Σ Δ′² ±K, with ±K of [`stiffness_uncertainty_n_per_mm`]: an error of
//! the model, of a rubber or of a braid makes both muscles stiffer, so that it adds fully; and as a
//! square beside it Σ Δ″ ±F.

use super::{JointModel, model::MuscleState};
use crate::{
    model::Workspace,
    uncertainty::{Shifts, UncertaintyParts, stiffness_uncertainty_n_per_mm},
};

/// The place of the friction among the parts.
const FRICTION: usize = 6;

impl JointModel<'_> {
    /// The parts of the ± of the torque in N m; `None` where that of a muscle's pull is not known.
    pub(super) fn torque_uncertainty(
        &self,
        workspaces: &mut [Workspace],
        muscles: &[MuscleState],
    ) -> Option<UncertaintyParts> {
        let each: Vec<(UncertaintyParts, f64)> = muscles
            .iter()
            .map(|m| Some((m.answer.uncertainty_parts_n?, 1e-3 * m.arm_mm)))
            .collect::<Option<_>>()?;
        let joined = |i: usize| {
            let add = if i == FRICTION {
                |a, b| a + b
            } else {
                f64::hypot
            };
            each.iter()
                .filter_map(|(parts, arm)| Some((parts.parts()[i]? * arm).abs()))
                .reduce(add)
        };
        let known = each
            .iter()
            .map(|(parts, _)| parts.friction_known)
            .min()
            .unwrap_or_default();
        let parts = UncertaintyParts::from_parts(std::array::from_fn(joined), known);
        Some(match self.shared_shifts(workspaces, muscles, &each) {
            Some(shifts) => UncertaintyParts {
                rubber: shifts.rubber(),
                braid: shifts.braid(),
                ..parts
            },
            None => parts,
        })
    }

    /// By what the torque of two muscles of the same construction changes with their rubber and
    /// braid, in N m. A slack muscle does not pull with another rubber either, and on its own bench
    /// a muscle has neither part.
    fn shared_shifts(
        &self,
        workspaces: &mut [Workspace],
        muscles: &[MuscleState],
        each: &[(UncertaintyParts, f64)],
    ) -> Option<Shifts> {
        let ([first, second], [one, other]) = (muscles, each) else {
            return None;
        };
        let known = |p: &UncertaintyParts| p.fit.is_none() && p.rubber.or(p.braid).is_some();
        let apart = first.answer.slack || second.answer.slack || !known(&one.0) || !known(&other.0);
        if apart || !self.alike {
            return None;
        }
        let mut shifts = |i: usize, m: &MuscleState| {
            let r = &m.answer.response;
            Some(Shifts::of(
                workspaces.get_mut(i)?,
                self.model(i).muscle(),
                (r.pressure_mpa, r.contraction),
            ))
        };
        Some(shifts(0, first)?.combined(one.1, &shifts(1, second)?, other.1))
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
