//! What tolerances of the workshop and the supply do to the pull.

use crate::{Build, OperatingPoint};
use mckibben::model::{ModelError, Workspace};
use mckibben::muscle::measures::MeasureValues;
use mckibben::muscle::{Braid, BraidStiffness, Measure, Muscle, MuscleError};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Tolerances: half-widths, each ±.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(default)]
#[schemars(rename = "ToleranceFields")]
pub struct Tolerances {
    /// Measures of the muscle.
    #[serde(flatten)]
    pub measures: MeasureValues,
    /// Pressure, MPa.
    pub pressure_mpa: f64,
    /// All moduli of the rubber, as a share.
    #[schemars(extend("x-quantity" = "ratio"))]
    pub modulus: f64,
    /// Stiffness k of a strand family, as a share.
    #[schemars(extend("x-quantity" = "ratio"))]
    pub stiffness: f64,
}

/// What varies, by its half-width at a corner.
#[derive(Clone, Copy)]
enum Varied {
    Measure(&'static Measure),
    Pressure,
    Modulus,
    Stiffness,
}

impl Tolerances {
    /// Most quantities that vary: every corner of them is computed.
    pub const MOST: usize = 10;

    /// Checks the half-widths, before anything is searched.
    pub fn check(&self) -> Result<(), ToleranceError> {
        let shares =
            [("pressure_mpa", self.pressure_mpa), ("modulus", self.modulus), ("stiffness", self.stiffness)];
        let measures = self.measures.iter().map(|(m, value)| (m.field.unwrap_or(m.key), value));
        for (name, value) in shares.into_iter().chain(measures) {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(ToleranceError(format!(
                    "the tolerance {name} is {value}; a tolerance is a half-width of zero or above"
                )));
            }
        }
        match self.varying().len() {
            count if count > Self::MOST => Err(ToleranceError(format!(
                "{count} quantities have a tolerance; at most {} can, because every combination is computed",
                Self::MOST
            ))),
            _ => Ok(()),
        }
    }

    /// What varies, with its half-width.
    fn varying(&self) -> Vec<(Varied, f64)> {
        let measures = self.measures.iter().map(|(measure, value)| (Varied::Measure(measure), value));
        let others = [
            (Varied::Pressure, self.pressure_mpa),
            (Varied::Modulus, self.modulus),
            (Varied::Stiffness, self.stiffness),
        ];
        measures.chain(others).filter(|v| v.1 != 0.0).collect()
    }
}

/// Tolerances that are invalid.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{0}")]
pub struct ToleranceError(String);

/// The pull at one operating point under tolerances.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "SpreadAnswer")]
pub struct Spread {
    /// The operating point.
    #[serde(flatten)]
    pub wanted: OperatingPoint,
    pub pressure_mpa: f64,
    /// Least pull over all corners, N.
    pub low_n: f64,
    /// Largest pull over all corners, N.
    pub high_n: f64,
    /// What to expect where the tolerances are independent, ± N: root sum of squares of the single effects.
    pub likely_n: f64,
}

/// Why a spread cannot be computed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SpreadError {
    /// A corner is no muscle.
    #[error("a corner of the tolerances is not a valid muscle: {0}")]
    Muscle(#[from] MuscleError),
    /// A tolerance of what the muscle does not state.
    #[error("{0} has a tolerance, and the muscle does not state it")]
    NotStated(&'static str),
    /// The model has no answer at a corner.
    #[error("no answer at a corner of the tolerances: {0}")]
    Model(#[from] ModelError),
}

/// The muscle with differences of what varies, and the difference of its pressure.
fn varied(muscle: &Muscle, by: &[(Varied, f64)]) -> Result<(Muscle, f64), SpreadError> {
    let mut parts = muscle.parts().clone();
    // The same rubber: the law of a named one would follow the measures.
    parts.tube.rubber.name = None;
    let (mut pressure, mut stiffness) = (0.0, 0.0);
    for &(what, difference) in by {
        match what {
            Varied::Measure(measure) => {
                let value = (measure.get)(&parts).or(measure.default);
                let value = value.ok_or(SpreadError::NotStated(measure.key))?;
                measure.check(value + difference)?;
                (measure.set)(&mut parts, value + difference);
            }
            Varied::Pressure => pressure = difference,
            Varied::Modulus => parts.tube.rubber.law = parts.tube.rubber.law.scaled(1.0 + difference),
            Varied::Stiffness => stiffness = difference,
        }
    }
    let other = Muscle::new(parts.tube, parts.braid, parts.terminals, parts.friction)?;
    let Some(k) = other.family_stiffness_n_per_mm().filter(|_| stiffness != 0.0) else {
        return Ok((other, pressure));
    };
    let braid =
        Braid { stiffness: BraidStiffness::NewtonPerMm(k * (1.0 + stiffness)), ..other.braid().clone() };
    Ok((other.with_braid(braid)?, pressure))
}

/// Spread of a muscle's pull at a point and pressure: all corners of what varies, and each effect alone.
pub fn spread(
    muscle: &Muscle,
    build: &Build<'_>,
    wanted: OperatingPoint,
    pressure_mpa: f64,
    tolerances: &Tolerances,
) -> Result<Spread, SpreadError> {
    let varying = tolerances.varying();
    let pull = |sign: &dyn Fn(usize) -> f64| -> Result<f64, SpreadError> {
        let by: Vec<(Varied, f64)> =
            varying.iter().enumerate().map(|(i, &(what, width))| (what, sign(i) * width)).collect();
        let (corner, pressure) = varied(muscle, &by)?;
        let p = (pressure_mpa + pressure).max(0.0);
        Ok(build(&corner)?.force_n(&mut Workspace::new(), p, wanted.contraction)?)
    };
    let (mut low_n, mut high_n) = (f64::INFINITY, f64::NEG_INFINITY);
    for corner in 0..1usize << varying.len().min(Tolerances::MOST) {
        let f = pull(&|bit| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 })?;
        (low_n, high_n) = (low_n.min(f), high_n.max(f));
    }
    let mut squares = 0.0;
    for v in 0..varying.len() {
        let one = |sign: f64| pull(&|i| if i == v { sign } else { 0.0 });
        squares += 0.25 * (one(1.0)? - one(-1.0)?).powi(2);
    }
    Ok(Spread { wanted, pressure_mpa, low_n, high_n, likely_n: squares.sqrt() })
}
