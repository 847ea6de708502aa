//! The share of points held out of a fit that the ± of the fit covers.

use super::case::{CaseFit, MuscleCase, muscles};
use super::coverage::{Coverage, share_row};
use super::residual::{Fitter, ForceErrors, Residual, residuals};
use crate::identify::{Identification, Result};
use crate::measured::{DataPoint, mean_of_data};
use mckibben::cancel::Cancelled;
use mckibben::threads;
use mckibben::verification::VerificationRow;

/// Parts into which the points of a set are divided; each is held out of one fit.
const PARTS: usize = 5;

/// The points of a set that a fit is made to.
pub fn fit_points(set: &MuscleCase, fit: &CaseFit) -> Vec<DataPoint> {
    if fit.both_branches {
        set.points
            .iter()
            .filter(|p| !p.at.direction().is_mean())
            .copied()
            .collect()
    } else {
        mean_of_data(&set.points)
    }
}

impl Fitter<'_> {
    /// Fits a muscle to some points of its bench: the residuals of others within the range of that
    /// fit, with its ±.
    pub fn judged(
        &self,
        fit: &CaseFit,
        fitted: &[DataPoint],
        others: &[DataPoint],
    ) -> Result<Vec<Residual>> {
        let Identification {
            bench: Some(bench),
            candidate,
            muscle,
            ..
        } = self.identified(fit, fitted)?
        else {
            return Ok(vec![]);
        };
        let is_of_muscle = |p: &&DataPoint| {
            candidate
                .section_muscle(&p.section)
                .is_ok_and(|m| m == muscle)
        };
        let mut points: Vec<DataPoint> = others.iter().filter(is_of_muscle).copied().collect();
        points
            .iter_mut()
            .for_each(|p| p.at.contraction += candidate.contraction_offset);
        points.retain(|p| bench.outside(p.at.pressure_mpa, p.at.contraction) <= 0.0);
        let points: Vec<&DataPoint> = points.iter().collect();
        Ok(residuals(
            self.build,
            &muscle.with_bench(bench),
            &points,
            0.0,
        ))
    }
}

/// Every point of a set, each by a fit that it was held out of.
fn held_out_residuals(set: &MuscleCase, fit: &CaseFit, by: Fitter<'_>) -> Result<Vec<Residual>> {
    let points = fit_points(set, fit);
    // Begun at the constants that all points give: those of a part are near to them.
    let (_, constants) = by.fitted(fit, &points)?;
    let mut fit = fit.clone();
    for free in &mut fit.free {
        free.start = constants
            .iter()
            .find(|p| p.target == Some(free.target))
            .map(|p| p.value)
            .or(free.start);
    }
    let mut all = vec![];
    for part in 0..PARTS {
        let of_part = |inside: bool| -> Vec<DataPoint> {
            let each = points
                .iter()
                .enumerate()
                .filter(|(i, _)| (i % PARTS == part) == inside);
            each.map(|(_, p)| *p).collect()
        };
        all.extend(by.judged(&fit, &of_part(false), &of_part(true))?);
    }
    Ok(all)
}

/// The share of the held-out points of each set that the ± of its fit covers.
pub fn cases(by: Fitter<'_>) -> Result<Vec<VerificationRow>, Cancelled> {
    let sets: Vec<&'static MuscleCase> = muscles().unwrap_or_default();
    let residuals = threads::map(&sets, |set| {
        set.fits
            .first()
            .and_then(|fit| held_out_residuals(set, fit, by).ok())
            .unwrap_or_default()
    });
    by.progress.check()?;
    let row = |(set, list): (&'static MuscleCase, Vec<Residual>)| {
        let errors = ForceErrors::new(list.iter());
        let title = &set.facts.title;
        let name = format!(
            "{title}: {} points held out of fits of fe, within the ± of the fit",
            errors.points
        );
        share_row(name, &set.facts.source, &errors, Coverage::Exact)
    };
    Ok(sets.into_iter().zip(residuals).map(row).collect())
}
