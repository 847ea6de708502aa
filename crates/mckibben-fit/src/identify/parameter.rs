//! The parameters that can be identified, named as in the muscle file.

use Target::{
    ContractionOffset, DeadVolume, ForceOffset, Law, Modulus, Stiffness, StiffnessExponent,
};
use mckibben_core::{
    muscle::{
        Measure, Muscle,
        measures::{Identify, of_section},
    },
    nearest::{meant, nearest},
    rubber::{ConstantValue, Law as RubberOf, RubberLaw},
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
    /// n of k = k₀ (D0/D0₀)ⁿ, for data on several diameters.
    StiffnessExponent,
    /// A measure of the muscle.
    Measure(&'static Measure),
    /// Offset of the contractions of the data, whose zero is not the length at rest.
    ContractionOffset,
    /// Volume of hose and fittings in the measured volumes, in mm³.
    DeadVolume,
    /// What the load cell shows of no pull, in N: it is in every measured pull.
    ForceOffset,
}

/// Names that are neither of the law nor of a measure; some have a second spelling.
const NAMES: [(&str, Target); 8] = [
    ("tube.material.modulus", Modulus),
    ("modulus", Modulus),
    ("braid.stiffness", Stiffness),
    ("stiffness", Stiffness),
    ("braid.stiffness_exponent", StiffnessExponent),
    ("contraction_offset", ContractionOffset),
    ("dead_volume", DeadVolume),
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
pub struct ParameterError(String);

impl Target {
    pub fn all(muscle: &Muscle) -> Vec<Target> {
        let laws = (0..muscle.tube().rubber.law.values().len()).map(Law);
        let first = [Modulus, Stiffness, StiffnessExponent];
        let measures = measures().map(|(m, _)| Target::Measure(m));
        laws.chain(first)
            .chain(measures)
            .chain([ContractionOffset, DeadVolume, ForceOffset])
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

    /// The target of a name.
    pub fn parse(text: &str, muscle: &Muscle) -> Result<Self, ParameterError> {
        let given = text.trim();
        if let Some((_, target)) = NAMES.iter().find(|n| n.0 == given) {
            return Ok(*target);
        }
        if let Some((m, _)) = measures().find(|(m, i)| m.key == given || i.also.contains(&given)) {
            return Ok(Target::Measure(m));
        }
        let all = Target::all(muscle);
        let short = |t: &Target| {
            t.name(muscle)
                .trim_start_matches("tube.material.")
                .to_owned()
        };
        if let Some(t) = all
            .iter()
            .find(|t| t.name(muscle) == given || matches!(t, Law(_)) && short(t) == given)
        {
            return Ok(*t);
        }
        let known: Vec<String> = all.iter().map(|t| t.name(muscle)).collect();
        let meant = meant(nearest(given, known.iter().map(String::as_str)));
        let known = known.join(", ");
        Err(ParameterError(format!(
            "`{given}` cannot be identified{meant}; the parameters of this muscle are {known}"
        )))
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
            DeadVolume => Dimension::Volume,
            ForceOffset => Dimension::Force,
            Target::Measure(m) => m.dimension,
            _ => Dimension::Ratio,
        }
    }

    /// Whether it is a constant of the rubber law, or the factor on its moduli.
    pub(super) fn is_of_law(self) -> bool {
        matches!(self, Law(_) | Modulus)
    }

    /// Whether it is a constant of the law of the friction.
    pub(super) fn is_of_friction(self) -> bool {
        matches!(self, Target::Measure(m) if m.section() == "friction")
    }

    /// Whether a muscle file holds it.
    pub(crate) fn is_in_file(self) -> bool {
        !matches!(
            self,
            StiffnessExponent | ContractionOffset | DeadVolume | ForceOffset
        )
    }

    /// How a measure is identified.
    pub(super) fn identify(self) -> Option<&'static Identify> {
        match self {
            Target::Measure(m) => m.identify.as_ref(),
            _ => None,
        }
    }

    /// Bounds where none are stated: what a muscle can have at all.
    pub(super) fn natural_bounds(self, muscle: &Muscle) -> (f64, f64) {
        match self {
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
            StiffnessExponent => (-5.0, 5.0),
            ContractionOffset => (-0.3, 0.3),
            DeadVolume => (0.0, f64::INFINITY),
            ForceOffset => (f64::NEG_INFINITY, f64::INFINITY),
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
    pub(super) fn limit(self, muscle: &Muscle, v: f64) -> f64 {
        match self {
            Law(i) if constant(muscle, i).is_some_and(|c| c.constant.is_modulus()) => {
                0.5 * muscle.tube().rubber.law.shear_modulus_mpa()
            }
            StiffnessExponent => 1.0,
            ContractionOffset => 0.02,
            DeadVolume => 0.2 * muscle.rest_volume_mm3(),
            other => other.identify().map_or(0.5 * v.abs(), |i| i.limit(v)),
        }
    }

    /// Whether it is a measure of the muscle that a ruler gives.
    pub(super) fn is_geometry(self) -> bool {
        self.identify().is_some_and(|i| i.is_geometry)
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
    pub fn parse(text: &str, muscle: &Muscle) -> Result<Self, ParameterError> {
        let (target, numbers) = split(text, muscle)?;
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
            [start, low, high] => Err(out_of_bounds(&target.name(muscle), start, low, high)),
            _ => Err(form(text.trim())),
        }
    }

    /// The word that [`parse`](Self::parse) reads as this parameter.
    pub fn word(&self, muscle: &Muscle) -> String {
        let name = self.target.name(muscle);
        let own = self.bounds.and(self.target.value(muscle));
        match (self.start.or(own), self.bounds) {
            (Some(start), Some((low, high))) => format!("{name}={start}:{low}:{high}"),
            (Some(start), None) => format!("{name}={start}"),
            (None, _) => name,
        }
    }

    pub fn parse_bounds(
        text: &str,
        muscle: &Muscle,
    ) -> Result<(Target, (f64, f64)), ParameterError> {
        let (target, numbers) = split(text, muscle)?;
        match *numbers.as_slice() {
            [low, high] if low < high => Ok((target, (low, high))),
            [low, high] => Err(out_of_bounds(&target.name(muscle), low, low, high)),
            _ => Err(form(&format!("{} (bounds are name=low:high)", text.trim()))),
        }
    }
}

/// Bounds that hold no value, or not the start.
fn out_of_bounds(name: &str, start: f64, low: f64, high: f64) -> ParameterError {
    let must = format!("must lie between the bounds {low} and {high}, and the bounds must differ");
    ParameterError(format!("{name}: the start {start} {must}"))
}

fn form(given: &str) -> ParameterError {
    ParameterError(format!(
        "`{given}` is not of the form name, name=start or name=start:low:high"
    ))
}

/// The target of a word, and the numbers behind it.
fn split(text: &str, muscle: &Muscle) -> Result<(Target, Vec<f64>), ParameterError> {
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
    use mckibben_core::muscle::measures::ANGLE;

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
        assert_eq!(p.word(&m), "tube.material.c10=0.2:0.05:1");
        assert_eq!(Parameter::parse(&p.word(&m), &m).unwrap(), p);
        assert_eq!(
            Parameter::parse("c01", &m).unwrap(),
            Parameter::free(Law(1))
        );
        assert_eq!(
            Parameter::parse("friction.beta = 0.6", &m).unwrap().start,
            Some(0.6)
        );
        assert_eq!(
            Parameter::parse_bounds("braid.angle=20:30deg", &m).unwrap(),
            (Target::Measure(&ANGLE), (20.0, 30.0))
        );
        for target in Target::all(&m) {
            assert_eq!(Target::parse(&target.name(&m), &m).unwrap(), target);
        }
    }

    #[test]
    fn what_is_no_parameter_is_told() {
        let m = Muscle::prototype();
        let message = |text: &str| Parameter::parse(text, &m).unwrap_err().to_string();
        assert!(message("braid.stifness").contains("did you mean braid.stiffness?"));
        assert!(message("c10=1:2:3").contains("must lie between"));
        assert!(message("c10=1:2").contains("name=start:low:high"));
        assert!(message("c10=3mm").contains("tube.material.c10"));
    }
}
