//! What the user should know of an answer.

use crate::analysis::{FailureMode, NoBurst, SAFETY};
use crate::model::{Response, ThickWall};
use crate::muscle::{Muscle, Rubber};
use crate::units::short_numbers;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// Strand strain at which the validated range of all models ends.
pub const VALIDATED_STRAND_STRAIN: f64 = 0.06;

/// How a sentence about the burst begins.
const ABOVE: &str = "ABOVE THE ALLOWED PRESSURE";
const BURST: &str = "BURST";

/// Whether the sentence of a warning is about the burst of the muscle, and so comes first.
pub fn is_of_burst(sentence: &str) -> bool {
    sentence.starts_with(BURST) || sentence.starts_with(ABOVE)
}

/// What the user should know of an answer; as data it is its sentence.
#[derive(Debug, Clone, PartialEq)]
pub enum Warning {
    /// Something about the muscle, the model or the question, whatever the answer.
    Said(String),
    /// The pressure reaches or exceeds the muscle's burst pressure ([`burst`](crate::analysis::burst())).
    Burst {
        /// The largest pressure in question in MPa.
        pressure_mpa: f64,
        /// The burst pressure in MPa.
        burst_mpa: f64,
        /// How the muscle fails there.
        by: FailureMode,
    },
    /// The pressure exceeds the allowed one.
    AboveAllowed {
        /// The largest pressure in question in MPa.
        pressure_mpa: f64,
        /// The allowed pressure in MPa.
        allowed_mpa: f64,
        /// The failure that it keeps its distance from; none where the fittings are rated for it.
        by: Option<FailureMode>,
    },
    /// The burst pressure is not known.
    BurstNotChecked(NoBurst),
    /// A strand carries more than its strength here.
    StrandsBreak {
        /// Tension of one strand in N.
        tension_n: f64,
        /// What it bears in N.
        strength_n: f64,
        /// Pressure in MPa.
        pressure_mpa: f64,
    },
    /// The strands stretch beyond the validated range of the models.
    StrandStrain {
        /// Strain of the strands.
        strain: f64,
    },
    /// A slack muscle was asked for a contraction that its braid does not reach.
    BeyondBraid {
        /// The contraction asked for.
        contraction: f64,
        /// The largest one of the braid.
        largest: f64,
    },
    /// The muscle pulls less when its pressure rises.
    FallsWithPressure {
        /// ∂F/∂P in N/MPa.
        slope_n_per_mpa: f64,
    },
    /// The muscle pushes more than a column of its wall bears.
    Buckles {
        /// Its push in N.
        push_n: f64,
        /// The push in N at which it buckles between two joints.
        bears_n: f64,
    },
    /// The rubber is stretched further than its law has data.
    RubberStretch {
        /// The stretch.
        stretch: f64,
        /// That of the data.
        limit: f64,
        /// The rubber.
        rubber: String,
    },
}

impl Warning {
    /// Whether it is about the burst of the muscle, and so comes first.
    pub fn is_of_burst(&self) -> bool {
        matches!(self, Self::Burst { .. } | Self::AboveAllowed { .. } | Self::BurstNotChecked(_))
    }

    /// Of a stretch beyond the data that a rubber's constants were fitted to.
    pub fn of_stretch(rubber: &Rubber, stretch: f64) -> Option<Self> {
        let limit = rubber.fitted_to_stretch.filter(|limit| stretch > *limit)?;
        let rubber = rubber.name.clone().unwrap_or_else(|| "this rubber".into());
        Some(Self::RubberStretch { stretch, limit, rubber })
    }

