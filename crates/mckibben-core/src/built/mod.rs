//! What a muscle that is built will pull: the median and the 95 % interval beside a model's pull.
//!
//! A model answers for the muscle as it is described. A muscle that is built is weaker: its ends
//! give way, the slack of its braid must be taken up, and its strands rub on each other. With the
//! model's pull F of the muscle with constants x ([`Constant`]),
//!
//! ```text
//! f(P, ε; x) = a F(P − P0, ε + Δ; μ e^κ, θ0 + Δθ, k) + s h,   s = −1 shortening, +1 lengthening
//! Δ = (d D0 + c N/D0)/L0,   h = η T cosθ
//! ```
//!
//! N the load of a clamp, T cosθ the axial pull of the strands (N). What x does to the pull is that
//! of the infinitely long muscle ([`ThickWall`](crate::model::ThickWall)), beside the pull of the
//! asked model. The constants have a prior that measured muscles tell ([`Experience`]), or, after
//! `identify`, the values and the covariance C that the points of its own bench gave. A prediction
//! is the median f with the half-width u,
//!
//! ```text
//! u² = 1.96² [J C Jᵀ + σg² F0² + σ1²] + (the model's own error)² + (that of its mesh)²
//! ```
//!
//! J = ∂f/∂x, F0 the blocked force at P, σg F0 a smooth difference between model and muscle, σ1 the
//! noise of one point; near the points of its own bench both f and u² follow these
//! ([`learnt`]). Below zero a muscle that contracts is slack.
//!
//! Range: muscles that contract, of stated or estimated constants; five families of measured
//! muscles tell the prior, and `cargo study validation` what it covers where each is left out.

pub mod learnt;
mod measure;
mod measured;
mod median;
mod parts;
mod predictor;
mod prior;
mod twin;

pub use measure::{Left, Measurement};
pub use measured::{MEASURED, NotMeasured, measured_up_to_mpa, measured_values, not_measured};
pub use median::BuiltMedian;
pub use parts::{STIFFNESS_WAY, UncertaintyParts, basis_of, stiffness_uncertainty_n_per_mm};
pub use predictor::{At, Predictor};
pub use prior::{Belief, Experience, Prior};

use crate::{
    analysis::{Evaluation, Options},
    model::{Accuracy, BlockedAt, ModelError, Result},
    muscle::{Constant, Direction, Muscle},
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Half of the 95 % interval of a normal distribution, in standard deviations.
pub const HALF_95: f64 = 1.96;
/// Standard deviation of a stated law of friction, over the half-width that it gives.
const FRICTION_LAW: f64 = 0.41;

/// Standard deviation of a law of friction, over the half-width that it gives.
fn friction_deviation(predictor: &Predictor) -> f64 {
    let friction = Constant::Friction as usize;
    let share = predictor.centre[friction];
    if predictor.is_identified && share > 0.0 {
        predictor.covariance[friction][friction].sqrt() / share
    } else {
        FRICTION_LAW
    }
}

/// What a muscle that is built will pull.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Built {
    /// Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    pub predicted_n: f64,
    /// Lower end of its 95 % interval, N.
    pub predicted_low_n: f64,
    /// Upper end of its 95 % interval, N.
    pub predicted_high_n: f64,
    /// Branch of that pull: the one that is asked, else that of its work.
    pub predicted_direction: Direction,
    /// Pull of the model alone, N: the mean of both branches.
    pub mean_n: f64,
    /// From the model's mean to the median, N.
    pub predicted_shift_n: BuiltShift,
}

/// What a muscle that is built pulls more than the model says, in N; below zero where it pulls
/// less.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct BuiltShift {
    /// By the friction of its braid.
    pub friction: f64,
    /// By the pressure that takes up the slack of the braid.
    pub take_up: f64,
    /// By its ends, which give way.
    pub ends: f64,
    /// By the factor on the pull, and what its own points tell besides.
    pub factor: f64,
}

impl Built {
    /// What the muscle does meanwhile, in words behind its pull.
    pub fn way(&self) -> String {
        match self.predicted_direction {
            Direction::Mean => String::new(),
            branch => format!(" while {}", branch.motion()),
        }
    }

    /// Half of the interval in N.
    pub fn half_n(&self) -> f64 {
        0.5 * (self.predicted_high_n - self.predicted_low_n)
    }
}

/// The branch on which a muscle works: it pulls while it shortens, or pushes while it extends.
pub fn working_direction(muscle: &Muscle, asked: Direction) -> Direction {
    match asked {
        Direction::Mean if muscle.is_extensile() => Direction::Elongation,
        Direction::Mean => Direction::Contraction,
        branch => branch,
    }
}

