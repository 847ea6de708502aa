//! How a built muscle differs from the one that is described, at any pressure and contraction.

use super::{
    Experience, HALF_95, Prior,
    learnt::{Learnt, Place},
    measured::beyond_measured,
    twin::Twin,
};
use crate::{
    analysis::bisect,
    muscle::{Bench, Constant, Constants, Muscle, OwnPoint, Rubber, Tube},
    rubber::{Law, NeoHookean, RubberLaw},
};
use std::sync::OnceLock;

/// A constant, the muscle with it below and above its centre, and half of what lies between.
type Side = (Constant, [Twin; 2], f64);

/// What the constants make of the pull of a muscle.
pub struct Predictor {
    /// Centre of the constants, beside what the muscle states.
    pub centre: Constants,
    /// Their covariance.
    pub covariance: Vec<Constants>,
    /// Whether they come from points of the muscle, or of one of its kind.
    pub is_identified: bool,
    /// What the points of its own bench tell near them.
    pub learnt: Option<Learnt>,
    /// Factor on the variances of differences between model and muscle.
    pub variance_factor: f64,
    stated: Twin,
    built: Twin,
    /// The muscle itself, and it with a constant below and above its centre and half of what lies
    /// between, where the ± needs it.
    muscle: Muscle,
    sides: OnceLock<Option<Vec<Side>>>,
    /// The muscle without the limit of its law, where that is the limit of another muscle.
    unlocked: Option<Twin>,
}

/// A built muscle at a pressure and a contraction.
pub struct At {
    /// Pull of the infinitely long muscle as it is described, in N.
    pub stated_n: f64,
    /// What ends that give way add to the pull in N.
    pub ends_n: f64,
    /// What the take-up pressure adds to it.
    pub take_up_n: f64,
    /// How much of what slack and ends leave open counts: neither gives way by less than nothing, so
    /// that a pressure which the take-up may need as a whole gains no more than its centre.
    pub share: f64,
    /// T cosθ of the strands in N.
    pub strands_n: f64,
    /// ∂F by each constant, of a branch.
    pub slopes: Constants,
    /// Pull of the infinitely long muscle as it is built, in N.
    pub force_n: f64,
    /// The place for the smooth difference, with its blocked force at this pressure.
    pub place: Place,
}

impl Predictor {
    /// Of a muscle: by what its own points told, or by the measured muscles.
    pub fn of(muscle: &Muscle, experience: &Experience) -> Option<Self> {
        let prior = Prior::of(muscle, experience);
        match muscle.any_bench() {
            Some(bench) => Self::identified(muscle, bench, &prior, experience),
            None => Self::about(muscle, prior.centre, prior.covariance()),
        }
    }

    /// Of a muscle that was identified, or that was made from one.
    fn identified(
        muscle: &Muscle,
        bench: &Bench,
        prior: &Prior,
        experience: &Experience,
    ) -> Option<Self> {
        let mut centre = [0.0; Constant::ALL.len()];
        centre[Constant::PullFactor as usize] = bench.pull_factor.ln();
        centre[Constant::Friction as usize] = bench.friction_share;
        let mut covariance = prior.covariance();
        for (a, row) in bench.constants.iter().zip(&bench.covariance) {
            for (b, value) in bench.constants.iter().zip(row) {
                covariance[*a as usize][*b as usize] = *value;
            }
        }
        let scatter = if bench.laboratory.is_some() || muscle.differs_from_identified() {
            Some((&experience.specimen, beyond_measured(muscle)))
        } else {
            (!muscle.has_own_points()).then_some((&experience.length, 0.0))
        };
        if let Some((scatter, beyond)) = scatter {
            let unknown = Prior::unstated(muscle, experience);
            carry_over(scatter, &unknown, bench, &mut centre, &mut covariance);
            let factor = Constant::PullFactor as usize;
            covariance[factor][factor] += beyond * beyond;
        }
        let mut out = Self::about(muscle, centre, covariance)?;
        out.is_identified = true;
        out.variance_factor = bench.variance_factor.map_or(1.0, |factor| factor.max(1.0));
        out.unlocked = unlocked(muscle);
        if scatter.is_none() {
            let row = |&(p, e, sign, off_n): &OwnPoint| {
                let mut at = out.at(p, e, sign)?;
                // A stated law errs by a share of itself.
                if let Some(law) = muscle.friction() {
                    at.slopes[Constant::Friction as usize] = sign * law.half_width_n(p, 0.0);
                }
                Some((at.place, off_n, at.slopes))
            };
            let rows: Option<Vec<_>> = bench.own_points.iter().map(row).collect();
            out.learnt =
                rows.and_then(|rows| Learnt::new(&rows, &bench.own_noise, bench.pressure_mpa.1));
        }
        Some(out)
    }

