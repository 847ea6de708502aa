//! The parameters that can be identified, named as in the muscle file.

use Target::{ForceOffset, Law, Modulus, Stiffness};
use mckibben_core::{
    muscle::{
        Measure, Muscle,
        measures::{Identify, of_section},
    },
    nearest::{meant, nearest},
    rubber::{ConstantValue, RubberLaw},
    units::{Dimension, parse_quantity},
};
use thiserror::Error;

/// A constant or measure that data may tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// A constant of the rubber law, by its place in
    /// [`Law::constants`](mckibben_core::rubber::Law::constants).
    Law(usize),
    /// One factor on all moduli of the law.
    Modulus,
    /// k of one strand family on the diameter of the muscle.
    Stiffness,
    /// What the load cell shows without a pull: of the bench, not of the muscle.
    ForceOffset,
    /// A measure of the muscle.
    Measure(#[doc(hidden)] &'static Measure),
}

/// Names that are neither of the law nor of a measure.
const NAMES: [(&str, Target); 3] = [
    ("tube.material.modulus", Modulus),
    ("braid.stiffness", Stiffness),
    ("force_offset", ForceOffset),
];

/// The measures that can be identified, by the tables of the muscle file: those of the braid that a
/// ruler does not measure.
fn measures() -> impl Iterator<Item = (&'static Measure, &'static Identify)> {
    ["braid", "tube", "terminals", "friction"]
        .into_iter()
        .flat_map(of_section)
        .filter_map(|m| Some((m, m.identify.as_ref()?)))
}

/// Why a word names no parameter.
#[derive(Debug, Error)]
#[error("{0}")]
pub struct ParameterError(pub(crate) String);

impl Target {
    /// All constants and measures that a muscle states.
    pub fn all(muscle: &Muscle) -> Vec<Target> {
        let laws = (0..muscle.tube().rubber.law.values().len()).map(Law);
        let measures = measures().map(|(m, _)| Target::Measure(m));
        laws.chain([Modulus, Stiffness, ForceOffset])
            .chain(measures)
            .collect()
    }

    /// The name, as in the muscle file.
    pub fn name(self, muscle: &Muscle) -> String {
        if let Law(i) = self {
            return constant(muscle, i)
                .map_or_else(String::new, |c| format!("tube.material.{}", c.name));
        }
        if let Target::Measure(measure) = self {
            return measure.key.to_owned();
        }
        NAMES
            .iter()
            .find(|n| n.1 == self)
            .map_or_else(String::new, |n| n.0.to_owned())
    }

    /// The target of a name, or of its last part.
    pub fn parse(text: &str, muscle: &Muscle) -> Result<Self, ParameterError> {
        let given = text.trim();
        let all = Target::all(muscle);
        let is_given = |target: &&Target| {
            let name = target.name(muscle);
            let other = target.identify().map_or(&[][..], |i| i.also);
            name == given || name.rsplit('.').next() == Some(given) || other.contains(&given)
        };
        if let Some(target) = all.iter().find(is_given) {
            return Ok(*target);
        }
        Err(unknown(given, all.into_iter(), muscle))
    }

    /// Its unit; empty for a plain number.
    pub fn unit(self, muscle: &Muscle) -> &'static str {
        match self {
            Target::Measure(m) => m.unit(),
            other => other.dimension(muscle).unit_inside().name,
        }
    }

    fn dimension(self, muscle: &Muscle) -> Dimension {
        match self {
            Law(i) => constant(muscle, i).map_or(Dimension::Ratio, |c| c.constant.dimension),
            Stiffness => Dimension::Stiffness,
            ForceOffset => Dimension::Force,
            Target::Measure(m) => m.dimension,
            Modulus => Dimension::Ratio,
        }
    }

    /// A name with a value: `name=value`, a quantity with a unit if you like.
    ///
    /// # Errors
    /// What is no name, or no value of it.
    pub fn parse_value(text: &str, muscle: &Muscle) -> Result<(Self, f64), ParameterError> {
        let (target, numbers) = target_and_numbers(text, muscle)?;
        match *numbers.as_slice() {
            [value] => Ok((target, value)),
            _ => Err(form(text, "name=value")),
        }
    }

    /// A name with bounds: `name=low:high`.
    ///
    /// # Errors
    /// What is no name, or no bounds of it.
    pub fn parse_bounds(text: &str, muscle: &Muscle) -> Result<(Self, (f64, f64)), ParameterError> {
        let (target, numbers) = target_and_numbers(text, muscle)?;
        match *numbers.as_slice() {
            [low, high] if low < high => Ok((target, (low, high))),
            _ => Err(form(text, "name=low:high")),
        }
    }
}

