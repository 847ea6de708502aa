//! Measured pulls less those of a model.

use crate::{
    identify::Build,
    least_squares::Errors,
    measured::{DataPoint, MeasuredPoint, Quantity, Section},
};
use mckibben_core::{
    analysis::{Evaluation, Options},
    built::{Built, UncertaintyParts},
    extremes::peak,
    model::{ForceModel, Workspace},
    muscle::{Direction, Muscle},
};

/// One measured point beside what a model says of it.
#[derive(Debug, Clone, Copy)]
pub struct Residual {
    /// ε.
    pub contraction: f64,
    /// Measured less computed, in N; of a volume |∂F/∂ε| / |∂V/∂ε| times its difference.
    pub difference_n: f64,
    /// The branch it was measured on.
    pub branch: Direction,
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// The computed blocked force there, in N.
    pub blocked_n: f64,
    /// Measured less what a muscle that is built pulls by the median, in N, and half of its 95 %
    /// interval; on the mean of the branches without friction. `None` where nobody has measured the
    /// model's error.
    pub of_built_n: Option<(f64, f64)>,
}

impl Residual {
    /// Whether the ± covers the point.
    pub fn covered(&self) -> Option<bool> {
        self.of_built_n.map(|(off, half)| off.abs() <= half)
    }
}

/// A point beside the model of its muscle; of the blocked muscle in a memory of its own: finite
/// elements are fast next to their last point.
fn residual(
    model: &dyn ForceModel,
    [workspace, blocked]: &mut [Workspace; 2],
    point: &DataPoint,
    friction_share: f64,
) -> Option<Residual> {
    let MeasuredPoint {
        pressure_mpa,
        contraction,
        force_n,
        ..
    } = point.at;
    let branch = point.at.direction();
    let options = Options {
        friction_share,
        ..branch.into()
    };
    let mut evaluation = Evaluation::new(model, workspace, options);
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
    let predicted =
        Evaluation::new(model, blocked, options).predicted(pressure_mpa, contraction, here.force_n);
    let is_pull = point.measured != Quantity::Volume;
    let of_built_n = predicted.filter(|_| is_pull).map(|predicted| {
        let (median_n, half_n) = of_branch(branch, predicted);
        (force_n - median_n.max(0.0), half_n)
    });
    Some(Residual {
        contraction,
        difference_n,
        branch,
        pressure_mpa,
        blocked_n: model.force_n(blocked, pressure_mpa, 0.0).ok()?,
        of_built_n,
    })
}

/// The median of what a muscle that is built pulls in N, and half of its interval, on the branch that
/// was measured: on the mean of both without the friction.
pub fn of_branch(branch: Direction, (built, parts): (Built, UncertaintyParts)) -> (f64, f64) {
    if !branch.is_mean() {
        return (built.predicted_n, parts.total());
    }
    let parts = UncertaintyParts {
        friction: None,
        ..parts
    };
    (
        built.predicted_n - built.predicted_shift_n.friction,
        parts.total(),
    )
}

/// The model of the muscle of some rows, where it has one, with its memories.
type SectionModel = (Section, Option<Box<dyn ForceModel>>, [Workspace; 2]);

/// Measured points less the model of a muscle; without those to which the model has no answer; on
/// single branches with a friction that is estimated by c_f where the muscle states none.
pub fn residuals<'a>(
    build: &Build<'_>,
    muscle: &Muscle,
    points: impl IntoIterator<Item = &'a DataPoint>,
    friction_share: f64,
) -> Vec<Residual> {
    let mut models: Vec<SectionModel> = vec![];
    let mut out = vec![];
    for point in points {
        let section = point.section;
        if !models.iter().any(|known| known.0 == section) {
            let model = section.apply(muscle).ok().and_then(|m| build(&m).ok());
            models.push((section, model, [Workspace::new(), Workspace::new()]));
        }
        let known = models.iter_mut().find(|known| known.0 == section);
        out.extend(known.and_then(|(_, model, workspaces)| {
            residual(model.as_deref()?, workspaces, point, friction_share)
        }));
    }
    out
}

/// Errors of a model at some points: measured less computed.
#[derive(Debug, Clone, Copy, Default)]
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
    pub blocked_n: f64,
}

impl ForceErrors {
    /// Statistics of residuals, in N and in shares of the blocked force.
    pub fn new<'a>(list: impl Iterator<Item = &'a Residual>) -> Self {
        let list: Vec<&Residual> = list.collect();
        let errors = Errors::new(list.iter().map(|r| r.difference_n));
        let blocked_n = peak(list.iter().map(|r| r.blocked_n));
        let judged = list.iter().filter(|r| r.of_built_n.is_some()).count() as f64;
        let held = list.iter().filter(|r| r.covered() == Some(true)).count();
        Self {
            points: errors.points,
            rms_n: errors.rms,
            largest_n: errors.largest,
            bias_n: errors.mean,
            rms_of_blocked: if list.is_empty() {
                0.0
            } else {
                errors.rms / blocked_n
            },
            held: (judged > 0.0).then(|| held as f64 / judged),
            blocked_n,
        }
    }
}
