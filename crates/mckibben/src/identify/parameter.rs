//! What can be identified: named as in the muscle file.

use crate::model::Ideal;
use crate::muscle::Muscle;
use crate::nearest::nearest;
use crate::rubber::{ConstantValue, RubberLaw};
use crate::units::{Dimension, QuantityError, parse_quantity};
use thiserror::Error;

/// A constant or measure that data may tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// A constant of the rubber law, by its place in [`Law::constants`](crate::rubber::Law::constants).
    Law(usize),
    /// One factor on all moduli of the law.
    Modulus,
    /// k of one strand family on the muscle's own diameter.
    Stiffness,
    /// n of k = k₀ (D0/D0₀)ⁿ, for data on several diameters.
    StiffnessExponent,
    /// θ0.
    Angle,
    /// D0.
    OuterDiameter,
    /// s.
    Wall,
    /// L0.
    Length,
    /// t of the braid.
    Thickness,
    /// Inner diameter of a sleeve wider than the tube.
    SleeveDiameter,
    /// Strain at which the strands are straight.
    Crimp,
    /// What both ends together give way.
    Seating,
    /// What both ends together slip under the load of a clamp.
    Slip,
    /// Length held at each end.
    Grip,
    /// k of Tondu & Lopez.
    EndFactor,
    /// C of the friction C·P^β.
    FrictionCoefficient,
    /// β of it.
    FrictionExponent,
    /// μw of friction from contact.
    FrictionLever,
    /// What must be added to the contractions of the data: their zero is not the length at rest.
    ContractionOffset,
}

use Target::{
    Angle, ContractionOffset, Crimp, EndFactor, FrictionCoefficient, FrictionExponent, FrictionLever, Grip,
    Law, Length, Modulus, OuterDiameter, Seating, SleeveDiameter, Slip, Stiffness, StiffnessExponent,
    Thickness, Wall,
};

/// Names that do not depend on the law; some have a second spelling.
const NAMES: [(&str, Target); 26] = [
    ("tube.material.modulus", Modulus),
    ("modulus", Modulus),
    ("braid.stiffness", Stiffness),
    ("braid.stiffness_exponent", StiffnessExponent),
    ("braid.angle", Angle),
    ("braid.thickness", Thickness),
    ("braid.diameter", SleeveDiameter),
    ("braid.crimp", Crimp),
    ("tube.outer_diameter", OuterDiameter),
    ("tube.wall_thickness", Wall),
    ("tube.length", Length),
    ("terminals.seating", Seating),
    ("seating", Seating),
    ("terminals.slip", Slip),
    ("slip", Slip),
    ("terminals.grip", Grip),
    ("grip", Grip),
    ("terminals.end_factor", EndFactor),
    ("friction.coefficient", FrictionCoefficient),
    ("friction.c", FrictionCoefficient),
    ("friction.exponent", FrictionExponent),
    ("friction.beta", FrictionExponent),
    ("friction.lever", FrictionLever),
    ("contraction_offset", ContractionOffset),
    ("stiffness", Stiffness),
    ("end-factor", EndFactor),
];

/// Why a word names no parameter.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ParameterError {
    /// No such name.
    #[error("`{given}` is nothing that can be identified{}; this muscle has {known}", meant(.nearest.as_deref()))]
    Unknown {
        /// As written.
        given: String,
        /// What was probably meant.
        nearest: Option<String>,
        /// All names.
        known: String,
    },
    /// A value that is no quantity.
    #[error("{name}: {error}")]
    Value {
        /// Parameter.
        name: String,
        /// What is wrong.
        error: QuantityError,
    },
    /// Not name, name=start or name=start:low:high.
    #[error("`{given}` is not of the form name, name=start or name=start:low:high")]
    Form {
        /// As written.
        given: String,
    },
    /// Bounds that hold no value, or not the start.
    #[error("{name}: the start {start} must lie between the bounds {low} and {high}, and these apart")]
    Bounds {
        /// Parameter.
        name: String,
        /// Start.
        start: f64,
        /// Lower bound.
        low: f64,
        /// Upper bound.
        high: f64,
    },
}

fn meant(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |name| format!(" (did you mean {name}?)"))
}

