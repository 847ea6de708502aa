//! What `curve` answers.

use crate::{LoadAnswer, MuscleSummary, PressureLimits, Problem};
use mckibben::curve::{Curve, CurvePoint, Test};
use mckibben::{answer::Answer, status::Status, units::short_numbers, warning::Warning};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// A family of curves.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CurveAnswer {
    /// The model's name.
    pub model: String,
    /// Which test.
    pub test: Test,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// What is fixed along each curve: ε, F in N, or P in MPa; of two curves, where both branches were asked for.
    pub fixed: Vec<f64>,
    /// Warnings; of each kind the most serious.
    #[schemars(with = "Vec<String>")]
    pub warnings: Vec<Warning>,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// The points, curve after curve; all curves have the same number of points.
    #[serde(rename = "points", serialize_with = "points")]
    #[schemars(with = "Vec<PointRow>")]
    pub curves: Vec<Curve>,
    /// The equilibria with the load, where there is one.
    pub loaded: Option<LoadAnswer>,
    /// The figure, where it was asked for.
    pub figure: Option<Figure>,
    /// Whether every two curves are the branches of one: shortening, then lengthening.
    #[serde(skip)]
    pub both: bool,
    /// Where no point has an answer: the reason.
    #[serde(skip)]
    pub problem: Option<Problem>,
}

/// A point of a curve: an answer, or why there is none.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum PointRow {
    /// There is an answer.
    Answered {
        /// The answer.
        #[serde(flatten)]
        answer: Box<Answer>,
        /// `ok`.
        status: Status,
    },
    /// There is none.
    Failed(FailedPoint),
}

/// A point without an answer.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct FailedPoint {
    /// Pressure asked for, MPa.
    pub pressure_mpa: f64,
    /// Contraction asked for.
    pub contraction: Option<f64>,
    /// Pull asked for, N.
    pub wanted_force_n: Option<f64>,
    /// How it ended.
    pub status: Status,
    /// Why.
    pub cause: String,
}

fn points<S: Serializer>(curves: &[Curve], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(curves.iter().flat_map(|curve| &curve.points).map(PointRow::from))
}

impl From<&CurvePoint> for PointRow {
    fn from(point: &CurvePoint) -> Self {
        match &point.answer {
            Ok(answer) => Self::Answered { answer: Box::new(answer.clone()), status: Status::Ok },
            Err(error) => Self::Failed(FailedPoint {
                pressure_mpa: point.pressure_mpa,
                contraction: point.contraction,
                wanted_force_n: point.force_n,
                status: error.into(),
                cause: short_numbers(&error.to_string()).into_owned(),
            }),
        }
    }
}
