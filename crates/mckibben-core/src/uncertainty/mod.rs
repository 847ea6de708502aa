//! The ± of a pull: one meaning in every model, and its parts.
//!
//! `total_n` is the 95 % half-width of the difference between the pull that a model gives and the
//! pull that a bench measures on the muscle. Its parts are independent and add as squares:
//!
//! - `formula`: the model against the finite elements of the same muscle, a share of the blocked
//!   force ([`Accuracy`]);
//! - `mesh`: finite elements against the limit of fine meshes;
//! - `measured`: finite elements against measured muscles, √[((a + b ε/ε_max) F0)² + (c μ A)²],
//!   with F0 the blocked force at the same pressure, ε_max the ideal muscle's largest contraction,
//!   μ the rubber's shear modulus and A the wall's cross-section at rest;
//! - `rubber`: what laws of equal standing with the one that a named rubber has disagree on, the
//!   largest difference of their pulls by the thick-wall model; and, of a named rubber that was
//!   pulled along one axis alone, the difference that 19 % of its stiffness make by the same model,
//!   as a square beside it; and, of a rubber that stands in for others or follows from a hardness,
//!   what the factor makes within which its stiffness is known;
//! - `braid`: of strands whose stiffness k is known within a factor f, the larger of the
//!   differences that k f and k/f make, by the thick-wall model
//! - `data_sheet`: of a muscle whose sleeve is named as it is sold, what no data sheet tells (which
//!   diameter is meant, at which angle and length), as a share of the pressure's share of the pull,
//!   P ∂F/∂P: with the strands on the stated outer diameter the slopes of commercial muscles were 6
//!   to 11 % off, the pulls of a mesh up to 18 %. It is 20 % of the blocked force and 30 % of the
//!   pull at half of the stroke;
//! - `friction`: what the pull on one branch of the hysteresis loop differs by from the answer.
//!   Where the muscle does not state its friction: half the width of the loop as a share of the
//!   blocked force, and on a branch, where it is estimated
//!   ([`OF_TENSION`](crate::muscle::Friction::OF_TENSION)), the estimate h itself, so that h lies
//!   between 0 and twice the estimate. Where it does: the half-width h = C·P^β + μw G of its law
//!   and what the law errs by, h (1 + d), as long as no branch is stated; d h on a branch.
//! - `fit`, in the place of all of these inside of the range of the bench that the muscle was
//!   identified from ([`Bench`]): the scatter of its points about the fit, and the fit's own
//!   half-width from the covariance of the constants. Outside of the range it turns into the others
//!   over a quarter of the range's width: squares are weighted by 1 − x and x, x from 0 at the edge
//!   to 1. Nowhere, and at no other length, is the ± of that muscle below the scatter.
//!
//! - `transfer`, beside the others, of constants that were identified from another specimen: by
//!   somebody else ([`Muscle::laboratory`]), or of a muscle that differs by more than its length. A
//!   share of the blocked force at the same pressure, which the pulls of the same hose with other
//!   fittings, measured in two laboratories, give. Of a law that locks, `rubber` then has what its
//!   limit makes, against a neo-Hookean rubber of the same modulus: the limit that the pull of one
//!   muscle gives is not that of its rubber.
//! - `length_transfer`, beside the others, of a muscle whose constants were identified at other
//!   lengths ([`Muscle::off_identified_lengths`]): a share of the blocked force at the same
//!   pressure, in proportion to |Δ(D0/L0)| up to a largest one, which three lengths of a DMSP-10
//!   hose and five of a DMSP-20 hose give.
//!
//! Below the lowest pressure of the bench that the constants come from, the blocked force of
//! `measured`, `transfer` and `length_transfer` is that at this pressure: what a sleeve takes up
//! before it pulls is an error of the pressure, which does not vanish with it.
//!
//! a, b and c come from five sets of measured muscles (hand-made, 20° and 30°; DMSP-20-300;
//! DMSP-10-250; DMSP-10 hose in three lengths), each with its rubber (and, of the three bought
//! ones, the angle) identified from its own points: they hold at least 95 % of the points of every
//! set (means of branches). The loop's width is what holds 95 % of the single branches of the 20°
//! muscle and of the DMSP-10 hose (of the 30° muscle 91 %); d what holds as many of them where C
//! and β were identified from both branches. What one axis does not tell comes from six rubbers
//! that were measured in several modes up to a stretch of 3 (`data/treloar`,
//! `data/rubber_biaxial`): with the law that is recommended from the uniaxial test alone, against
//! the one that is recommended from all, it holds every pull of each rubber (a test below compares
//! them).
//!
//! The ± of a stiffness follows from that of the pull ([`stiffness_uncertainty_n_per_mm`]): the
//! pulls at two contractions that are [`STIFFNESS_WAY`] of the ideal muscle's largest contraction
//! apart err independently of each other, each by its ± without friction, which moves a whole
//! branch up or down. The slope of the line between them errs by √2 times that over the way between
//! them. The slopes of the measured muscles give the way; a test compares them.
//!
//! `mckibben validate` prints the coverage of every set. A muscle whose rubber was not identified
//! from its own pull may be further off: no muscle is known whose tube and sleeve are stated as
//! sold and whose pull was published.

