//! One hose in several lengths: the constants of some lengths against the points of the others.
//!
//! The ± of a muscle whose constants were identified at another length (`length_transfer`) covers at least 95 % of the points of each
//! length, by the constants of each other one and by those of all others together.

use super::case::{By, CaseFit, MuscleCase, muscles};
use super::coverage::share_row;
use super::report::{Training, trainings};
use super::residual::{Fitter, ForceErrors, residuals};
use crate::identify::Result;
use crate::measured::{DataPoint, mean_of_data, same};
use mckibben::cancel::Cancelled;
use mckibben::threads;
use mckibben::verification::VerificationRow;

/// The share of the points of each length that the ± covers, of every fit of the constants of a first fit to some lengths of a set.
pub fn cases(by: Fitter<'_>) -> Result<Vec<VerificationRow>, Cancelled> {
    let mut tasks = vec![];
    let with_means = |set: &'static MuscleCase| (set, mean_of_data(&set.points));
    let sets: Vec<_> = muscles().unwrap_or_default().into_iter().map(with_means).collect();
    for (set, means) in &sets {
        let first = set.fits.first();
        let by_length = |fit: &&CaseFit| {
            fit.split.is_some_and(|split| split.by == By::Length) && first.is_some_and(|f| f.free == fit.free)
        };
        for fit in set.fits.iter().filter(by_length) {
            tasks.extend(trainings(set, fit, means).into_iter().map(|training| (*set, training)));
        }
    }
    let rows = threads::map(&tasks, |(set, training)| rows(set, training, by).unwrap_or_default());
    by.progress.check()?;
    Ok(rows.concat())
}

/// The errors of the muscle of a fit to some lengths, at the first of them, for each other length.
fn rows(set: &'static MuscleCase, training: &Training<'_>, by: Fitter<'_>) -> Result<Vec<VerificationRow>> {
    let (inside, outside): (Vec<DataPoint>, Vec<DataPoint>) =
        training.means.iter().partition(|p| training.holds(p));
    let fitted = training.label(&training.values(&inside));
    let mut fit = training.fit.clone();
    if let Some(start) = inside.first().and_then(|p| p.section.apply(&fit.muscle).ok()) {
        fit.muscle = start;
    }
    let muscle = by.identified(&fit, &inside)?.with_bench();
    let row = |length_mm: f64| {
        let has_length = |p: &&DataPoint| {
            p.at.direction().is_mean() && training.value(p).is_some_and(|length| same(length, length_mm))
        };
        let points: Vec<&DataPoint> = outside.iter().filter(has_length).collect();
        let errors = ForceErrors::new(residuals(by.build, &muscle, &points, 0.0).iter());
        let name = format!(
            "{}: {} points of {length_mm} mm by fe with the constants of {fitted}, within the ±",
            set.facts.title, errors.points
        );
        share_row(name, &set.facts.source, errors.held, None)
    };
    Ok(training.values(&outside).into_iter().map(row).collect())
}