impl Muscle {
    /// η of the friction that is estimated or was learnt; 0 where the muscle states its own law.
    pub fn friction_share(&self) -> f64 {
        if self.friction().is_some() || self.is_extensile() {
            return 0.0;
        }
        match self.bench() {
            Some(bench) => bench.friction_share,
            None => Prior::of(self, Experience::built_in()).centre[Constant::Friction as usize],
        }
    }
}

impl Evaluation<'_> {
    /// What a muscle that is built pulls where the model's pull, without slack and on the asked
    /// branch, is `force_n`, and the parts of its half-width; `None` where nobody has measured the
    /// model's error.
    pub fn predicted(
        &mut self,
        pressure_mpa: f64,
        contraction: f64,
        force_n: f64,
    ) -> Option<(Built, UncertaintyParts)> {
        let predictor = self.predictor();
        let predictor = Option::as_ref(&predictor)?;
        self.predicted_by(predictor, pressure_mpa, contraction, force_n)
    }

    /// The same by what somebody else knows of the muscle.
    pub fn predicted_by(
        &mut self,
        predictor: &Predictor,
        pressure_mpa: f64,
        contraction: f64,
        force_n: f64,
    ) -> Option<(Built, UncertaintyParts)> {
        let muscle = Arc::clone(&self.model.info().muscle);
        // The error of the model is in the points by which its own constants were found.
        let is_own = muscle
            .bench()
            .is_some_and(|bench| bench.model == self.model.info().name);
        let formula = self.formula_n(pressure_mpa)?.filter(|_| !is_own);
        let predicted_direction = working_direction(&muscle, self.options.direction);
        let sign = predicted_direction.sign();
        let mut at = predictor.at(pressure_mpa, contraction, sign)?;
        for constant in [Constant::Seating, Constant::Compliance, Constant::TakeUp] {
            at.slopes[constant as usize] *= at.share;
        }
        // Without an equilibrium its strands are slack.
        let model_n = force_n - self.friction_n(pressure_mpa, contraction).unwrap_or(0.0);
        let whole = learnt::DISCREPANCY * at.place.blocked_n;
        // Below zero a model's muscle bends or folds; then it pulls no more than the infinitely long
        // one and the smooth difference between both.
        let mean_n = if model_n >= 0.0 || muscle.is_extensile() {
            model_n
        } else {
            model_n.min(at.stated_n + HALF_95 * whole)
        };
        let mut covariance = predictor.covariance.clone();
        let friction = Constant::Friction as usize;
        let friction_n = if muscle.friction().is_some() {
            let mut of_branch = self.with(Options::from(predicted_direction));
            let n = of_branch.friction_n(pressure_mpa, contraction).ok()?;
            at.slopes[friction] = n;
            let relative = friction_deviation(predictor);
            covariance[friction] = [0.0; Constant::ALL.len()];
            covariance.iter_mut().for_each(|row| row[friction] = 0.0);
            covariance[friction][friction] = relative * relative;
            n
        } else {
            sign * predictor.centre[friction] * at.strands_n
        };
        let (own_n, slopes, variance) = match &predictor.learnt {
            Some(learnt) => learnt.at(&at.place, at.slopes),
            None => (0.0, at.slopes, whole * whole),
        };
        let factor = Constant::PullFactor as usize;
        let beyond_n = HALF_95 * measured::beyond_measured(&muscle) * slopes[factor].abs();
        let factor = predictor.centre[factor].exp();
        let unscaled_n = mean_n + at.ends_n + at.take_up_n;
        let shift = BuiltShift {
            friction: friction_n,
            take_up: at.take_up_n,
            ends: at.ends_n,
            factor: own_n + (factor - 1.0) * unscaled_n,
        };
        let largest_n = predictor.learnt.as_ref().map_or(0.0, |l| l.largest_n);
        let single = learnt::SINGLE * largest_n.max(at.place.blocked_n);
        let scale = HALF_95 * predictor.variance_factor.sqrt();
        let scale_n = self
            .model
            .blocked_scale_n(self.workspace, pressure_mpa)
            .ok();
        let parts = UncertaintyParts {
            formula,
            mesh: scale_n.and_then(|scale_n| {
                self.model.mesh_error_n(
                    self.workspace,
                    pressure_mpa,
                    contraction,
                    mean_n,
                    scale_n.abs(),
                )
            }),
            measured: Some(scale * variance.sqrt().hypot(single)),
            ..UncertaintyParts::of_constants(&slopes, &covariance, predictor.is_identified)
                .with_rubber(predictor.limit_n(pressure_mpa, contraction))
                .with_beyond(beyond_n)
        };
        let built = Built {
            mean_n,
            predicted_direction,
            predicted_shift_n: shift,
            ..Built::default()
        };
        let median_n = unscaled_n * factor + own_n + friction_n;
        Some((self.interval(built, median_n, parts), parts))
    }

    /// The median of what a muscle that is built pulls in N, without the ± and without slack, of the
    /// mean of both branches, and half of what lies between them.
    ///
    /// # Errors
    /// As those of the model, and where the infinitely long muscle has no equilibrium.
    pub fn built_branches_n(&mut self, pressure_mpa: f64, contraction: f64) -> Result<[f64; 2]> {
        let muscle = Arc::clone(&self.model.info().muscle);
        let mean = Options {
            direction: Direction::Mean,
            two_sided: true,
            ..self.options
        };
        let mean_n = self.with(mean).force_n(pressure_mpa, contraction)?;
        let none = || ModelError::not_converged(pressure_mpa, contraction);
        let predictor = self.predictor();
        let predictor = Option::as_ref(&predictor).ok_or_else(none)?;
        if predictor.learnt.is_some() {
            let mut model = self.with(mean);
            let of = model.predicted_by(predictor, pressure_mpa, contraction, mean_n);
            let built = of.ok_or_else(none)?.0;
            let friction_n = built.predicted_shift_n.friction;
            let sign = built.predicted_direction.sign();
            return Ok([built.predicted_n - friction_n, sign * friction_n]);
        }
        let (weaker_n, strands_n) = predictor
            .weaker_n(pressure_mpa, contraction)
            .ok_or_else(none)?;
        let half_n = if muscle.friction().is_some() {
            self.half_width_n(pressure_mpa, contraction)?
        } else {
            predictor.centre[Constant::Friction as usize] * strands_n
        };
        let factor = predictor.centre[Constant::PullFactor as usize].exp();
        Ok([factor * (mean_n + weaker_n), half_n])
    }

    /// What each measurement leaves of the ± of the pull of a muscle that is built, at a pressure in
    /// MPa and a contraction; nothing of a muscle that was identified, or where the model's error is
    /// not known.
    pub fn measurements(&mut self, pressure_mpa: f64, contraction: f64) -> Vec<Left> {
        let muscle = Arc::clone(&self.model.info().muscle);
        if self.model.info().accuracy.share_of_blocked.is_none() {
            return vec![];
        }
        let sign = working_direction(&muscle, self.options.direction).sign();
        let predictor = self.predictor();
        Option::as_ref(&predictor).map_or_else(Vec::new, |predictor| {
            predictor.measurements(pressure_mpa, contraction, sign)
        })
    }

    /// How the pull of a model goes on beyond its free contraction, in N.
    pub(crate) fn beyond_free_n(&mut self, p: f64, contraction: f64, free: f64) -> Option<f64> {
        let predictor = self.predictor();
        Option::as_ref(&predictor)?.beyond_n(p, contraction, free)
    }

    /// What is known of the constants of the model's muscle.
    fn predictor(&mut self) -> Arc<Option<Predictor>> {
        let muscle = &self.model.info().muscle;
        self.workspace
            .of_muscle(muscle, || Predictor::of(muscle, Experience::built_in()))
    }

    /// With a median and its interval: a muscle that contracts does not push unless that is asked.
    fn interval(&self, built: Built, median_n: f64, parts: UncertaintyParts) -> Built {
        let half_n = parts.total();
        let pull = |n: f64| {
            if self.options.two_sided {
                n
            } else {
                n.max(0.0)
            }
        };
        Built {
            predicted_n: pull(median_n),
            predicted_low_n: pull(median_n - half_n),
            predicted_high_n: pull(median_n + half_n),
            ..built
        }
    }

    /// The model's own part, where it has one; `None` where nobody has measured it.
    fn formula_n(&mut self, pressure_mpa: f64) -> Option<Option<f64>> {
        let Accuracy {
            share_of_blocked,
            blocked_at,
            ..
        } = self.model.info().accuracy;
        let share = share_of_blocked?;
        if share == 0.0 {
            return Some(None);
        }
        let at = match blocked_at {
            BlockedAt::SamePressure => pressure_mpa,
            BlockedAt::Pressure(p) => p,
        };
        let blocked_n = self.model.blocked_scale_n(self.workspace, at).ok()?;
        Some(Some(share * blocked_n.abs()))
    }
}

#[cfg(test)]
mod tests;