mod shifts;

pub use shifts::{ONE_AXIS, Shifts};

use crate::{
    analysis::{Evaluation, Options},
    answer::Answer,
    model::{Accuracy, BlockedAt, ForceModel, Reference, Response, ThickWall},
    muscle::{Bench, Direction, Muscle},
    rubber::RubberLaw,
};
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, SQRT_2};

/// a: share of the blocked force.
const MEASURED: f64 = 0.035;
/// b: what is added to it at the ideal muscle's largest contraction.
const MEASURED_BY_CONTRACTION: f64 = 0.01;
/// c: share of μ A.
const MEASURED_BY_WALL: f64 = 0.42;
/// What predictions from stated dimensions are off by, over P ∂F/∂P.
const DATA_SHEET: f64 = 0.2;
/// Half the width of the hysteresis loop over the blocked force.
const FRICTION: f64 = 0.12;
/// d: what a stated law of friction errs by, over the half-width that it gives.
const FRICTION_LAW: f64 = 0.81;

/// The share of the ideal muscle's largest contraction over which errors of the pull are
/// independent: with it the ± holds 95 % of the slopes of the measured muscles.
pub const STIFFNESS_WAY: f64 = 0.37;

/// What another specimen of a product, with other fittings in another laboratory, differs by over
/// the blocked force: it covers 95 % of the points of DMSP-10 muscles of one laboratory by the
/// constants from the other one, in both directions.
const TRANSFER: f64 = 0.24;

/// What the constants of one length err by at another one, over the blocked force, for each unit of
/// |Δ(D0/L0)|, and at most: with it the ± holds 92 % of the points or more of each of three lengths
/// of a DMSP-10 hose and of five of a DMSP-20 hose by the constants of each other one. The blocked
/// force of the second scatters from length to length, as of specimens.
const LENGTH: f64 = 13.0;
const LENGTH_MOST: f64 = 0.38;

/// What identification from 10 points leaves, over the blocked force: 4 to 10 % of four measured
/// muscles.
const IDENTIFIED: f64 = 0.06;

/// The model that all others are held against.
const ELEMENTS: &str = "fe";

/// Where the basis of every ± besides the model's own part is written.
const BASIS: &str = "model against tests, rubber, braid, data sheet, friction, fit, another length, \
    another specimen: docs/models.md, \"What is known of the errors\"; all parts add as squares";

/// How the parts of a ± are known, in a sentence.
pub fn basis_of(accuracy: &Accuracy) -> String {
    match accuracy.reference {
        Reference::Unknown => accuracy.reference.to_string(),
        Reference::ForceMap(_) => format!("formula: {}", accuracy.reference),
        _ => format!("formula: {}; {BASIS}", accuracy.reference),
    }
}