    /// Of a muscle whose constants are known with a covariance.
    pub fn about(muscle: &Muscle, centre: Constants, covariance: Vec<Constants>) -> Option<Self> {
        Some(Self {
            stated: Twin::new(muscle),
            built: Twin::new(&muscle.with_constants(&centre).ok()?),
            muscle: muscle.clone(),
            sides: OnceLock::new(),
            unlocked: None,
            centre,
            covariance,
            is_identified: false,
            learnt: None,
            variance_factor: 1.0,
        })
    }

    /// The muscle with each constant that has no slope in closed form beside its centre.
    fn make_sides(&self) -> Option<Vec<Side>> {
        let mut sides = vec![];
        for constant in [Constant::Modulus, Constant::Angle, Constant::Strands] {
            let i = constant as usize;
            let half = self.covariance[i][i].sqrt();
            if half == 0.0 {
                continue;
            }
            let side = |by: f64| {
                let mut x = self.centre;
                x[i] += by;
                Some(Twin::new(&self.muscle.with_constants(&x).ok()?))
            };
            sides.push((constant, [side(-half)?, side(half)?], half));
        }
        Some(sides)
    }

    /// What lies between the pull of the muscle as it is described and as it is built, in N, of the
    /// mean of both branches, and T cosθ of its strands.
    pub fn weaker_n(&self, pressure_mpa: f64, contraction: f64) -> Option<(f64, f64)> {
        let built = self.built.state(pressure_mpa, contraction)?;
        let stated_n = self.stated.force_n(pressure_mpa, contraction)?;
        Some((built.force_n - stated_n, built.strands_n))
    }

    /// How much less the infinitely long muscle as it is described pulls at a contraction than at
    /// its free one, in N.
    pub fn beyond_n(&self, pressure_mpa: f64, contraction: f64, free: f64) -> Option<f64> {
        let pull = |e: f64| self.stated.force_n(pressure_mpa, e);
        Some(pull(contraction)? - pull(free)?)
    }

    /// What the limit of a law that the pull of another muscle gave makes of the pull, in N: it is not
    /// that of the rubber.
    pub(super) fn limit_n(&self, pressure_mpa: f64, contraction: f64) -> Option<f64> {
        let unlocked = self.unlocked.as_ref()?;
        Some(
            unlocked.force_n(pressure_mpa, contraction)?
                - self.built.force_n(pressure_mpa, contraction)?,
        )
    }

