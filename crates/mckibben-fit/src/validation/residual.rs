//! Measured pulls less those of a model.

use super::case::CaseFit;
use crate::identify::{Build, Identification, Identified, Request, Result, identify};
use crate::measured::{DataPoint, MeasuredPoint, Quantity, Section};
use mckibben::analysis::Evaluation;
use mckibben::model::{BlockedAt, ForceModel, Reference, Workspace};
use mckibben::muscle::{Direction, Muscle};
use mckibben::progress::Progress;
use mckibben::uncertainty::{length_n, measured_n, transfer_n};
use serde::Serialize;

/// One measured point beside what a model says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residual {
    /// ε.
    pub contraction: f64,
    /// ε over the ideal muscle's largest contraction.
    pub contraction_share: f64,
    /// Measured less computed, in N; of a volume |∂F/∂ε| / |∂V/∂ε| times its difference.
    pub difference_n: f64,
    /// The branch it was measured on.
    pub branch: Direction,
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// The computed blocked force there, in N.
    pub blocked_n: f64,
    /// The ± there in N, of what is known to err in the model and against measured muscles; on a single branch with that of its
    /// friction. `None` where nobody has measured the model's error.
    pub half_width_n: Option<f64>,
}

impl Residual {
    /// Whether the ± covers the point.
    pub fn covered(&self) -> Option<bool> {
        self.half_width_n.map(|half| self.difference_n.abs() <= half)
    }
}

/// The ± of a model at a point, for its blocked force there.
fn half_width_n(evaluation: &mut Evaluation<'_>, point: &DataPoint, blocked_n: f64) -> Option<f64> {
    let model = evaluation.model;
    let (accuracy, muscle) = (model.info().accuracy, model.muscle());
    let scale_n = match accuracy.blocked_at {
        BlockedAt::SamePressure => blocked_n,
        BlockedAt::Pressure(p) => model.blocked_scale_n(evaluation.workspace, p).ok()?,
    };
    let model_n = accuracy.share_of_blocked? * scale_n;
    if matches!(accuracy.reference, Reference::ForceMap(_)) {
        return Some(model_n);
    }
    let elsewhere_n =
        transfer_n(muscle, blocked_n).unwrap_or(0.0).hypot(length_n(muscle, blocked_n).unwrap_or(0.0));
    let half_n = measured_n(muscle, blocked_n, point.at.contraction).hypot(model_n).hypot(elsewhere_n);
    if point.at.direction().is_mean() {
        return Some(half_n);
    }
    let at = &point.at;
    Some(half_n.hypot(evaluation.friction_uncertainty_n(at.pressure_mpa, at.contraction, blocked_n)))
}

/// The model of the muscle of some rows, where it has one.
struct SectionModel {
    section: Section,
    model: Option<Box<dyn ForceModel>>,
    workspace: Workspace,
    /// Pressures in MPa with their blocked forces in N.
    blocked: Vec<(f64, Option<f64>)>,
}

impl SectionModel {
    /// Finite elements are fast next to their last point: the blocked force of each pressure is computed once.
    fn residual(&mut self, point: &DataPoint) -> Option<Residual> {
        let (model, w) = (self.model.as_deref()?, &mut self.workspace);
        let MeasuredPoint { pressure_mpa, contraction, force_n, .. } = point.at;
        let branch = point.at.direction();
        let known = self.blocked.iter().find(|known| known.0 == pressure_mpa).map(|known| known.1);
        let blocked_n = known.unwrap_or_else(|| {
            let blocked_n = model.force_n(w, pressure_mpa, 0.0).ok();
            self.blocked.push((pressure_mpa, blocked_n));
            blocked_n
        })?;
        let mut evaluation = Evaluation::new(model, w, branch);
        let here = evaluation.response(pressure_mpa, contraction).ok()?;
        let difference_n = match point.measured {
            // A slack muscle does not pull.
            Quantity::Force => force_n - here.force_n.max(0.0),
            Quantity::Contraction | Quantity::Pressure => force_n - here.force_n,
            Quantity::Volume => {
                let per_contraction = evaluation.stiffness_n_per_mm(&here).ok()?;
                let volume_per_contraction = evaluation.force_per_pressure_mm2(&here).ok()?;
                (point.volume_mm3? - here.volume_mm3?) * per_contraction / volume_per_contraction
            }
        };
        Some(Residual {
            contraction,
            contraction_share: contraction / model.muscle().max_ideal_contraction(),
            difference_n,
            branch,
            pressure_mpa,
            blocked_n,
            half_width_n: half_width_n(&mut evaluation, point, blocked_n),
        })
    }
}

