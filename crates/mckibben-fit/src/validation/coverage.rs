//! How far the finite elements are from measured pulls, and what share of the measured points the ± covers.

use super::case::{MuscleCase, muscles};
use super::residual::{Fitter, Left, Residual, compared, residuals};
use crate::identify::{self, Build};
use crate::measured::mean_of_data;
use mckibben::cancel::Cancelled;
use mckibben::progress::{CancelOnly, Progress};
use mckibben::threads;
use mckibben::verification::{CaseKind, Measure, VerificationRow};

/// The share of the points of a set that the ± is to hold.
pub const COVERAGE: f64 = 0.95;

/// What share of the points of each set the ± holds, of the means of the branches and of the single branches.
pub fn cases(elements: &Build<'_>, progress: &dyn Progress) -> Result<Vec<VerificationRow>, Cancelled> {
    let sets = match muscles() {
        Ok(sets) => sets,
        // Measurements that are built in and cannot be read: a case that fails.
        Err(error) => return Ok(vec![share_row(format!("measured muscles: {error}"), "", None, None)]),
    };
    let by = Fitter { build: elements, progress: &CancelOnly(progress) };
    let found = threads::map(&sets, |set| of_first_fit(set, set.friction_share(), by).unwrap_or_default());
    progress.check()?;
    let mut rows = vec![];
    for (set, all) in sets.into_iter().zip(found) {
        let left = |mean| Left::of(all.iter().filter(|r| r.branch.is_mean() == mean));
        let (means, single) = (left(true), left(false));
        rows.push(rms(set, &means));
        rows.push(held(set, &means, "points"));
        if single.points > 0 {
            rows.push(held(set, &single, "points of single branches"));
        }
    }
    Ok(rows)
}

/// A row of validation, whose error counts in its own way.
pub(super) fn validated(row: VerificationRow, measure: Measure, error: Option<f64>) -> VerificationRow {
    let ok = error.is_some_and(|e| e <= row.tolerance);
    VerificationRow { kind: CaseKind::Validation, measure, error, ok, ..row }
}

/// The row of a share of points: at least [`COVERAGE`], or within a tolerance of it.
pub(super) fn share_row(
    name: String,
    source: &'static str,
    ours: Option<f64>,
    tolerance: Option<f64>,
) -> VerificationRow {
    let row = VerificationRow::new(name, source, COVERAGE, ours, tolerance.unwrap_or(0.0));
    let off =
        |share: f64| if tolerance.is_some() { (share - COVERAGE).abs() } else { (COVERAGE - share).max(0.0) };
    validated(row, Measure::Share, ours.map(off))
}

fn held(set: &'static MuscleCase, left: &Left, what: &str) -> VerificationRow {
    let name = format!("{}: {} {what} within the ± of fe", set.facts.title, left.points);
    share_row(name, &set.facts.source, left.held, None)
}

/// The rms of what a set's identified muscle leaves of the means of the branches, beside its largest blocked force.
fn rms(set: &'static MuscleCase, left: &Left) -> VerificationRow {
    let error = (left.points > 0).then_some(left.rms_of_blocked);
    let fit = set.fits.first();
    let free = fit.map(|f| f.free.iter().map(|p| p.target.name(&f.muscle)).collect::<Vec<_>>());
    let tolerance = set.rms_of_blocked.unwrap_or(0.0);
    let free = free.unwrap_or_default().join(" and ");
    let name = format!("{}: fe, {} points, {free} identified", set.facts.title, left.points);
    let ours = (left.points > 0).then_some(left.rms_n);
    let row = VerificationRow::new(name, &set.facts.source, left.blocked_n, ours, tolerance);
    validated(row, Measure::Rms, error)
}

/// Identifies a muscle from the mean of its branches as its first fit says, and compares all its points with it; on single branches with a friction
/// that is estimated by c_f.
pub fn of_first_fit(
    set: &MuscleCase,
    friction_share: f64,
    by: Fitter<'_>,
) -> identify::Result<Vec<Residual>> {
    let Some(fit) = set.fits.first() else { return Ok(vec![]) };
    let means = mean_of_data(&set.points);
    let (muscle, _) = by.fitted(fit, &means)?;
    Ok(residuals(by.build, &muscle, &compared(&means, &set.points), friction_share))
}