    /// How grave it is among those of its kind; `None` for one that is not of a kind.
    fn gravity(&self) -> Option<f64> {
        match self {
            Self::Said(_) | Self::BurstNotChecked(_) => None,
            Self::Burst { pressure_mpa, burst_mpa, .. } => Some(pressure_mpa / burst_mpa),
            Self::AboveAllowed { pressure_mpa, allowed_mpa, .. } => Some(pressure_mpa / allowed_mpa),
            Self::StrandsBreak { tension_n, strength_n, .. } => Some(tension_n / strength_n),
            Self::StrandStrain { strain } => Some(*strain),
            Self::BeyondBraid { contraction, .. } => Some(*contraction),
            Self::FallsWithPressure { slope_n_per_mpa } => Some(-slope_n_per_mpa),
            Self::Buckles { push_n, bears_n } => Some(push_n / bears_n),
            Self::RubberStretch { stretch, limit, .. } => Some(stretch / limit),
        }
    }

    /// Of each kind the gravest, of sentences each once, in the order in which they came.
    pub fn gravest<'a>(all: impl IntoIterator<Item = &'a Warning>) -> Vec<Warning> {
        let mut out: Vec<Warning> = vec![];
        for warning in all {
            let same = |w: &&mut Warning| match warning {
                Self::Said(_) | Self::BurstNotChecked(_) => *w == warning,
                _ => std::mem::discriminant(*w) == std::mem::discriminant(warning),
            };
            match out.iter_mut().find(same) {
                None => out.push(warning.clone()),
                Some(known) if warning.gravity() > known.gravity() => *known = warning.clone(),
                Some(_) => {}
            }
        }
        out
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Said(sentence) => f.write_str(&short_numbers(sentence)),
            Self::Burst { pressure_mpa, burst_mpa, by } => write!(
                f,
                "{BURST}: {pressure_mpa:.3} MPa exceeds the burst pressure of this muscle, {burst_mpa:.3} MPa, at which {by}"
            ),
            Self::AboveAllowed { pressure_mpa, allowed_mpa, by: Some(by) } => write!(
                f,
                "{ABOVE}: {pressure_mpa:.3} MPa; the allowed pressure is {allowed_mpa:.3} MPa, since {by} at {:.3} MPa (safety factor {})",
                allowed_mpa * SAFETY * by.share(),
                SAFETY * by.share()
            ),
            Self::AboveAllowed { pressure_mpa, allowed_mpa, by: None } => {
                write!(f, "{ABOVE}: {pressure_mpa:.3} MPa; the fittings are rated for {allowed_mpa:.3} MPa")
            }
            Self::BurstNotChecked(why) => write!(f, "{BURST} NOT CHECKED: {why}"),
            Self::StrandsBreak { tension_n, strength_n, pressure_mpa } => write!(
                f,
                "the strands break: at {pressure_mpa:.3} MPa one of them carries {tension_n:.1} N, and its strength is {strength_n} N; what is broken does not pull"
            ),
            Self::BeyondBraid { contraction, largest } => write!(
                f,
                "a contraction of {:.1} % is beyond the end of this braid: it contracts by {:.1} % at most (its angle is 54.7° there)",
                100.0 * contraction,
                100.0 * largest
            ),
            Self::StrandStrain { strain } => write!(
                f,
                "the strands stretch by {:.1} %: the validated range ends at {:.0} %",
                100.0 * strain,
                100.0 * VALIDATED_STRAND_STRAIN
            ),
            Self::FallsWithPressure { slope_n_per_mpa } => write!(
                f,
                "the pull falls when the pressure rises ({slope_n_per_mpa:.0} N/MPa): here the muscle widens instead of pulling"
            ),
            Self::Buckles { push_n, bears_n } => write!(
                f,
                "the muscle buckles between two joints: it pushes with {push_n:.1} N, and its wall alone bears {bears_n:.1} N; guide it in a tube, or make it shorter"
            ),
            Self::RubberStretch { stretch, limit, rubber } => write!(
                f,
                "the rubber is stretched to {stretch:.2}; the constants of {rubber} were fitted up to {limit:.2}"
            ),
        }
    }
}

impl From<String> for Warning {
    fn from(sentence: String) -> Self {
        Self::Said(sentence)
    }
}

