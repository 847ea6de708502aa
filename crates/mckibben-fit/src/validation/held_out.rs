//! What share of points that were held out of a fit lies within the ± that the fit leaves.

use super::case::{CaseFit, MuscleCase, muscles};
use super::coverage::{COVERAGE, share_row};
use super::residual::{Fitter, Left, Residual, residuals};
use crate::identify::{Build, Result};
use crate::measured::{DataPoint, mean_of_data};
use mckibben::cancel::Cancelled;
use mckibben::progress::{CancelOnly, Progress};
use mckibben::threads;
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
    let of_it = |p: &&DataPoint| found.candidate.of_section(&p.section).is_ok_and(|m| m == found.muscle);
    let mut points: Vec<DataPoint> = others.iter().filter(of_it).copied().collect();
    points.iter_mut().for_each(|p| p.at.contraction += found.candidate.contraction_offset);
    points.retain(|p| bench.outside(p.at.pressure_mpa, p.at.contraction) <= 0.0);
    Ok(residuals(by.build, &found.with_bench(), &points.iter().collect::<Vec<_>>(), 0.0))
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
        let title = &set.facts.title;
        let name = format!("{title}: {} points held out of fits of fe, within the ± of the fit", left.points);
        share_row(name, &set.facts.source, left.held, Some(TOLERANCE.max(by_chance)))
    };
    Ok(sets.into_iter().zip(found).map(row).collect())
}
