//! The constants of a built muscle as parameters of its file.

use super::{Identified, Posterior, Target, posterior::Zero};
use mckibben_core::{
    built::{HALF_95, Prior},
    muscle::{
        Constant, Muscle,
        measures::{ANGLE, SEATING, SLIP, TAKE_UP},
    },
};

/// A constant whose deviation fell below this share of that before was learnt from the points.
const LEARNT: f64 = 0.7;

/// How a constant stands in the muscle file.
pub struct Shown {
    pub constant: Constant,
    /// The parameter of that name; the factor on the pull and the share of friction have none.
    pub target: Option<Target>,
    /// The value without the constant.
    zero: f64,
    /// What one unit of the constant makes of the value; `None` where it is the logarithm of a factor.
    factor: Option<f64>,
}

impl Shown {
    /// `None` where a muscle has no such constant.
    fn new(constant: Constant, base: &Muscle) -> Option<Self> {
        let d0_mm = base.outer_diameter_mm();
        let (target, factor) = match constant {
            Constant::PullFactor => (None, None),
            Constant::Seating => (Some(Target::Measure(&SEATING)), Some(d0_mm)),
            Constant::Compliance => (Some(Target::Measure(&SLIP)), Some(1.0 / d0_mm)),
            Constant::TakeUp => (Some(Target::Measure(&TAKE_UP)), Some(1.0)),
            // A law of one constant is that constant.
            Constant::Modulus => match base.tube().rubber.law.values().len() {
                1 => (Some(Target::Law(0)), None),
                _ => (Some(Target::Modulus), None),
            },
            Constant::Angle => (Some(Target::Measure(&ANGLE)), Some(1.0)),
            Constant::Strands => {
                base.family_stiffness_n_per_mm()?;
                (Some(Target::Stiffness), None)
            }
            Constant::Friction => (None, Some(1.0)),
        };
        let value = target.and_then(|target| target.value(base));
        Some(Self {
            constant,
            target,
            zero: value.unwrap_or(if factor.is_some() { 0.0 } else { 1.0 }),
            factor,
        })
    }

    pub fn all(base: &Muscle) -> impl Iterator<Item = Self> {
        Constant::ALL
            .into_iter()
            .filter_map(|constant| Self::new(constant, base))
    }

    /// Whether a name means it: a factor on all moduli, or the one modulus of the law.
    pub fn is(&self, target: Target, base: &Muscle) -> bool {
        let law = &base.tube().rubber.law;
        let moduli = || {
            law.constants()
                .into_iter()
                .filter(|c| c.constant.is_modulus() && c.value != 0.0)
        };
        let is_modulus = match target {
            Target::Modulus => true,
            Target::Law(i) => {
                let own = law.constants().into_iter().nth(i);
                own.is_some_and(|c| c.constant.is_modulus() && c.value != 0.0)
                    && moduli().count() == 1
            }
            _ => false,
        };
        self.target == Some(target) || is_modulus && self.constant == Constant::Modulus
    }

    /// By how many of its deviations before the points moved it, and by how many of those by which
    /// such points move it; 0 of one that they do not tell.
    pub fn moved(&self, found: &Posterior) -> [f64; 2] {
        const TOLD: f64 = 0.02;
        let i = self.constant as usize;
        let Prior { centre, deviation } = &found.prior;
        let before = deviation[i] * deviation[i];
        let told = before - found.covariance[i][i];
        if found.at_bound[i] || told <= TOLD * before {
            return [0.0; 2];
        }
        [before, told].map(|variance| (found.constants[i] - centre[i]) / variance.sqrt())
    }

    pub fn name(&self, base: &Muscle) -> String {
        match self.target {
            Some(target) => target.name(base),
            None if self.constant == Constant::Friction => "friction_share".to_owned(),
            None => self.constant.to_string(),
        }
    }

    fn value_of(&self, x: f64) -> f64 {
        match self.factor {
            Some(factor) => self.zero + factor * x,
            None => self.zero * x.exp(),
        }
    }

    /// The constant at a value of a parameter that means it: of one modulus its factor counts.
    pub fn constant_of(&self, target: Target, value: f64, base: &Muscle) -> f64 {
        let zero = match target {
            Target::Law(_) => target.value(base).unwrap_or(self.zero),
            _ => self.zero,
        };
        match self.factor {
            Some(factor) => (value - zero) / factor,
            None => (value / zero).ln(),
        }
    }

    /// The constant as it was found; none that is known.
    pub fn identified(
        &self,
        base: &Muscle,
        muscle: &Muscle,
        found: &Posterior,
    ) -> Option<Identified> {
        let i = self.constant as usize;
        let before = found.prior.deviation[i];
        let is_law = self.constant == Constant::Friction && muscle.friction().is_some();
        if before == 0.0 || is_law {
            return None;
        }
        let deviation = (found.variance_factor * found.covariance[i][i]).sqrt();
        let value = self.value_of(found.constants[i]);
        let slope = self.factor.unwrap_or(value).abs();
        Some(Identified {
            target: self.target,
            name: self.name(base),
            start: self.value_of(found.prior.centre[i]),
            value,
            unit: self.target.map_or("", |target| target.unit(base)),
            standard_error: slope * deviation,
            half_width: HALF_95 * slope * deviation,
            prior_standard_deviation: Some(slope * before),
            identifiable: deviation < LEARNT * before,
            at_bound: found.at_bound[i],
            matters: true,
        })
    }
}

impl Zero {
    /// The zero of the load cell as it was found.
    pub fn identified(&self) -> Identified {
        Identified {
            target: Some(Target::ForceOffset),
            name: "force_offset".to_owned(),
            start: 0.0,
            value: self.value_n,
            unit: "N",
            standard_error: self.deviation_n,
            half_width: HALF_95 * self.deviation_n,
            prior_standard_deviation: Some(self.before_n),
            identifiable: self.deviation_n < LEARNT * self.before_n,
            at_bound: false,
            matters: true,
        }
    }
}
