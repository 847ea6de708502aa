//! Models against measured points: rms and largest error of each, of pulls and of volumes.

pub use crate::measured::{MeasuredPoint, mean_of_branches, read_measured};

use crate::{
    least_squares::Errors,
    measured::{DataPoint, Quantity},
};
use mckibben_core::{analysis::Evaluation, cancel, model::ModelError};
use serde::Serialize;

/// Errors of a model, model − reference.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Default, Serialize, schemars::JsonSchema)]
pub struct Comparison {
    /// The model.
    pub model: String,
    /// Root mean square, N; none where the model could not be compared.
    #[serialize_always]
    pub rms_n: Option<f64>,
    /// The largest, N.
    #[serialize_always]
    pub max_n: Option<f64>,
    /// The mean, N: above zero if the model predicts too much pull.
    pub mean_n: Option<f64>,
    /// R²: 1 − Σ(F − F_ref)²/Σ(F_ref − mean F_ref)²; none where all reference pulls are the same.
    pub r_squared: Option<f64>,
    /// Measured contractions that it answered; 0 without.
    #[serde(skip_serializing_if = "is_zero")]
    pub contraction_points: usize,
    /// Root mean square of the contractions less the measured ones.
    pub rms_contraction: Option<f64>,
    /// Mean of the same: above zero if the model contracts too far.
    pub mean_contraction: Option<f64>,
    /// Measured volumes of the cavity that it answered; 0 without.
    #[serde(skip_serializing_if = "is_zero")]
    pub volume_points: usize,
    /// Root mean square of its volumes less the measured ones, mm³.
    pub rms_volume_mm3: Option<f64>,
    /// Mean of the same, mm³: above zero if the model holds too much air.
    pub mean_volume_mm3: Option<f64>,
    /// Points that it answered.
    pub points: usize,
    /// Points that it did not answer.
    pub unanswered: usize,
    /// Why not, or why the model could not be compared.
    #[serialize_always]
    pub cause: Option<String>,
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde hands over references"
)]
fn is_zero(count: &usize) -> bool {
    *count == 0
}

/// Compares a model with measured pulls and, `beside` them, with measured volumes of the cavity and
/// contractions under a load. Where the model is slack it counts as 0 N.
pub fn compare(
    evaluation: &mut Evaluation<'_>,
    pulls: &[MeasuredPoint],
    beside: &[DataPoint],
) -> Result<Comparison, ModelError> {
    let info = evaluation.model.info();
    let mut differences = vec![];
    let mut answered = vec![];
    let mut unanswered = 0;
    let mut first = None;
    for point in pulls {
        cancel::check()?;
        let MeasuredPoint {
            pressure_mpa,
            contraction,
            ..
        } = *point;
        let checked = if evaluation.options.extrapolate {
            Ok(())
        } else {
            info.range.check(&info.name, pressure_mpa, contraction)
        };
        match checked.and_then(|()| evaluation.borne_force_n(pressure_mpa, contraction)) {
            Ok(force) => {
                differences.push(force.max(0.0) - point.force_n);
                answered.push(point.force_n);
            }
            Err(error) => {
                unanswered += 1;
                first.get_or_insert(error);
            }
        }
    }
    if differences.is_empty()
        && let Some(error) = first
    {
        return Err(error);
    }
    let (mut volume_differences, mut contraction_differences) = (vec![], vec![]);
    for DataPoint {
        at,
        measured,
        volume_mm3,
        ..
    } in beside
    {
        cancel::check()?;
        if *measured == Quantity::Contraction {
            let found = evaluation.contraction_or_stretch_at(at.force_n, at.pressure_mpa);
            contraction_differences.extend(found.ok().map(|e| e - at.contraction));
        } else {
            let response = evaluation.response(at.pressure_mpa, at.contraction).ok();
            volume_differences.extend(response.and_then(|r| Some(r.volume_mm3? - (*volume_mm3)?)));
        }
    }
    let points = differences.len();
    let errors =
        |differences: Vec<f64>| Some(Errors::new(differences)).filter(|errors| errors.points > 0);
    let spread = errors(answered).map_or(0.0, |e| e.rms.powi(2) - e.mean.powi(2));
    let pulls = errors(differences);
    let volumes = errors(volume_differences);
    let contractions = errors(contraction_differences);
    Ok(Comparison {
        model: info.name.to_string(),
        rms_n: pulls.as_ref().map(|e| e.rms),
        max_n: pulls.as_ref().map(|e| e.largest),
        mean_n: pulls.as_ref().map(|e| e.mean),
        r_squared: pulls
            .as_ref()
            .filter(|_| spread > 1e-9)
            .map(|e| 1.0 - e.rms.powi(2) / spread),
        contraction_points: contractions.as_ref().map_or(0, |e| e.points),
        rms_contraction: contractions.as_ref().map(|e| e.rms),
        mean_contraction: contractions.as_ref().map(|e| e.mean),
        volume_points: volumes.as_ref().map_or(0, |e| e.points),
        rms_volume_mm3: volumes.as_ref().map(|e| e.rms),
        mean_volume_mm3: volumes.as_ref().map(|e| e.mean),
        points,
        unanswered,
        cause: first.map(|error| error.to_string()),
    })
}