/// The parts of a ±, each a 95 % half-width: of a pull in N, of a torque in N m.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct UncertaintyParts {
    /// The model against finite elements (for a formula of a bought muscle: against that muscle).
    pub formula: Option<f64>,
    /// Finite elements against the limit of fine meshes.
    pub mesh: Option<f64>,
    /// What laws of equal standing disagree on, and what a rubber that is known from one axis may
    /// differ by in two.
    pub rubber: Option<f64>,
    /// What a stiffness of the strands that is an estimate may differ by.
    pub braid: Option<f64>,
    /// What no data sheet of a sleeve as it is sold tells.
    pub data_sheet: Option<f64>,
    /// Finite elements against measured muscles.
    pub measured: Option<f64>,
    /// One branch of the hysteresis loop against the answer.
    pub friction: Option<f64>,
    /// The bench that the muscle was identified from, against the fit.
    pub fit: Option<f64>,
    /// Another specimen, with other fittings or another angle, against the one that was identified.
    pub transfer: Option<f64>,
    /// Another length of the muscle against those that were identified.
    pub length_transfer: Option<f64>,
    /// How the friction is known.
    #[serde(skip)]
    pub friction_known: FrictionKnown,
}

/// How the friction of a muscle is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum FrictionKnown {
    /// It is not.
    #[default]
    Unknown,
    /// On a branch, by [`OF_TENSION`](crate::muscle::Friction::OF_TENSION).
    Estimated,
    /// The muscle states it.
    Stated,
}

impl UncertaintyParts {
    /// The parts with their names, in the order of their fields.
    fn slots(&mut self) -> [(&'static str, &mut Option<f64>); 10] {
        let friction = match self.friction_known {
            FrictionKnown::Unknown => "friction unknown",
            FrictionKnown::Estimated => "friction estimated",
            FrictionKnown::Stated => "friction",
        };
        [
            ("formula", &mut self.formula),
            ("mesh", &mut self.mesh),
            ("rubber", &mut self.rubber),
            ("stiffness of the braid", &mut self.braid),
            ("data sheets", &mut self.data_sheet),
            ("model against tests", &mut self.measured),
            (friction, &mut self.friction),
            ("fit", &mut self.fit),
            ("another specimen", &mut self.transfer),
            ("another length", &mut self.length_transfer),
        ]
    }

    /// The parts in the order of their fields.
    pub(crate) fn parts(mut self) -> [Option<f64>; 10] {
        self.slots().map(|(_, part)| *part)
    }

    /// From the parts in the order of their fields.
    pub(crate) fn from_parts(parts: [Option<f64>; 10], friction_known: FrictionKnown) -> Self {
        let mut out = Self {
            friction_known,
            ..Self::default()
        };
        out.slots()
            .into_iter()
            .zip(parts)
            .for_each(|((_, slot), part)| *slot = part);
        out
    }

    /// The parts with their names, those that there are.
    pub fn named(mut self) -> impl Iterator<Item = (&'static str, f64)> {
        self.slots()
            .map(|(name, part)| (name, *part))
            .into_iter()
            .filter_map(|(name, part)| Some((name, part?)))
    }

    /// With so much of `fit` that the sum is no less.
    fn at_least(self, least: f64) -> Self {
        let rest = Self { fit: None, ..self }.total();
        if self.total() >= least {
            self
        } else {
            Self {
                fit: Some((least * least - rest * rest).sqrt()),
                ..self
            }
        }
    }

    /// The root of the sum of their squares, in their unit.
    pub fn total(&self) -> f64 {
        self.named()
            .map(|(_, part)| part * part)
            .sum::<f64>()
            .sqrt()
    }
}

/// 95 % half-width of the stiffness of a muscle in N/mm, for the parts of the ± of its pull.
pub fn stiffness_uncertainty_n_per_mm(muscle: &Muscle, parts: &UncertaintyParts) -> f64 {
    let way_mm = STIFFNESS_WAY * muscle.max_ideal_contraction().abs() * muscle.length_mm();
    let without_friction = UncertaintyParts {
        friction: None,
        ..*parts
    };
    SQRT_2 * without_friction.total() / way_mm
}

impl Evaluation<'_> {
    /// The parts of the ± of a pull in N at a pressure and contraction, on a branch of the
    /// hysteresis loop; `None` where nobody has measured the model's error.
    pub fn uncertainty(
        &mut self,
        pressure_mpa: f64,
        contraction: f64,
        force_n: f64,
    ) -> Option<UncertaintyParts> {
        let muscle = self.model.muscle();
        let own = Pull {
            evaluation: self,
            pressure_mpa,
            contraction,
            force_n,
        }
        .of_specimen()?;
        let of_another = muscle.laboratory().is_some() || muscle.differs_from_identified();
        let transfer = of_another.then_some(TRANSFER);
        let length = muscle
            .off_identified_lengths()
            .map(|off| (LENGTH * off).min(LENGTH_MOST));
        // A formula of a bought muscle was held against measured pulls.
        if is_of_product(self.model) || transfer.is_none() && length.is_none() {
            return Some(own);
        }
        let blocked = self.blocked_n(pressure_mpa.max(muscle.identified_from_mpa()))?;
        let of_blocked = |share: f64| share * blocked;
        Some(UncertaintyParts {
            transfer: transfer.map(of_blocked),
            length_transfer: length.map(of_blocked),
            ..own
        })
    }