    /// At a pressure in MPa and a contraction, on a branch by its sign; `None` where the infinitely
    /// long muscle has no equilibrium.
    pub fn at(&self, pressure_mpa: f64, contraction: f64, sign: f64) -> Option<At> {
        let state = self.built.state(pressure_mpa, contraction)?;
        let take_up_mpa = self.centre[Constant::TakeUp as usize];
        let taken_up_n = if take_up_mpa > 0.0 {
            self.built
                .force_n(pressure_mpa + take_up_mpa, contraction)?
        } else {
            state.force_n
        };
        let k = state.stiffness_n_per_mm;
        let d0_mm = self.muscle.outer_diameter_mm();
        let sides = self.sides.get_or_init(|| self.make_sides()).as_ref()?;
        let mut slopes: Constants = [0.0; Constant::ALL.len()];
        let mut set = |constant: Constant, slope: f64| slopes[constant as usize] = slope;
        set(Constant::PullFactor, state.force_n);
        set(Constant::Seating, -k * d0_mm);
        set(Constant::Compliance, -k * state.load_n / d0_mm);
        set(Constant::TakeUp, -state.per_pressure_mm2);
        set(Constant::Friction, sign * state.strands_n);
        for (constant, [below, above], half) in sides {
            let at = |twin: &Twin| twin.force_n(pressure_mpa, contraction);
            // One side may have no equilibrium: the other then stands for both.
            let mirror = |n: f64| 2.0 * state.force_n - n;
            let (below, above) = (at(below), at(above));
            let low_n = below.or(above.map(mirror)).unwrap_or_default();
            let high_n = above.or(below.map(mirror)).unwrap_or_default();
            set(*constant, 0.5 * (high_n - low_n) / half);
        }
        let least_mpa = pressure_mpa.max(self.built.ends.take_up_mpa);
        let take_up = Constant::TakeUp as usize;
        let share = least_mpa / HALF_95 / self.covariance[take_up][take_up].sqrt();
        let stated_n = self.stated.force_n(pressure_mpa, contraction)?;
        // Shortened beyond what its strands allow a muscle pushes more with more pressure.
        let take_up_n = (state.force_n - taken_up_n).min(0.0);
        Some(At {
            stated_n,
            ends_n: state.force_n - stated_n - take_up_n,
            take_up_n,
            share: share.min(1.0),
            strands_n: state.strands_n,
            slopes,
            force_n: state.force_n,
            place: Place {
                pressure_mpa,
                contraction,
                blocked_n: self.built.force_n(least_mpa, 0.0)?.abs(),
            },
        })
    }

    /// Where the muscle as it is built pulls nothing.
    pub fn free_contraction(&self, pressure_mpa: f64) -> f64 {
        let pulls = |e: f64| self.built.force_n(pressure_mpa, e).is_some_and(|n| n > 0.0);
        bisect(0.0, self.muscle.max_ideal_contraction(), 30, pulls).0
    }
}

/// What another specimen or length keeps of what was learnt of one: both are drawn from the muscles of
/// the prior, x0 and σ², and differ by a deviation d, so that b = 1 − d²/(2 σ²) is common to them:
/// x' = x0 + b (x − x0), C' = b C bᵀ + (1 − b²) σ². With d = 0 all of it, from d = σ √2 on nothing.
fn carry_over(
    scatter: &Constants,
    unknown: &Prior,
    bench: &Bench,
    centre: &mut Constants,
    covariance: &mut [Constants],
) {
    let kept: Constants =
        std::array::from_fn(|i| (1.0 - 0.5 * (scatter[i] / unknown.deviation[i]).powi(2)).max(0.0));
    let shifts = bench.constants.iter().zip(&bench.shift);
    for (constant, shift) in shifts {
        let i = *constant as usize;
        centre[i] += (1.0 - kept[i]) * (unknown.centre[i] - shift);
    }
    for (i, row) in covariance.iter_mut().enumerate() {
        row.iter_mut()
            .zip(kept)
            .for_each(|(value, b)| *value *= kept[i] * b);
        row[i] += (1.0 - kept[i].powi(2)) * unknown.deviation[i].powi(2);
    }
}

/// A muscle that differs from the identified one by more than its length, with a neo-Hookean rubber of
/// the same modulus where its law locks.
fn unlocked(muscle: &Muscle) -> Option<Twin> {
    let rubber = &muscle.tube().rubber;
    if rubber.law.locks_at().is_none() || !muscle.differs_from_identified() {
        return None;
    }
    let mu_mpa = rubber.law.shear_modulus_mpa();
    let tube = Tube {
        rubber: Rubber {
            name: None,
            law: Law::NeoHookean(NeoHookean { mu_mpa }),
            ..rubber.clone()
        },
        ..muscle.tube().clone()
    };
    Some(Twin::new(&muscle.with_tube(tube).ok()?))
}
