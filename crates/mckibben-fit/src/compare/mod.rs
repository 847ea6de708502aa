//! Models against measured points: rms and largest error of each, of pulls and of volumes.

pub use crate::measured::{MeasuredPoint, mean_of_branches, read_measured};

use crate::identify::{Spread, spread};
use crate::measured::DataPoint;
use mckibben::analysis::Evaluation;
use mckibben::cancel;
use mckibben::model::ModelError;
use serde::Serialize;

/// How far a model is from measured points.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// The model's name.
    pub model: String,
    /// Root mean square of F_model − F_measured over the answered points, in N.
    pub rms_n: f64,
    /// Largest |F_model − F_measured|, in N.
    pub max_n: f64,
    /// Mean of F_model − F_measured in N: above zero where the model promises too much.
    pub mean_n: f64,
    /// How many points were answered.
    pub points: usize,
    /// How many points the model refused or failed on, and the first reason.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unanswered: Option<(usize, String)>,
}

/// Compares a model with measured points. Where the model is slack it counts as 0 N.
pub fn compare(evaluation: &mut Evaluation<'_>, points: &[MeasuredPoint]) -> Result<Comparison, ModelError> {
    let info = evaluation.model.info();
    let mut differences = vec![];
    let mut failed: Option<(usize, ModelError)> = None;
    for point in points {
        cancel::check()?;
        let MeasuredPoint { pressure_mpa, contraction, .. } = *point;
        let checked = if evaluation.options.extrapolate {
            Ok(())
        } else {
            info.range.check(&info.name, pressure_mpa, contraction)
        };
        match checked.and_then(|()| evaluation.borne_force_n(pressure_mpa, contraction)) {
            Ok(force) => differences.push(force.max(0.0) - point.force_n),
            Err(error) => failed = Some(failed.map_or((1, error), |(n, first)| (n + 1, first))),
        }
    }
    if differences.is_empty()
        && let Some((_, error)) = failed
    {
        return Err(error);
    }
    let Spread { points, rms_n, max_n, mean_n, .. } = spread("", &differences);
    Ok(Comparison {
        model: info.name.to_string(),
        rms_n,
        max_n,
        mean_n,
        points,
        unanswered: failed.map(|(n, error)| (n, error.to_string())),
    })
}

/// How far the volumes of a model are from measured ones.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct VolumeComparison {
    /// How many volumes were compared.
    pub points: usize,
    /// Root mean square of V_model − V_measured in mm³.
    pub rms_mm3: f64,
    /// Mean of V_model − V_measured in mm³: above zero if the model holds too much air.
    pub mean_mm3: f64,
}

/// Compares the cavity of a model with measured volumes; `None` of a model without one, and without volumes.
pub fn compare_volumes(evaluation: &mut Evaluation<'_>, points: &[DataPoint]) -> Option<VolumeComparison> {
    let mut differences = vec![];
    for point in points {
        cancel::check().ok()?;
        let (p, e) = (point.at.pressure_mpa, point.at.contraction);
        let here = evaluation.response(p, e).ok();
        differences.extend(here.and_then(|r| Some(r.volume_mm3? - point.volume_mm3?)));
    }
    let Spread { points, rms_n: rms_mm3, mean_n: mean_mm3, .. } = spread("", &differences);
    (points > 0).then_some(VolumeComparison { points, rms_mm3, mean_mm3 })
}
