//! What share of points that were held out of a fit lies within the ± that the fit leaves.

use super::case::{CaseFit, MuscleCase, muscles};
use super::coverage::{COVERAGE, Off, share_row};
use super::residual::{Fitter, Left, Residual};
use crate::identify::{Build, IdentifyError, Result};
use crate::measured::{DataPoint, mean_of_data};
use mckibben::analysis::Evaluation;
use mckibben::cancel::Cancelled;
use mckibben::model::Workspace;
use mckibben::progress::{CancelOnly, Progress};
use mckibben::threads;
use mckibben::uncertainty::UncertaintyParts;
use mckibben::verification::VerificationRow;

/// Parts into which the points of a set are divided; each is held out of one fit.
const PARTS: usize = 5;
/// The share of points may differ by so much from the 95 % that the ± states.
const TOLERANCE: f64 = 0.02;

/// The points of a set that a fit is made to.
pub fn points_of(set: &MuscleCase, fit: &CaseFit) -> Vec<DataPoint> {
    if fit.both_branches {
        set.points.iter().filter(|p| !p.at.direction().is_mean()).copied().collect()
    } else {
        mean_of_data(&set.points)
    }
}

/// Fits a muscle to some points of its bench and judges others by the ± of that fit: those within its range.
pub fn judged(
    fit: &CaseFit,
    fitted: &[DataPoint],
    others: &[DataPoint],
    by: Fitter<'_>,
) -> Result<Vec<Residual>> {
    let found = by.identified(&fit.muscle, fit, fitted)?;
    let Some(bench) = &found.bench else { return Ok(vec![]) };
    let model = (by.build)(&found.with_bench()).map_err(IdentifyError::Model)?;
    let w = &mut Workspace::new();
    let of_it = |p: &&DataPoint| found.candidate.of_section(&p.section).is_ok_and(|m| m == found.muscle);
    let one = |p: &DataPoint| {
        let contraction = p.at.contraction + found.candidate.contraction_offset;
        let (pressure_mpa, branch) = (p.at.pressure_mpa, p.at.direction());
        if bench.outside(pressure_mpa, contraction) > 0.0 {
            return None;
        }
        let mut evaluation = Evaluation::new(&*model, w, branch);
        let force_n = evaluation.force_n(pressure_mpa, contraction).ok()?;
        let parts = evaluation.uncertainty(pressure_mpa, contraction, force_n)?;
        // It is of the branch that was fitted.
        let half_width_n = Some(UncertaintyParts { friction: None, ..parts }.total());
        let blocked_n = model.force_n(w, pressure_mpa, 0.0).ok()?;
        Some(Residual {
            contraction,
            contraction_share: contraction / found.muscle.max_ideal_contraction(),
            left_n: p.at.force_n - force_n.max(0.0),
            branch,
            pressure_mpa,
            blocked_n,
            half_width_n,
        })
    };
    Ok(others.iter().filter(of_it).filter_map(one).collect())
}

/// Every point of a set, each judged by a fit that it was held out of.
pub fn of_fit(set: &MuscleCase, fit: &CaseFit, by: Fitter<'_>) -> Result<Vec<Residual>> {
    let points = points_of(set, fit);
    // Begun at the constants that all points give: those of a part are near to them.
    let (_, found) = by.fitted(fit, &points)?;
    let mut fit = fit.clone();
    for free in &mut fit.free {
        free.start = found.iter().find(|p| p.target == free.target).map(|p| p.value).or(free.start);
    }
    let mut all = vec![];
    for part in 0..PARTS {
        let of = |wanted: bool| -> Vec<DataPoint> {
            let each = points.iter().enumerate().filter(|(i, _)| (i % PARTS == part) == wanted);
            each.map(|(_, p)| *p).collect()
        };
        all.extend(judged(&fit, &of(false), &of(true), by)?);
    }
    Ok(all)
}

/// The share of the held-out points of each set that the ± of its fit holds.
pub fn cases(elements: &Build<'_>, progress: &dyn Progress) -> Result<Vec<VerificationRow>, Cancelled> {
    let sets: Vec<&'static MuscleCase> = muscles().unwrap_or_default();
    let by = Fitter { build: elements, progress: &CancelOnly(progress) };
    let of =
        |set: &&MuscleCase| set.fits.first().and_then(|fit| of_fit(set, fit, by).ok()).unwrap_or_default();
    let found = threads::map(&sets, of);
    progress.check()?;
    let row = |(set, list): (&'static MuscleCase, Vec<Residual>)| {
        let left = Left::of(list.iter());
        // Of few points the share of those that happen to be held scatters by more.
        let by_chance = 1.96 * (COVERAGE * (1.0 - COVERAGE) / left.points.max(1) as f64).sqrt();
        let off = Off { error: |share| (share - COVERAGE).abs(), tolerance: TOLERANCE.max(by_chance) };
        let title = &set.facts.title;
        let name = format!("{title}: {} points held out of fits of fe, within the ± of the fit", left.points);
        share_row(name, &set.facts.source, left.held, off)
    };
    Ok(sets.into_iter().zip(found).map(row).collect())
}
