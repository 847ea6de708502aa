//! How far the finite elements are from measured pulls, and what share of the measured points the ± covers.

use super::case::{CASES, Case};
use crate::FemError;
use crate::axisymmetric::Axisymmetric;
use crate::verification::{Kind, Measure, Row};
use mckibben::budget::Exceeded;
use mckibben::identify::{IdentifyError, Request, identify_with};
use mckibben::least_squares::Loss;
use mckibben::measured::{DataPoint, mean_of_data};
use mckibben::model::{ForceModel, ModelError, Workspace, seated};
use mckibben::muscle::{Direction, Muscle};
use mckibben::progress::Progress;
use mckibben::uncertainty::{measured_n, with_friction_n};

/// One measured point beside what finite elements say of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residual {
    /// ε.
    pub contraction: f64,
    /// ε over the ideal muscle's largest contraction.
    pub contraction_share: f64,
    /// (measured − computed) over the blocked force at the same pressure.
    pub of_blocked: f64,
    /// The branch it was measured on.
    pub branch: Direction,
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// The computed blocked force there, in N.
    pub blocked_n: f64,
    /// The part `measured` of the ± there, in N.
    pub measured_n: f64,
}

impl Residual {
    /// Whether the ± holds the point: on a single branch with the friction that the muscle does not state.
    pub fn covered(&self) -> bool {
        let half_width = match self.branch {
            Direction::Mean => self.measured_n,
            _ => with_friction_n(self.measured_n, self.blocked_n),
        };
        (self.of_blocked * self.blocked_n).abs() <= half_width
    }
}

/// The share of the points of a set that the ± is to hold.
pub const COVERAGE: f64 = 0.95;

/// What share of the points of each set the ± holds, of the means of the branches and of the single branches.
///
/// # Errors
/// [`FemError::Exceeded`] where the caller wanted it to end.
pub fn cases(progress: &dyn Progress) -> Result<Vec<Row>, FemError> {
    let mut rows = vec![];
    for set in CASES.iter() {
        let all = residuals(set, progress);
        if progress.cancelled() {
            return Err(FemError::Exceeded(Exceeded::Cancelled));
        }
        let all = all.unwrap_or_default();
        rows.push(rms(set, &all));
        for mean in [true, false] {
            let of: Vec<&Residual> = all.iter().filter(|r| r.branch.is_mean() == mean).collect();
            if of.is_empty() && !mean {
                continue;
            }
            let held = of.iter().filter(|r| r.covered()).count();
            let ours = (!of.is_empty()).then(|| held as f64 / of.len() as f64);
            let what = if mean { "points" } else { "points of single branches" };
            let error = ours.map(|share| (COVERAGE - share).max(0.0));
            rows.push(Row {
                name: format!("{}: {} {what} within the ± of fe", set.title, of.len()),
                kind: Kind::Validation,
                measure: Measure::Share,
                source: &set.source,
                reference: COVERAGE,
                ours,
                error,
                tolerance: 0.0,
                ok: error == Some(0.0),
            });
        }
    }
    Ok(rows)
}

/// The rms of what a set's identified muscle leaves of the means of the branches, beside its largest blocked force.
fn rms(set: &'static Case, all: &[Residual]) -> Row {
    let of: Vec<&Residual> = all.iter().filter(|r| r.branch.is_mean()).collect();
    let blocked_n = of.iter().map(|r| r.blocked_n).fold(0.0, f64::max);
    let squares: f64 = of.iter().map(|r| (r.of_blocked * r.blocked_n).powi(2)).sum();
    let ours = (!of.is_empty()).then(|| (squares / of.len() as f64).sqrt());
    let error = ours.map(|rms| rms / blocked_n);
    let fit = set.fits.first();
    let free = fit.map(|f| f.free.iter().map(|p| p.target.name(&f.muscle)).collect::<Vec<_>>());
    let tolerance = set.rms_of_blocked.unwrap_or(0.0);
    Row {
        name: format!(
            "{}: fe, {} points, {} identified",
            set.title,
            of.len(),
            free.unwrap_or_default().join(" and ")
        ),
        kind: Kind::Validation,
        measure: Measure::Rms,
        source: &set.source,
        reference: blocked_n,
        ours,
        error,
        tolerance,
        ok: error.is_some_and(|e| e <= tolerance),
    }
}

/// Finite elements, with ends that give way where the muscle says so.
///
/// # Errors
/// [`ModelError`] of a muscle that they do not have.
pub fn elements(muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(seated(Box::new(Axisymmetric::new(&muscle.between_ends())?), muscle))
}

/// Identifies a muscle from the mean of its branches as its first fit says, and compares all its points with it.
///
/// # Errors
/// [`IdentifyError`].
pub fn residuals(set: &Case, progress: &dyn Progress) -> Result<Vec<Residual>, IdentifyError> {
    let Some(fit) = set.fits.first() else { return Ok(vec![]) };
    let mean = mean_of_data(&set.points);
    let request = Request {
        muscle: &fit.muscle,
        free: &fit.free,
        fixed: &[],
        points: &mean,
        loss: Loss::Squares,
        two_sided: false,
    };
    let found = identify_with(&request, elements, progress)?.muscle;
    let single = set.points.iter().filter(|p| p.at.branch != Direction::Mean);
    // A point whose other branch is missing stands in both lists.
    let mean = mean.iter().filter(|p| p.at.branch.is_mean());
    let all: Vec<&DataPoint> = mean.chain(single).collect();
    Ok(all.into_iter().filter_map(|p| residual(&found, p)).collect())
}

pub(super) fn residual(muscle: &Muscle, point: &DataPoint) -> Option<Residual> {
    let muscle = point.section.apply(muscle).ok()?;
    let (model, w) = (elements(&muscle).ok()?, &mut Workspace::new());
    let pressure_mpa = point.at.pressure_mpa;
    let blocked_n = model.force_n(w, pressure_mpa, 0.0).ok()?;
    let force_n = model.force_n(w, pressure_mpa, point.at.contraction).ok()?;
    Some(Residual {
        contraction: point.at.contraction,
        contraction_share: point.at.contraction / muscle.max_ideal_contraction(),
        of_blocked: (point.at.force_n - force_n.max(0.0)) / blocked_n,
        branch: point.at.branch,
        pressure_mpa,
        blocked_n,
        measured_n: measured_n(&muscle, blocked_n, point.at.contraction),
    })
}