    /// 95 % half-width in N of the pull of a muscle that was identified by this model from 10
    /// points on both branches, by the experience of the measured muscles; `None` for a formula of
    /// a bought muscle, and where nobody has measured the model's error.
    pub fn identified_n(&mut self, pressure_mpa: f64) -> Option<f64> {
        self.model
            .info()
            .accuracy
            .share_of_blocked
            .filter(|_| !is_of_product(self.model))?;
        Some(IDENTIFIED * self.blocked_n(pressure_mpa)?)
    }

    /// What a pull on one branch may differ by, in N, from an answer, besides all else.
    fn friction_uncertainty_n(
        &mut self,
        pressure_mpa: f64,
        contraction: f64,
        blocked_n: f64,
    ) -> f64 {
        let unknown = FRICTION * blocked_n;
        let law = match self.friction_known() {
            FrictionKnown::Unknown => return unknown,
            FrictionKnown::Estimated => 1.0,
            FrictionKnown::Stated if self.options.direction.is_mean() => 1.0 + FRICTION_LAW,
            FrictionKnown::Stated => FRICTION_LAW,
        };
        self.half_width_n(pressure_mpa, contraction)
            .map_or(unknown, |half| law * half)
    }

    fn friction_known(&self) -> FrictionKnown {
        match self.model.muscle().friction() {
            Some(_) => FrictionKnown::Stated,
            None if self.has_friction() => FrictionKnown::Estimated,
            None => FrictionKnown::Unknown,
        }
    }

    /// The ± in N that a mean of the branches would have on one of them, where its friction is
    /// estimated.
    pub fn on_branch_n(&mut self, mean: &Answer) -> Option<f64> {
        let Response {
            pressure_mpa,
            contraction,
            ..
        } = mean.response;
        let friction_share = self.model.muscle().friction_share();
        let parts = mean
            .uncertainty_parts_n
            .filter(|parts| parts.friction.is_some())?;
        if friction_share == 0.0 || !mean.direction.is_mean() {
            return None;
        }
        let mut model = self.with(Options {
            friction_share,
            ..self.options
        });
        let half_n = model.half_width_n(pressure_mpa, contraction).ok()?;
        Some(
            UncertaintyParts {
                friction: Some(half_n),
                ..parts
            }
            .total(),
        )
    }