#[doc(hidden)]
impl Target {
    /// Whether it is a constant of the rubber law, or the factor on its moduli.
    pub fn is_of_law(self) -> bool {
        matches!(self, Law(_) | Modulus)
    }

    /// Whether it is a constant of the law of the friction.
    pub fn is_of_friction(self) -> bool {
        matches!(self, Target::Measure(m) if m.section() == "friction")
    }

    /// How a measure is identified.
    pub fn identify(self) -> Option<&'static Identify> {
        match self {
            Target::Measure(m) => m.identify.as_ref(),
            _ => None,
        }
    }

    /// A half-width of the 95 % interval above this means that the data do not determine it, at a
    /// value `v`: half of the shear modulus at rest for the moduli of the law, half of the value for
    /// most others; less for what a ruler measures.
    pub fn limit(self, muscle: &Muscle, v: f64) -> f64 {
        match self {
            Law(i) if constant(muscle, i).is_some_and(|c| c.constant.is_modulus()) => {
                0.5 * muscle.tube().rubber.law.shear_modulus_mpa()
            }
            other => other.identify().map_or(0.5 * v.abs(), |i| i.limit(v)),
        }
    }

    /// A change that matters to a search from a value `v`.
    pub fn scale(self, muscle: &Muscle, v: f64) -> f64 {
        match self.limit(muscle, v) {
            limit if limit > 0.0 => limit,
            _ => 1.0,
        }
    }
}

/// Constant number `i` of the muscle's law.
fn constant(muscle: &Muscle, i: usize) -> Option<ConstantValue> {
    muscle.tube().rubber.law.constants().into_iter().nth(i)
}

/// A word that names none of some parameters.
pub fn unknown(
    given: &str,
    known: impl Iterator<Item = Target>,
    muscle: &Muscle,
) -> ParameterError {
    let known: Vec<String> = known.map(|t| t.name(muscle)).collect();
    let meant = meant(nearest(given, known.iter().map(String::as_str)));
    let known = known.join(", ");
    ParameterError(format!(
        "`{given}` cannot be identified{meant}; the parameters of this muscle are {known}"
    ))
}

fn form(given: &str, form: &str) -> ParameterError {
    ParameterError(format!("`{}` is not of the form {form}", given.trim()))
}

/// The target of a word, and the numbers behind it.
pub fn target_and_numbers(
    text: &str,
    muscle: &Muscle,
) -> Result<(Target, Vec<f64>), ParameterError> {
    let (name, values) = text
        .split_once('=')
        .map_or((text, None), |(name, values)| (name, Some(values)));
    let target = Target::parse(name, muscle)?;
    let one = |t: &str| {
        parse_quantity(t, target.dimension(muscle))
            .map_err(|error| ParameterError(format!("{}: {error}", target.name(muscle))))
    };
    let numbers = values
        .into_iter()
        .flat_map(|values| values.split(':'))
        .map(one)
        .collect::<Result<_, _>>();
    Ok((target, numbers?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mckibben_core::muscle::measures::{ANGLE, FRICTION_EXPONENT};

    #[test]
    fn names_values_and_bounds_are_read() {
        let m = Muscle::prototype();
        let value = |text: &str| Target::parse_value(text, &m).unwrap();
        assert_eq!(value("tube.material.c10=0.2MPa"), (Law(0), 0.2));
        assert_eq!(Target::parse("c01", &m).unwrap(), Law(1));
        let exponent = Target::Measure(&FRICTION_EXPONENT);
        assert_eq!(value("friction.beta = 0.6"), (exponent, 0.6));
        assert_eq!(
            Target::parse_bounds("braid.angle=20:30deg", &m).unwrap(),
            (Target::Measure(&ANGLE), (20.0, 30.0))
        );
        for target in Target::all(&m) {
            assert_eq!(Target::parse(&target.name(&m), &m).unwrap(), target);
        }
    }

    #[test]
    fn what_is_no_parameter_is_told() {
        let m = Muscle::prototype();
        let value = |text: &str| Target::parse_value(text, &m).unwrap_err().to_string();
        let bounds = |text: &str| Target::parse_bounds(text, &m).unwrap_err().to_string();
        assert!(value("braid.stifness").contains("did you mean braid.stiffness?"));
        assert!(bounds("c10=3:2").contains("name=low:high"));
        assert!(value("c10=1:2").contains("name=value"));
        assert!(value("c10=3mm").contains("tube.material.c10"));
    }
}
