//! The ± of a pull: one meaning in every model, and its parts.
//!
//! `total_n` is the 95 % half-width of the difference between the pull that a model gives and the pull that a bench measures on the
//! muscle. Its parts are independent and add as squares:
//!
//! - `formula`: the model against the finite elements of the same muscle, a share of the blocked force ([`Accuracy`]);
//! - `mesh`: finite elements against the limit of fine meshes;
//! - `measured`: finite elements against measured muscles, √[((a + b ε/ε_max) F0)² + (c μ A)²], with F0 the blocked force at the same
//!   pressure, ε_max the ideal muscle's largest contraction, μ the rubber's shear modulus and A the wall's cross-section at rest;
//! - `rubber`: what laws of equal standing with the one that a named rubber has disagree on, the largest difference of their pulls by
//!   the thick-wall model;
//! - `friction`: half the width of the hysteresis loop, where the muscle does not state its friction.
//!
//! a, b and c come from four sets of measured muscles (hand-made, 20°; DMSP-20-300; DMSP-10-250; DMSP-10 hose in three lengths), each
//! with its rubber (and, of the three bought ones, the angle) identified from its own points: they hold at least 95 % of the points of
//! every set (means of branches). The loop's width is what holds 95 % of the single branches of the two sets that have them.
//! `mckibben validate` prints the coverage of every set. A muscle whose rubber was not identified from its own pull may be further off.

use crate::model::{Accuracy, BlockedAt, ForceModel, Reference, ThickWall, Workspace};
use crate::muscle::{Muscle, Tube};
use crate::rubber::RubberLaw;
use crate::rubber::library::of_equal_standing;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// a: share of the blocked force.
const MEASURED: f64 = 0.035;
/// b: what is added to it at the ideal muscle's largest contraction.
const MEASURED_BY_CONTRACTION: f64 = 0.01;
/// c: share of μ A.
const MEASURED_BY_WALL: f64 = 0.35;
/// Half the width of the hysteresis loop over the blocked force.
const FRICTION: f64 = 0.12;

/// What is known of every ± besides the model's own part, in a sentence.
pub const STORY: &str = "measured: 3.5 to 4.5 % of the blocked force at the same pressure, growing with the contraction, and 0.35 times shear modulus times wall section, which hold 95 % of the points of each of four sets of measured muscles whose rubber was identified from their own pull; rubber: the largest difference that another law of equal standing makes, by thick-wall; friction: 12 % of the blocked force where the muscle does not state its friction, which holds 95 % of single branches; all parts add as squares";

/// The parts of a ±, each a 95 % half-width in N.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct UncertaintyParts {
    /// The model against finite elements (for a formula of a bought muscle: against that muscle).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub formula: Option<f64>,
    /// Finite elements against the limit of fine meshes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh: Option<f64>,
    /// What laws of equal standing disagree on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rubber: Option<f64>,
    /// Finite elements against measured muscles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measured: Option<f64>,
    /// Friction that the muscle does not state.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
}

impl UncertaintyParts {
    /// The parts with their names, those that there are.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let all = [
            ("formula", self.formula),
            ("mesh", self.mesh),
            ("rubber", self.rubber),
            ("measured", self.measured),
            ("friction", self.friction),
        ];
        all.into_iter().filter_map(|(name, part)| Some((name, part?)))
    }

    /// The root of the sum of their squares, in N.
    pub fn total_n(&self) -> f64 {
        self.named().map(|(_, part)| part * part).sum::<f64>().sqrt()
    }
}

/// The parts of the ± of a pull in N at a pressure and contraction; `None` where nobody has measured the model's error.
pub fn uncertainty<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    pressure_mpa: f64,
    contraction: f64,
    force_n: f64,
) -> Option<UncertaintyParts> {
    let Accuracy { share_of_blocked, blocked_at, reference } = model.accuracy();
    let share = share_of_blocked?;
    let mut blocked = |p: f64| model.blocked_scale_n(workspace, p).ok().map(f64::abs);
    let formula_at = match blocked_at {
        BlockedAt::SamePressure => pressure_mpa,
        BlockedAt::Pressure(p) => p,
    };
    let formula = if share > 0.0 { Some(share * blocked(formula_at)?) } else { None };
    if matches!(reference, Reference::ForceMap { .. }) {
        // Held against measured pulls already.
        return Some(UncertaintyParts { formula, ..UncertaintyParts::default() });
    }
    let blocked = blocked(pressure_mpa)?;
    let muscle = model.muscle();
    Some(UncertaintyParts {
        formula,
        mesh: model.mesh_error_n(workspace, pressure_mpa, contraction, force_n, blocked),
        rubber: rubber_n(workspace, muscle, pressure_mpa, contraction),
        measured: Some(measured_n(muscle, blocked, contraction)),
        friction: muscle.friction().is_none().then_some(FRICTION * blocked),
    })
}

