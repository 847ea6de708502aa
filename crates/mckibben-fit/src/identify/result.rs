//! The result of an identification.

use super::Target;
use crate::{least_squares::Errors, measured::DataPoint};
use mckibben_core::muscle::{Bench, Direction, Muscle};
use schemars::JsonSchema;
use serde::Serialize;

/// One identified parameter.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Identified {
    /// The constant of the muscle; `None` of a drive's.
    #[serde(skip)]
    pub target: Option<Target>,
    /// Its name, as in the muscle file.
    pub name: String,
    /// Where the search began: the centre of what was known before.
    pub start: f64,
    /// Its value.
    pub value: f64,
    /// Its unit; empty for a plain number.
    pub unit: &'static str,
    /// Standard error; infinite (null in JSON) where the data do not determine it at all, 0 on a
    /// bound.
    #[schemars(with = "Option<f64>")]
    pub standard_error: f64,
    /// Half-width of the 95 % interval; likewise.
    #[serde(rename = "half_width_95")]
    #[schemars(with = "Option<f64>")]
    pub half_width: f64,
    /// Standard deviation before, where measured muscles tell of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub prior_standard_deviation: Option<f64>,
    /// Whether the data determine it; with a prior, whether they told more than that.
    pub identifiable: bool,
    /// Whether it lies on a bound.
    pub at_bound: bool,
    /// Whether the points change with it at all.
    pub matters: bool,
}

/// A point with the residual of the model.
#[derive(Debug, Clone, Copy, Serialize)]
#[non_exhaustive]
pub struct PointFit {
    /// The point.
    pub point: DataPoint,
    /// Model less measured, N.
    pub residual_n: f64,
    /// Whether it is an outlier.
    pub outlier: bool,
}

/// Root mean square and largest residual of some points.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Spread {
    /// The points.
    #[serde(rename = "of")]
    pub label: String,
    /// How many.
    pub points: usize,
    /// Root mean square, N.
    pub rms_n: f64,
    /// Largest, in N.
    pub max_n: f64,
    /// Mean of model less measured, in N.
    pub mean_n: f64,
}

/// The result of an identification.
#[derive(Debug, Serialize, JsonSchema)]
#[non_exhaustive]
pub struct Identification {
    /// The free parameters, with value and error.
    pub parameters: Vec<Identified>,
    /// Correlation of the parameters, row by row.
    pub correlation: Vec<Vec<f64>>,
    /// Root mean square of the residuals at the start, N.
    pub rms_before_n: f64,
    /// Root mean square of the residuals, N.
    pub rms_n: f64,
    /// Largest residual, N.
    pub max_n: f64,
    /// Standard deviation of one point, N.
    pub deviation: f64,
    /// Points that counted.
    #[serde(rename = "degrees_of_freedom")]
    pub freedom: usize,
    /// Residuals by branch and by table.
    #[doc(hidden)]
    pub spreads: Vec<Spread>,
    /// Points that were left out because the muscle was slack.
    #[serde(skip)]
    pub slack: Vec<DataPoint>,
    /// The points that counted.
    #[serde(skip)]
    pub points: Vec<PointFit>,
    /// The muscle with the identified values.
    #[serde(skip)]
    pub muscle: Muscle,
    /// That the points are hardly of this muscle.
    #[serde(skip)]
    pub mismatch: Option<String>,
    /// Sentences a user should read.
    #[serde(skip)]
    pub notes: Vec<String>,
    /// The bench of the muscle, where points are of it: the ± that holds there.
    #[serde(skip)]
    #[doc(hidden)]
    pub bench: Option<Bench>,
}

impl Identification {
    /// The muscle with its bench, where it has one.
    pub fn with_bench(&self) -> Muscle {
        let muscle = self.muscle.clone();
        if let Some(bench) = &self.bench {
            muscle.with_bench(bench.clone())
        } else {
            muscle
        }
    }

    /// What was found of a constant; none where it was not sought.
    pub fn parameter(&self, target: Target) -> Option<&Identified> {
        self.parameters.iter().find(|p| p.target == Some(target))
    }
}

/// rms, largest and mean of a list of residuals.
pub fn spread(label: impl Into<String>, residuals: &[f64]) -> Spread {
    let errors = Errors::new(residuals.iter().copied());
    Spread {
        label: label.into(),
        points: errors.points,
        rms_n: errors.rms,
        max_n: errors.largest,
        mean_n: errors.mean,
    }
}

/// By branch and by set, where there is more than one.
pub fn spreads(points: &[PointFit]) -> Vec<Spread> {
    let group = |label: String, keep: &dyn Fn(&PointFit) -> bool| {
        let list: Vec<f64> = points
            .iter()
            .filter(|p| keep(p))
            .map(|p| p.residual_n)
            .collect();
        (!list.is_empty() && list.len() < points.len()).then(|| spread(label, &list))
    };
    let branches = [
        ("branch contraction", Some(Direction::Contraction)),
        ("branch elongation", Some(Direction::Elongation)),
        ("mean of both branches", Some(Direction::Mean)),
        ("no branch", None),
    ];
    let branches =
        branches.map(|(label, branch)| group(label.into(), &|p| p.point.at.branch == branch));
    let mut out: Vec<Spread> = branches.into_iter().flatten().collect();
    let sets = points.iter().map(|p| p.point.set).max().unwrap_or(0);
    out.extend((0..=sets).filter_map(|s| group(format!("data {}", s + 1), &|p| p.point.set == s)));
    out
}
