//! The share of points held out of a fit that the ± of the fit covers.

use super::{
    case::{CaseFit, MuscleCase},
    coverage::share_row,
    residual::{Fitter, ForceErrors, Residual, residuals},
};
use crate::{
    identify::{Identification, Result},
    measured::{DataPoint, mean_of_data},
};
use mckibben_core::{threads, verification::VerificationRow};

/// Parts into which the points of a set are divided; each is held out of one fit.
const PARTS: usize = 5;

/// The points of a set that a fit is made to.
pub fn fit_points(set: &MuscleCase, fit: &CaseFit) -> Vec<DataPoint> {
    if !fit.both_branches {
        return mean_of_data(&set.points);
    }
    set.points
        .iter()
        .filter(|p| !p.at.direction().is_mean())
        .copied()
        .collect()
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
        } = self.learnt(fit, fitted)?
        else {
            return Ok(vec![]);
        };
        let mut points = others.to_vec();
        points.retain_mut(|p| {
            p.at.contraction += candidate.contraction_offset;
            let of_row = candidate.section_muscle(&p.section);
            of_row.is_ok_and(|of_row| of_row == muscle)
        });
        let muscle = muscle.with_bench(bench);
        Ok(residuals(self.build, &muscle, &points, 0.0))
    }
}

/// Every point of a set, each by a fit that it was held out of.
fn held_out_residuals(set: &MuscleCase, fit: &CaseFit, by: Fitter<'_>) -> Result<Vec<Residual>> {
    let points = fit_points(set, fit);
    let mut all = vec![];
    for part in 0..PARTS {
        let numbered = points.iter().copied().enumerate();
        let (left_out, fitted): (Vec<_>, Vec<_>) = numbered.partition(|(i, _)| i % PARTS == part);
        let points = |part: Vec<(usize, DataPoint)>| part.into_iter().map(|(_, p)| p).collect();
        let (left_out, fitted): (Vec<_>, Vec<_>) = (points(left_out), points(fitted));
        all.extend(by.judged(fit, &fitted, &left_out)?);
    }
    Ok(all)
}

/// The share of the held-out points of each set that the ± of its fit covers.
pub(super) fn cases(sets: &[&'static MuscleCase], by: Fitter<'_>) -> Vec<VerificationRow> {
    threads::map(sets, |&set| {
        let fit = set.fits.first();
        let list = fit.and_then(|fit| held_out_residuals(set, fit, by).ok());
        let errors = ForceErrors::new(list.iter().flatten());
        let name = format!(
            "{}: {} points held out of fits of fe, within the ± of the fit",
            set.facts.title, errors.points
        );
        share_row(name, &set.facts.source, &errors)
    })
}