/// Half-width of the difference between finite elements and a measured muscle in N, for its blocked force at the same pressure.
pub fn measured_n(muscle: &Muscle, blocked_n: f64, contraction: f64) -> f64 {
    let share = (contraction / muscle.max_ideal_contraction()).clamp(0.0, 1.0);
    let by_pressure = (MEASURED + MEASURED_BY_CONTRACTION * share) * blocked_n;
    by_pressure.hypot(MEASURED_BY_WALL * wall_n(muscle))
}

/// The same for a point on one branch of a muscle whose friction is not known.
pub fn with_friction_n(measured_n: f64, blocked_n: f64) -> f64 {
    measured_n.hypot(FRICTION * blocked_n)
}

/// The largest difference that another law of equal standing makes, in N; `None` of a rubber that has no such laws.
fn rubber_n(workspace: &mut Workspace, muscle: &Muscle, pressure_mpa: f64, contraction: f64) -> Option<f64> {
    let others = of_equal_standing(muscle);
    let mut pull = |m: &Muscle| ThickWall::new(m).force_n(workspace, pressure_mpa, contraction).ok();
    let own = pull(muscle).filter(|_| !others.is_empty())?;
    let differences = others.into_iter().filter_map(|rubber| {
        let tube = Tube { rubber, ..muscle.tube().clone() };
        Some((pull(&muscle.with_tube(tube).ok()?)? - own).abs())
    });
    differences.reduce(f64::max)
}

/// μ A in N.
fn wall_n(muscle: &Muscle) -> f64 {
    let tube = muscle.tube();
    let section = PI * (tube.outer_radius_mm().powi(2) - tube.inner_radius_mm().powi(2));
    tube.rubber.law.shear_modulus_mpa() * section
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Ideal;
    use crate::muscle::Friction;

    #[test]
    fn parts_add_as_squares() {
        let parts = UncertaintyParts { formula: Some(3.0), friction: Some(4.0), ..Default::default() };
        assert_eq!(parts.total_n(), 5.0);
        assert_eq!(parts.named().map(|p| p.0).collect::<Vec<_>>(), ["formula", "friction"]);
    }

    #[test]
    fn laws_that_disagree_are_a_part() {
        let tube = |name: &str| Tube {
            rubber: crate::rubber::library::find(name).unwrap(),
            ..Muscle::prototype().tube().clone()
        };
        let w = &mut Workspace::new();
        let part = |m: &Muscle, w: &mut Workspace| {
            uncertainty(&ThickWall::new(m), w, 0.25, 0.2, 100.0).unwrap().rubber
        };
        let named = Muscle::prototype().with_tube(tube("soloplast-150318")).unwrap();
        let others = of_equal_standing(&named);
        assert_eq!(part(&named, w).is_some(), !others.is_empty());
        assert_eq!(part(&Muscle::prototype(), w), None);
    }

    #[test]
    fn a_simpler_model_has_a_larger_uncertainty_and_known_friction_a_smaller_one() {
        let (m, w) = (Muscle::prototype(), &mut Workspace::new());
        let of = |model: &dyn ForceModel, w: &mut Workspace| {
            uncertainty(model, w, 0.25, 0.1, 300.0).unwrap().total_n()
        };
        let (ideal, thick) = (of(&Ideal::new(&m), w), of(&ThickWall::new(&m), w));
        assert!(ideal > thick, "{ideal} {thick}");
        let known = m.with_friction(Some(Friction { coefficient: 20.0, exponent: 0.6 })).unwrap();
        assert!(of(&ThickWall::new(&known), w) < thick);
    }
}