    /// The blocked force that shares are taken of.
    fn blocked_n(&mut self, pressure_mpa: f64) -> Option<f64> {
        self.model
            .blocked_scale_n(self.workspace, pressure_mpa)
            .ok()
            .map(f64::abs)
    }
}

/// Whether it is a formula of a bought muscle.
fn is_of_product(model: &dyn ForceModel) -> bool {
    matches!(model.info().accuracy.reference, Reference::ForceMap(_))
}

/// The bench of the model's muscle, or of the same one in another length, where it says something
/// of this model: its constants were fitted with it, or with finite elements, from which the other
/// model's distance is known.
fn bench_of(model: &dyn ForceModel) -> Option<&Bench> {
    let bench = model.muscle().bench_of_lengths()?;
    let to_elements = model.info().accuracy.share_of_blocked.is_some() && !is_of_product(model);
    (bench.model == model.info().name || bench.model == ELEMENTS && to_elements).then_some(bench)
}

/// A pull whose ± is wanted.
struct Pull<'e, 'a> {
    evaluation: &'e mut Evaluation<'a>,
    pressure_mpa: f64,
    contraction: f64,
    force_n: f64,
}

impl<'a> Pull<'_, 'a> {
    fn model(&self) -> &'a dyn ForceModel {
        self.evaluation.model
    }

    /// The parts of the ± of the specimen that was identified, or of any muscle.
    fn of_specimen(&mut self) -> Option<UncertaintyParts> {
        let Some(bench) = bench_of(self.model()) else {
            return self.of_any();
        };
        let own = self.model().muscle().bench().is_some();
        let outside = if own {
            bench.outside(self.pressure_mpa, self.contraction)
        } else {
            1.0
        };
        let inside = if outside < 1.0 {
            Some(self.of_bench(bench)?)
        } else {
            None
        };
        let general = if outside > 0.0 {
            Some(self.of_any()?)
        } else {
            None
        };
        let parts = match (inside, general) {
            (Some(inside), Some(general)) => Some(between(&inside, &general, outside)),
            (one, other) => one.or(other),
        };
        parts.map(|parts| parts.at_least(bench.scatter_n))
    }

    /// What is known of any muscle.
    fn of_any(&mut self) -> Option<UncertaintyParts> {
        let formula = self.formula_n()?;
        if is_of_product(self.model()) {
            // Held against measured pulls already.
            return Some(UncertaintyParts {
                formula,
                ..UncertaintyParts::default()
            });
        }
        let p = self.pressure_mpa;
        let e = self.contraction;
        let muscle = self.model().muscle();
        let blocked = self.evaluation.blocked_n(p)?;
        let lowest = muscle.identified_from_mpa();
        let measured_blocked = if p < lowest {
            self.evaluation.blocked_n(lowest)?
        } else {
            blocked
        };
        let shifts = Shifts::of(self.evaluation.workspace, muscle, (p, e));
        // The mesh has no friction.
        let force_n = self.force_n - self.evaluation.friction_n(p, e).unwrap_or(0.0);
        Some(UncertaintyParts {
            formula,
            mesh: self
                .model()
                .mesh_error_n(self.evaluation.workspace, p, e, force_n, blocked),
            rubber: shifts.rubber(),
            braid: shifts.braid(),
            data_sheet: muscle.braid().sleeve.as_ref().and_then(|_| {
                let response = ThickWall::new(muscle)
                    .response(self.evaluation.workspace, p, e)
                    .ok()?;
                Some(DATA_SHEET * p * response.force_per_pressure_mm2?)
            }),
            measured: Some(measured_n(muscle, measured_blocked, e)),
            friction: Some(self.evaluation.friction_uncertainty_n(p, e, blocked)),
            friction_known: self.evaluation.friction_known(),
            ..UncertaintyParts::default()
        })
    }

    /// The model's own part, where it has one; `None` where nobody has measured it.
    fn formula_n(&mut self) -> Option<Option<f64>> {
        let Accuracy {
            share_of_blocked,
            blocked_at,
            ..
        } = self.model().info().accuracy;
        let share = share_of_blocked?;
        let at = match blocked_at {
            BlockedAt::SamePressure => self.pressure_mpa,
            BlockedAt::Pressure(p) => p,
        };
        if share > 0.0 {
            Some(Some(share * self.evaluation.blocked_n(at)?))
        } else {
            Some(None)
        }
    }

    /// The ± on the bench that the muscle was identified from.
    fn of_bench(&mut self, bench: &Bench) -> Option<UncertaintyParts> {
        let formula = if bench.model == self.model().info().name {
            None
        } else {
            self.formula_n()?
        };
        let known = match self.model().muscle().friction() {
            None => bench.saw_the_loop(),
            Some(_) => {
                !self.evaluation.options.direction.is_mean()
                    && bench.branches.contains(&self.evaluation.options.direction)
            }
        };
        let at = (self.pressure_mpa, self.contraction);
        let fit_n = bench.half_width_n(at.0, at.1);
        let friction = if known {
            None
        } else {
            let blocked = self.evaluation.blocked_n(at.0)?;
            let general = self.evaluation.friction_uncertainty_n(at.0, at.1, blocked);
            let measured = self.measured_friction_n(bench, fit_n);
            Some(measured.map_or(general, |measured| measured.min(general)))
        };
        Some(UncertaintyParts {
            formula,
            friction,
            fit: Some(fit_n),
            friction_known: self.evaluation.friction_known(),
            ..UncertaintyParts::default()
        })
    }

    /// Of a muscle whose law of friction was fitted to both branches, what a branch differs by from
    /// their mean: the half-width h of the loop, which is no unknown. A point on a branch lies
    /// within h and the ± of the fit, so that both add up: (h + fit)² = fit² + part².
    fn measured_friction_n(&mut self, bench: &Bench, fit_n: f64) -> Option<f64> {
        let both = Direction::BRANCHES
            .iter()
            .all(|b| bench.branches.contains(b));
        self.model().muscle().friction().filter(|_| both)?;
        let p = self.pressure_mpa;
        let e = self.contraction;
        let half = self.evaluation.half_width_n(p, e).ok()?;
        Some((half * (half + 2.0 * fit_n)).sqrt())
    }
}

