//! One hose in several lengths: the constants of some lengths against the points of the others.
//!
//! The ± of a muscle whose constants were identified at another length (`length_transfer`) holds at least 95 % of the points of each
//! length, by the constants of each other one and by those of all others together.

use super::case::{By, CaseFit, MuscleCase, muscles};
use super::coverage::share_row;
use super::report::{Training, trainings};
use super::residual::{Fitter, Left, residuals};
use crate::identify::{self, Build};
use crate::measured::{DataPoint, mean_of_data, same};
use mckibben::cancel::Cancelled;
use mckibben::progress::{CancelOnly, Progress};
use mckibben::threads;
use mckibben::verification::VerificationRow;

/// The share of the points of each length that the ± holds, of every fit of the constants of a first fit to some lengths of a set.
pub fn cases(elements: &Build<'_>, progress: &dyn Progress) -> Result<Vec<VerificationRow>, Cancelled> {
    let mut tasks = vec![];
    for set in muscles().unwrap_or_default() {
        let (means, first) = (mean_of_data(&set.points), set.fits.first());
        let by_length = |fit: &&CaseFit| {
            fit.split.is_some_and(|split| split.by == By::Length) && first.is_some_and(|f| f.free == fit.free)
        };
        for fit in set.fits.iter().filter(by_length) {
            tasks.extend(trainings(fit, &means).into_iter().map(|training| (set, training)));
        }
    }
    let by = Fitter { build: elements, progress: &CancelOnly(progress) };
    let found = threads::map(&tasks, |(set, training)| rows(set, training, by).unwrap_or_default());
    progress.check()?;
    Ok(found.concat())
}

/// What the muscle of a fit to some lengths, at the first of them, leaves of each other length.
fn rows(
    set: &'static MuscleCase,
    training: &Training<'_>,
    by: Fitter<'_>,
) -> identify::Result<Vec<VerificationRow>> {
    let means = mean_of_data(&set.points).into_iter();
    let (inside, outside): (Vec<DataPoint>, Vec<DataPoint>) = means.partition(|p| training.holds(p));
    let fitted = training.label(&training.values(&inside));
    let own = &training.fit.muscle;
    let start = inside.first().and_then(|p| p.section.apply(own).ok());
    let found = by.identified(&start.unwrap_or_else(|| own.clone()), training.fit, &inside)?;
    let muscle = found.with_bench();
    let row = |length_mm: f64| {
        let is_own = |p: &&DataPoint| {
            p.at.direction().is_mean() && training.value(p).is_some_and(|length| same(length, length_mm))
        };
        let points: Vec<&DataPoint> = outside.iter().filter(is_own).collect();
        let left = Left::of(residuals(by.build, &muscle, &points, 0.0).iter());
        let name = format!(
            "{}: {} points of {length_mm} mm by fe with the constants of {fitted}, within the ±",
            set.facts.title, left.points
        );
        share_row(name, &set.facts.source, left.held, None)
    };
    Ok(training.values(&outside).into_iter().map(row).collect())
}