impl Target {
    /// All that a muscle has.
    pub fn all(muscle: &Muscle) -> Vec<Target> {
        let laws = (0..muscle.tube().rubber.law.values().len()).map(Law);
        let mut out: Vec<Target> = laws.collect();
        for (_, target) in NAMES {
            if !out.contains(&target) {
                out.push(target);
            }
        }
        out
    }

    /// The name, as in the muscle file.
    pub fn name(self, muscle: &Muscle) -> String {
        if let Law(i) = self {
            return constant(muscle, i).map_or_else(String::new, |c| format!("tube.material.{}", c.name));
        }
        NAMES.iter().find(|n| n.1 == self).map_or_else(String::new, |n| n.0.to_owned())
    }

    /// The target of a name.
    ///
    /// # Errors
    /// [`ParameterError::Unknown`] with the name that was probably meant.
    pub fn parse(text: &str, muscle: &Muscle) -> Result<Self, ParameterError> {
        let given = text.trim();
        if let Some((_, target)) = NAMES.iter().find(|n| n.0 == given) {
            return Ok(*target);
        }
        let all = Target::all(muscle);
        let short = |t: &Target| t.name(muscle).trim_start_matches("tube.material.").to_owned();
        if let Some(t) =
            all.iter().find(|t| t.name(muscle) == given || matches!(t, Law(_)) && short(t) == given)
        {
            return Ok(*t);
        }
        let known: Vec<String> = all.iter().map(|t| t.name(muscle)).collect();
        let list: Vec<&str> = known.iter().map(String::as_str).collect();
        let nearest = nearest(given, list.iter().copied()).map(str::to_owned);
        Err(ParameterError::Unknown { given: given.into(), nearest, known: known.join(", ") })
    }

    /// Its unit; empty for a plain number.
    pub fn unit(self, muscle: &Muscle) -> &'static str {
        match self {
            Law(i) => constant(muscle, i).map_or("", |c| c.constant.unit()),
            Stiffness => "N/mm",
            Angle => "deg",
            OuterDiameter | Wall | Length | Seating | Grip | Thickness | SleeveDiameter | FrictionLever => {
                "mm"
            }
            Slip => "mm/N",
            FrictionCoefficient => "N/MPa^β",
            _ => "",
        }
    }

    fn dimension(self, muscle: &Muscle) -> Dimension {
        match self {
            Law(i) => constant(muscle, i).map_or(Dimension::Ratio, |c| c.constant.dimension),
            Stiffness => Dimension::Stiffness,
            Angle => Dimension::Angle,
            OuterDiameter | Wall | Length | Seating | Grip | Thickness | SleeveDiameter | FrictionLever => {
                Dimension::Length
            }
            Slip => Dimension::Compliance,
            _ => Dimension::Ratio,
        }
    }

    /// Bounds where none are stated: what a muscle can have at all.
    pub(super) fn natural_bounds(self, muscle: &Muscle) -> (f64, f64) {
        match self {
            Law(i) => constant(muscle, i).map_or((f64::NEG_INFINITY, f64::INFINITY), |c| c.constant.bounds),
            StiffnessExponent => (-5.0, 5.0),
            Angle => (1.0, crate::muscle::NEUTRAL_ANGLE_DEG - 0.5),
            FrictionExponent => (0.0, 3.0),
            ContractionOffset => (-0.3, 0.3),
            Wall => (0.0, 0.5 * muscle.outer_diameter_mm()),
            Seating | Grip => (0.0, 0.2 * muscle.length_mm()),
            Slip => (0.0, 0.2 * muscle.length_mm() / usual_pull_n(muscle)),
            Thickness => (1e-6 * muscle.outer_diameter_mm(), 0.3 * muscle.outer_diameter_mm()),
            SleeveDiameter => (muscle.outer_diameter_mm(), 1.5 * muscle.outer_diameter_mm()),
            Crimp => (1e-6, 0.1),
            _ => (0.0, f64::INFINITY),
        }
    }

    /// A half-width of the 95 % interval above this means that the data do not determine it, at a value `v`.
    ///
    /// Constants of the law share half of the shear modulus at rest; stiffness, friction, factors, wall and length are held
    /// against half of themselves; what is measured with a ruler more tightly.
    pub(super) fn limit(self, muscle: &Muscle, v: f64) -> f64 {
        match self {
            Law(i) if constant(muscle, i).is_some_and(|c| c.constant.is_modulus()) => {
                0.5 * muscle.tube().rubber.law.shear_modulus_mpa()
            }
            StiffnessExponent => 1.0,
            FrictionExponent => 0.5,
            ContractionOffset => 0.02,
            Angle => 3.0,
            OuterDiameter | SleeveDiameter => 0.1 * v.abs(),
            EndFactor => 0.2 * v.abs(),
            _ => 0.5 * v.abs(),
        }
    }

    /// Whether it is a measure of the muscle, which a ruler tells.
    pub(super) fn is_geometry(self) -> bool {
        matches!(self, Angle | OuterDiameter | Wall | Length)
    }
}

