//! The parts of the ± of a prediction, and the ± of a stiffness that follows from it.

use super::HALF_95;
use crate::{
    model::{Accuracy, Reference},
    muscle::{Constant, Constants, Muscle},
};
use serde::{Deserialize, Serialize};
use std::f64::consts::SQRT_2;

/// The share of the ideal muscle's largest contraction over which errors of the pull are
/// independent: with it the ± holds 95 % of the slopes of the measured muscles.
pub const STIFFNESS_WAY: f64 = 0.37;

/// Where the basis of every ± besides the model's own part is written.
const BASIS: &str = "all else: docs/interval.md; all parts add as squares";

/// How the parts of a ± are known, in a sentence.
pub fn basis_of(accuracy: &Accuracy) -> String {
    match accuracy.reference {
        Reference::Unknown => accuracy.reference.to_string(),
        _ => format!("formula: {}; {BASIS}", accuracy.reference),
    }
}

/// The parts of a ±, each a 95 % half-width: of a pull in N, of a torque in N m.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct UncertaintyParts {
    /// The model against finite elements.
    pub formula: Option<f64>,
    /// Finite elements against the limit of fine meshes.
    pub mesh: Option<f64>,
    /// The factor on the pull that differs from muscle to muscle.
    pub pull_factor: Option<f64>,
    /// The same of a size, wall or angle beyond those of measured muscles: a judgement.
    pub beyond_measured: Option<f64>,
    /// Ends that give way.
    pub ends: Option<f64>,
    /// The pressure that takes up the slack of the braid.
    pub take_up: Option<f64>,
    /// The modulus of the rubber.
    pub rubber: Option<f64>,
    /// The angle of the strands.
    pub angle: Option<f64>,
    /// The stiffness of the strands.
    pub braid: Option<f64>,
    /// The friction of the braid.
    pub friction: Option<f64>,
    /// All constants of a muscle that was identified.
    pub fit: Option<f64>,
    /// The smooth difference between the model and measured muscles, and the noise of one point.
    pub measured: Option<f64>,
}

impl UncertaintyParts {
    /// What constants with a covariance leave open, of the slopes of a pull by them: one part for
    /// each, or one for all that were learnt together.
    pub(super) fn of_constants(
        slopes: &Constants,
        covariance: &[Constants],
        together: bool,
    ) -> Self {
        let of = |constant: Constant| {
            let i = constant as usize;
            let half = HALF_95 * slopes[i].abs() * covariance[i][i].sqrt();
            Some(half).filter(|half| *half > 0.0)
        };
        if together {
            let rows = covariance.iter().zip(slopes);
            let variance: f64 = rows
                .map(|(row, a)| a * row.iter().zip(slopes).map(|(c, b)| c * b).sum::<f64>())
                .sum();
            return Self {
                fit: Some(HALF_95 * variance.max(0.0).sqrt()),
                ..Self::default()
            };
        }
        let ends = [of(Constant::Seating), of(Constant::Compliance)];
        Self {
            pull_factor: of(Constant::PullFactor),
            ends: ends.into_iter().flatten().reduce(f64::hypot),
            take_up: of(Constant::TakeUp),
            rubber: of(Constant::Modulus),
            angle: of(Constant::Angle),
            braid: of(Constant::Strands),
            friction: of(Constant::Friction),
            ..Self::default()
        }
    }

    /// With what the limit of another muscle's law makes of the pull, in N.
    pub(super) fn with_rubber(self, limit_n: Option<f64>) -> Self {
        Self {
            rubber: limit_n.map(f64::abs).or(self.rubber),
            ..self
        }
    }

    /// With the share of the factor on the pull that a size beyond the measured ones has, in N.
    pub(super) fn with_beyond(self, beyond_n: f64) -> Self {
        match self.pull_factor {
            Some(all_n) if beyond_n > 1e-9 => Self {
                pull_factor: Some((all_n * all_n - beyond_n * beyond_n).max(0.0).sqrt()),
                beyond_measured: Some(beyond_n),
                ..self
            },
            _ => self,
        }
    }

    /// The parts with their names, in the order of their fields.
    fn slots(&mut self) -> [(&'static str, &mut Option<f64>); 12] {
        [
            ("formula", &mut self.formula),
            ("mesh", &mut self.mesh),
            ("muscle to muscle", &mut self.pull_factor),
            (
                "beyond measured muscles (judgement)",
                &mut self.beyond_measured,
            ),
            ("ends", &mut self.ends),
            ("take-up", &mut self.take_up),
            ("rubber", &mut self.rubber),
            ("angle", &mut self.angle),
            ("stiffness of the braid", &mut self.braid),
            ("friction", &mut self.friction),
            ("own points", &mut self.fit),
            ("model against tests", &mut self.measured),
        ]
    }

    /// The parts with their names, those that there are.
    pub fn named(mut self) -> impl Iterator<Item = (&'static str, f64)> {
        let named = |(name, part): (_, &mut Option<f64>)| Some((name, (*part)?));
        self.slots().map(named).into_iter().flatten()
    }

    /// Two of them with each part joined, by name.
    pub(crate) fn joined(
        mut self,
        mut other: Self,
        join: impl Fn(&'static str, f64, f64) -> f64,
    ) -> Self {
        for ((name, own), (_, part)) in self.slots().into_iter().zip(other.slots()) {
            *own = match (*own, *part) {
                (Some(a), Some(b)) => Some(join(name, a, b)),
                (one, other) => one.or(other),
            };
        }
        self
    }

    /// What becomes of each part.
    pub(crate) fn each(mut self, of: impl Fn(f64) -> f64) -> Self {
        for (_, part) in self.slots() {
            *part = part.map(&of);
        }
        self
    }

    /// The root of the sum of their squares, in their unit.
    pub fn total(&self) -> f64 {
        self.named()
            .map(|(_, part)| part * part)
            .sum::<f64>()
            .sqrt()
    }
}

/// 95 % half-width of the stiffness of a muscle in N/mm, for the parts of the ± of its pull: the
/// pulls at two contractions that are [`STIFFNESS_WAY`] of the ideal muscle's largest contraction
/// apart err independently of each other, each by its ± without friction, which moves a whole
/// branch up or down. The slope of the line between them errs by √2 times that over the way between
/// them.
pub fn stiffness_uncertainty_n_per_mm(muscle: &Muscle, parts: &UncertaintyParts) -> f64 {
    let way_mm = STIFFNESS_WAY * muscle.max_ideal_contraction().abs() * muscle.length_mm();
    let without_friction = UncertaintyParts {
        friction: None,
        ..*parts
    };
    SQRT_2 * without_friction.total() / way_mm
}