/// Squares of the parts, weighted by 1 − x and x.
fn between(inside: &UncertaintyParts, outside: &UncertaintyParts, x: f64) -> UncertaintyParts {
    let inner = inside.parts();
    let outer = outside.parts();
    let part = |i: usize| {
        let square = |v: Option<f64>| v.unwrap_or(0.0).powi(2);
        let mixed = ((1.0 - x) * square(inner[i]) + x * square(outer[i])).sqrt();
        inner[i].or(outer[i]).map(|_| mixed)
    };
    UncertaintyParts::from_parts(std::array::from_fn(part), inside.friction_known)
}

/// Half-width of the difference between finite elements and a measured muscle in N, for its blocked
/// force at the same pressure.
fn measured_n(muscle: &Muscle, blocked_n: f64, contraction: f64) -> f64 {
    let share = (contraction / muscle.max_ideal_contraction()).clamp(0.0, 1.0);
    let by_pressure = (MEASURED + MEASURED_BY_CONTRACTION * share) * blocked_n;
    by_pressure.hypot(MEASURED_BY_WALL * wall_n(muscle))
}

/// μ A in N.
fn wall_n(muscle: &Muscle) -> f64 {
    let tube = muscle.tube();
    let section = PI * (tube.outer_radius_mm().powi(2) - tube.inner_radius_mm().powi(2));
    muscle.rubber().law.shear_modulus_mpa() * section
}

#[cfg(test)]
mod tests;