/// Measured points less the model of a muscle; without those to which the model has no answer.
pub(super) fn residuals(build: &Build<'_>, muscle: &Muscle, points: &[&DataPoint]) -> Vec<Residual> {
    let mut models: Vec<SectionModel> = vec![];
    let mut out = vec![];
    for point in points {
        let known = models.iter().position(|m| m.section == point.section).unwrap_or_else(|| {
            let model = point.section.apply(muscle).ok().and_then(|m| build(&m).ok());
            let (section, workspace) = (point.section, Workspace::new());
            models.push(SectionModel { section, model, workspace, blocked: vec![] });
            models.len() - 1
        });
        out.extend(models.get_mut(known).and_then(|model| model.residual(point)));
    }
    out
}

/// The model that is fitted, and the progress that may end it.
#[derive(Clone, Copy)]
pub struct Fitter<'a> {
    pub build: &'a Build<'a>,
    pub progress: &'a dyn Progress,
}

impl Fitter<'_> {
    /// A fit to points: least squares of the pulls, from one side, without history.
    pub(super) fn identified(&self, fit: &CaseFit, points: &[DataPoint]) -> Result<Identification> {
        let request = Request::new(&fit.muscle, &fit.free, points, self.build);
        identify(&Request { progress: self.progress, ..request })
    }

    /// The muscle and the constants of a fit to points.
    pub(super) fn fitted(&self, fit: &CaseFit, points: &[DataPoint]) -> Result<(Muscle, Vec<Identified>)> {
        if fit.free.is_empty() {
            return Ok((fit.muscle.clone(), vec![]));
        }
        let identification = self.identified(fit, points)?;
        Ok((identification.muscle, identification.parameters))
    }
}

/// Means of branches and points without one, then the single branches. A point whose other branch is missing is in the second list alone.
pub(super) fn compared<'a>(means: &'a [DataPoint], points: &'a [DataPoint]) -> Vec<&'a DataPoint> {
    let means = means.iter().filter(|p| p.at.direction().is_mean());
    means.chain(points.iter().filter(|p| !p.at.direction().is_mean())).collect()
}

/// Errors of a model at some points: measured less computed.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct ForceErrors {
    /// How many points.
    pub points: usize,
    /// Root mean square of the differences in N.
    pub rms_n: f64,
    /// Largest difference in N.
    pub largest_n: f64,
    /// Mean of measured − computed in N.
    pub bias_n: f64,
    /// `rms_n` over the largest blocked force of these points.
    pub rms_of_blocked: f64,
    /// Share of the points within the ± of the model; null if there are none, or no ±.
    pub held: Option<f64>,
    /// Largest blocked force of the points in N.
    #[serde(skip)]
    pub blocked_n: f64,
}

impl ForceErrors {
    pub fn new<'a>(list: impl Iterator<Item = &'a Residual>) -> Self {
        let (mut out, mut squares, mut judged, mut held) = (Self::default(), 0.0, 0, 0);
        for r in list {
            out.points += 1;
            squares += r.difference_n * r.difference_n;
            out.bias_n += r.difference_n;
            out.largest_n = out.largest_n.max(r.difference_n.abs());
            out.blocked_n = out.blocked_n.max(r.blocked_n);
            judged += usize::from(r.covered().is_some());
            held += usize::from(r.covered() == Some(true));
        }
        let n = out.points.max(1) as f64;
        let rms_n = (squares / n).sqrt();
        let rms_of_blocked = if out.points > 0 { rms_n / out.blocked_n } else { 0.0 };
        let held = (judged > 0).then(|| held as f64 / judged as f64);
        Self { rms_n, bias_n: out.bias_n / n, rms_of_blocked, held, ..out }
    }
}
