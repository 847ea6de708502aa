//! The parameters of a fit by least squares, with their starts and bounds.

use crate::Result;
use Target::Law;
use mckibben_core::{
    muscle::Muscle,
    rubber::{ConstantValue, Law as RubberOf, RubberLaw},
};
use mckibben_fit::identify::{Target, target_and_numbers};

/// A free parameter, with its start and bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    pub target: Target,
    /// Where the search begins; the value of the muscle where `None`.
    pub start: Option<f64>,
    /// Lowest and highest value; the natural ones where `None`.
    pub bounds: Option<(f64, f64)>,
}

impl Parameter {
    /// A free parameter that starts from the value of the muscle.
    pub fn free(target: Target) -> Self {
        Self {
            target,
            start: None,
            bounds: None,
        }
    }

    /// `name`, `name=start` or `name=start:low:high`, quantities with a unit if you like.
    pub fn parse(text: &str, muscle: &Muscle) -> Result<Self> {
        let (target, numbers) = target_and_numbers(text, muscle)?;
        let free = Self::free(target);
        match *numbers.as_slice() {
            [] => Ok(free),
            [start] => Ok(Self {
                start: Some(start),
                ..free
            }),
            [start, low, high] if low < high && start >= low && start <= high => Ok(Self {
                start: Some(start),
                bounds: Some((low, high)),
                ..free
            }),
            [start, low, high] => {
                Err(out_of_bounds(&target.name(muscle), start, low, high).into())
            }
            _ => Err(format!(
                "`{}` is not of the form name, name=start or name=start:low:high",
                text.trim()
            )
            .into()),
        }
    }
}

/// Bounds that hold no value, or not the start.
fn out_of_bounds(name: &str, start: f64, low: f64, high: f64) -> String {
    let must = format!("must lie between the bounds {low} and {high}, and the bounds must differ");
    format!("{name}: the start {start} {must}")
}

/// Bounds where none are stated: what a muscle can have at all.
pub fn natural_bounds(target: Target, muscle: &Muscle) -> (f64, f64) {
        match target {
            Law(i) => {
                let free = (0.0, (f64::NEG_INFINITY, f64::INFINITY));
                let (value, (low, high)) =
                    constant(muscle, i).map_or(free, |c| (c.value, c.constant.bounds));
                (
                    low,
                    if sets_limit(&muscle.tube().rubber.law, i) {
                        value.max(NO_LOCK)
                    } else {
                        high
                    },
                )
            }
            other => other
                .identify()
                .map_or((0.0, f64::INFINITY), |i| i.bounds(muscle)),
        }
    }

    /// A half-width of the 95 % interval above this means that the data do not determine it, at a
    /// value `v`.
    ///
    /// Half of the shear modulus at rest for the constants of the law, half of the value for
    /// stiffness, friction, factors, wall and length; less for what a ruler measures.
pub fn limit(target: Target, muscle: &Muscle, v: f64) -> f64 {
        match target {
            Law(i) if constant(muscle, i).is_some_and(|c| c.constant.is_modulus()) => {
                0.5 * muscle.tube().rubber.law.shear_modulus_mpa()
            }
            other => other.identify().map_or(0.5 * v.abs(), |i| i.limit(v)),
        }
    }

/// A limit (I1 − 3, or a stretch) of so much is never felt: Gent's law and that of Arruda and Boyce
/// are then neo-Hookean.
pub const NO_LOCK: f64 = 1000.0;

/// Whether constant number `i` says where the chains lock.
pub fn sets_limit(law: &RubberOf, i: usize) -> bool {
    law.locks_at().is_some()
        && law
            .constants()
            .get(i)
            .is_some_and(|c| !c.constant.is_modulus())
}


/// Constant number `i` of the muscle's law.
fn constant(muscle: &Muscle, i: usize) -> Option<ConstantValue> {
    muscle.tube().rubber.law.constants().into_iter().nth(i)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_starts_and_bounds_are_read() {
        let m = Muscle::prototype();
        let p = Parameter::parse("tube.material.c10=0.2MPa:50kPa:1MPa", &m).unwrap();
        assert_eq!(
            p,
            Parameter {
                target: Law(0),
                start: Some(0.2),
                bounds: Some((0.05, 1.0))
            }
        );
        assert_eq!(
            Parameter::parse("c01", &m).unwrap(),
            Parameter::free(Law(1))
        );
        assert_eq!(
            Parameter::parse("friction.beta = 0.6", &m).unwrap().start,
            Some(0.6)
        );
        let message = |text: &str| Parameter::parse(text, &m).unwrap_err().to_string();
        assert!(message("braid.stifness").contains("did you mean braid.stiffness?"));
        assert!(message("c10=1:2:3").contains("must lie between"));
        assert!(message("c10=1:2").contains("name=start:low:high"));
        assert!(message("c10=3mm").contains("tube.material.c10"));
    }
}
