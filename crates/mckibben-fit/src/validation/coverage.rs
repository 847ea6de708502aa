//! The error of finite elements at measured pulls.

use super::{
    case::MuscleCase,
    chosen::Parameter,
    residual::{Fitter, ForceErrors, Residual, compared, residuals},
};
use crate::{
    identify::Result,
    measured::mean_of_data,
};
use mckibben_core::{
    joined, threads,
    verification::{CaseKind, Measure, VerificationRow},
};

/// The share of the points of a set that the ± must cover.
pub const COVERAGE: f64 = 0.95;

/// The error of each set.
pub(super) fn cases(sets: &[&'static MuscleCase], by: Fitter<'_>) -> Vec<VerificationRow> {
    let judged = sets.iter().filter(|set| set.rms_of_blocked.is_some());
    let of_set = |&set: &&'static MuscleCase| {
        let all = first_fit_residuals(set, set.friction_share(), by).unwrap_or_default();
        let means = ForceErrors::new(all.iter().filter(|r| r.branch.is_mean()));
        rms(set, &means)
    };
    threads::map(&judged.copied().collect::<Vec<_>>(), of_set)
}

/// A row of validation with an error that is not that of its value.
pub(super) fn validated(
    row: VerificationRow,
    measure: Measure,
    error: Option<f64>,
) -> VerificationRow {
    VerificationRow {
        kind: CaseKind::Validation,
        measure,
        error,
        ok: error.is_some_and(|e| e <= row.tolerance),
        ..row
    }
}

/// The rms error of a set's identified muscle at the means of the branches, beside its largest
/// blocked force.
fn rms(set: &'static MuscleCase, errors: &ForceErrors) -> VerificationRow {
    let free = set.fits.iter().take(1).flat_map(|fit| {
        let name = |free: &Parameter| free.target.name(&fit.muscle);
        fit.free.iter().map(name)
    });
    let name = format!(
        "{}: fe, {} points, {} identified",
        set.facts.title,
        errors.points,
        joined(free, " and ")
    );
    let tolerance = set.rms_of_blocked.unwrap_or(0.0);
    let some = Some(errors).filter(|errors| errors.points > 0);
    let (ours, error) = some.map(|some| (some.rms_n, some.rms_of_blocked)).unzip();
    let row = VerificationRow::new(name, &set.facts.source, errors.blocked_n, ours, tolerance);
    validated(row, Measure::Rms, error)
}

/// Identifies a muscle from the mean of its branches as its first fit says, and compares all its
/// points with it; on single branches with a friction that is estimated by c_f.
pub fn first_fit_residuals(
    set: &MuscleCase,
    friction_share: f64,
    by: Fitter<'_>,
) -> Result<Vec<Residual>> {
    let Some(fit) = set.fits.first() else {
        return Ok(vec![]);
    };
    let means = mean_of_data(&set.points);
    let (muscle, _) = by.fitted(fit, &means)?;
    let points = compared(&means, &set.points);
    Ok(residuals(by.build, &muscle, points, friction_share))
}