/// Pull in N of the ideal muscle at 3 bar and rest length: the size of its pulls.
pub(super) fn usual_pull_n(muscle: &Muscle) -> f64 {
    Ideal::new(muscle).pull(0.3, 0.0)
}

/// Constant number `i` of the muscle's law.
fn constant(muscle: &Muscle, i: usize) -> Option<ConstantValue> {
    muscle.tube().rubber.law.constants().into_iter().nth(i)
}

/// A parameter that is free, with what was said of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// What.
    pub target: Target,
    /// Where the search begins; the muscle's own value where `None`.
    pub start: Option<f64>,
    /// Lowest and highest value; the natural ones where `None`.
    pub bounds: Option<(f64, f64)>,
}

impl Parameter {
    /// A free parameter that starts from the muscle's own value.
    pub fn free(target: Target) -> Self {
        Self { target, start: None, bounds: None }
    }

    /// `name`, `name=start` or `name=start:low:high`, quantities with a unit if you like.
    ///
    /// # Errors
    /// [`ParameterError`].
    pub fn parse(text: &str, muscle: &Muscle) -> Result<Self, ParameterError> {
        let (name, values) = match text.split_once('=') {
            None => (text, None),
            Some((name, values)) => (name, Some(values)),
        };
        let target = Target::parse(name, muscle)?;
        let Some(values) = values else { return Ok(Self::free(target)) };
        let numbers = numbers(target, values, muscle)?;
        let label = || target.name(muscle);
        match numbers.as_slice() {
            [start] => Ok(Self { target, start: Some(*start), bounds: None }),
            &[start, low, high] if low < high && start >= low && start <= high => {
                Ok(Self { target, start: Some(start), bounds: Some((low, high)) })
            }
            &[start, low, high] => Err(ParameterError::Bounds { name: label(), start, low, high }),
            _ => Err(ParameterError::Form { given: text.trim().into() }),
        }
    }

    /// `name=low:high`.
    ///
    /// # Errors
    /// [`ParameterError`].
    pub fn parse_bounds(text: &str, muscle: &Muscle) -> Result<(Target, (f64, f64)), ParameterError> {
        let form = || ParameterError::Form { given: format!("{} (bounds are name=low:high)", text.trim()) };
        let (name, values) = text.split_once('=').ok_or_else(form)?;
        let target = Target::parse(name, muscle)?;
        match *numbers(target, values, muscle)?.as_slice() {
            [low, high] if low < high => Ok((target, (low, high))),
            [low, high] => Err(ParameterError::Bounds { name: target.name(muscle), start: low, low, high }),
            _ => Err(form()),
        }
    }
}

fn numbers(target: Target, text: &str, muscle: &Muscle) -> Result<Vec<f64>, ParameterError> {
    let one = |t: &str| {
        parse_quantity(t, target.dimension(muscle))
            .map_err(|error| ParameterError::Value { name: target.name(muscle), error })
    };
    text.split(':').map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_starts_and_bounds_are_read() {
        let m = Muscle::prototype();
        let p = Parameter::parse("tube.material.c10=0.2MPa:50kPa:1MPa", &m).unwrap();
        assert_eq!(p, Parameter { target: Law(0), start: Some(0.2), bounds: Some((0.05, 1.0)) });
        assert_eq!(Parameter::parse("c01", &m).unwrap(), Parameter::free(Law(1)));
        assert_eq!(Parameter::parse("friction.beta = 0.6", &m).unwrap().start, Some(0.6));
        assert_eq!(Parameter::parse_bounds("braid.angle=20:30deg", &m).unwrap(), (Angle, (20.0, 30.0)));
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