impl Serialize for Warning {
    fn serialize<S: Serializer>(&self, out: S) -> Result<S::Ok, S::Error> {
        out.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Warning {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        String::deserialize(from).map(Self::Said)
    }
}

/// The strength of one strand in N, where it is known.
pub fn strand_strength_n(muscle: &Muscle) -> Option<f64> {
    muscle.braid().strands?.strength_n
}

/// Tension and strength of one strand in N, where the strands break: such a muscle does not pull.
pub fn overloaded(muscle: &Muscle, response: &Response) -> Option<(f64, f64)> {
    response.strand_tension_n.zip(strand_strength_n(muscle)).filter(|(tension, strength)| tension > strength)
}

/// What the user should know of what a model says of a muscle at a point.
pub fn of_response(muscle: &Muscle, response: &Response) -> Vec<Warning> {
    let rubber = &muscle.tube().rubber;
    let mut out = vec![];
    if let Some((tension_n, strength_n)) = overloaded(muscle, response) {
        out.push(Warning::StrandsBreak { tension_n, strength_n, pressure_mpa: response.pressure_mpa });
    }
    if let Some(strain) = response.braid_tension_n.and_then(|t| muscle.strand_strain(t))
        && strain > VALIDATED_STRAND_STRAIN
    {
        out.push(Warning::StrandStrain { strain });
    }
    if let Some(slope_n_per_mpa) = response.force_per_pressure_mm2
        && slope_n_per_mpa < 0.0
        && response.force_n > 0.0
        && response.contraction >= 0.0
        && !muscle.is_extensile()
    {
        out.push(Warning::FallsWithPressure { slope_n_per_mpa });
    }
    if let Some(bears_n) = buckling_load_n(muscle, response)
        && response.force_n < -bears_n
    {
        out.push(Warning::Buckles { push_n: -response.force_n, bears_n });
    }
    out.extend(response.rubber_stretch().and_then(|stretch| Warning::of_stretch(rubber, stretch)));
    out
}

/// The push in N at which a muscle that extends buckles between two joints, by its wall alone; `None` of a muscle that contracts, and where the infinitely long muscle has no answer.
pub fn buckling_load_n(muscle: &Muscle, response: &Response) -> Option<f64> {
    let model = muscle.is_extensile().then(|| ThickWall::new(muscle))?;
    model.buckling_n(response.pressure_mpa, response.contraction).ok().filter(|n| n.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{ForceModel, Workspace};
    use crate::muscle::{Braid, BraidStiffness, Strands};

    #[test]
    fn of_each_kind_the_gravest_is_kept_and_sentences_once() {
        let said = |s: &str| Warning::Said(s.into());
        let strain = |strain: f64| Warning::StrandStrain { strain };
        let all = [said("a"), strain(0.07), said("b"), strain(0.1), said("a"), strain(0.08)];
        assert_eq!(Warning::gravest(&all), [said("a"), strain(0.1), said("b")]);
    }

    #[test]
    fn soft_and_weak_strands_are_told_of() {
        let strands = Strands { count: 64, section: Some((0.05, 60.0)), strength_n: Some(0.4) };
        let braid = Braid { stiffness: BraidStiffness::OfStrands, strands: Some(strands), ..Braid::paper() };
        let muscle = Muscle::prototype().with_braid(braid).unwrap();
        let model = ThickWall::new(&muscle);
        let response = model.response(&mut Workspace::new(), 0.05, 0.0).unwrap();
        let warnings = of_response(&muscle, &response);
        assert!(matches!(warnings[0], Warning::StrandsBreak { strength_n: 0.4, .. }), "{warnings:?}");
        assert!(matches!(warnings[1], Warning::StrandStrain { .. }), "{warnings:?}");
        // And nothing of a muscle that is well.
        let model = ThickWall::new(&Muscle::prototype());
        let response = model.response(&mut Workspace::new(), 0.2, 0.1).unwrap();
        assert_eq!(of_response(model.muscle(), &response), []);
    }
}
