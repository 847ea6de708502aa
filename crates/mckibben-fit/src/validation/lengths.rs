//! One hose in several lengths: the constants of some lengths against the points of the others.
//!
//! The ± of a muscle whose constants were identified at another length ([`mckibben::uncertainty::length_n`]) holds at least 95 % of the points of each
//! length, by the constants of each other one and by those of all others together.

use super::case::{By, CaseFit, MuscleCase, muscles};
use super::coverage::{AT_LEAST, share_row};
use super::report::{same, trainings};
use super::residual::{Fitter, Left, identified, residuals};
use crate::identify::{Build, IdentifyError};
use crate::measured::{DataPoint, mean_of_data};
use mckibben::cancel::Cancelled;
use mckibben::muscle::Muscle;
use mckibben::progress::{CancelOnly, Progress};
use mckibben::threads;
use mckibben::verification::VerificationRow;

/// What the constants of some lengths leave of the points of another one.
#[derive(Debug, Clone)]
pub struct OtherLength {
    pub set: &'static MuscleCase,
    /// The lengths that were fitted, in words.
    pub fitted: String,
    /// The length that is predicted in mm.
    pub length_mm: f64,
    /// What is left: measured less computed.
    pub left: Left,
}

/// Every fit of the constants of a first fit to some lengths of a set.
pub fn other_lengths(elements: &Build<'_>, progress: &dyn Progress) -> Result<Vec<OtherLength>, Cancelled> {
    let mut tasks = vec![];
    for set in muscles().unwrap_or_default() {
        let (means, first) = (mean_of_data(&set.points), set.fits.first());
        let by_length = set.fits.iter().filter(|fit| {
            fit.split.is_some_and(|split| split.by == By::Length) && first.is_some_and(|f| f.free == fit.free)
        });
        for fit in by_length {
            for training in trainings(fit, &means) {
                let (inside, outside): (Vec<DataPoint>, Vec<DataPoint>) =
                    means.iter().copied().partition(|p| training.holds(p, &fit.muscle));
                tasks.push((set, fit, training.label(&inside, &fit.muscle), inside, outside));
            }
        }
    }
    let by = Fitter { build: elements, progress: &CancelOnly(progress) };
    let found = threads::map(&tasks, |(set, fit, label, inside, outside)| {
        let muscle = muscle_of(fit, inside, by);
        muscle.map_or_else(|_| vec![], |muscle| of(set, fit, label, &muscle, outside, elements))
    });
    progress.check()?;
    Ok(found.into_iter().flatten().collect())
}

/// The muscle of a fit to some lengths, at the first of them, with its bench.
fn muscle_of(fit: &CaseFit, points: &[DataPoint], by: Fitter<'_>) -> Result<Muscle, IdentifyError> {
    let section = points.first().map(|p| p.section).unwrap_or_default();
    let start = section.apply(&fit.muscle).unwrap_or_else(|_| fit.muscle.clone());
    let found = identified(&start, fit, points, by)?;
    let muscle = found.muscle;
    Ok(found.bench.map_or_else(|| muscle.clone(), |bench| muscle.clone().with_bench(bench)))
}

/// What a muscle leaves of each other length.
fn of(
    set: &'static MuscleCase,
    fit: &CaseFit,
    fitted: &str,
    muscle: &Muscle,
    points: &[DataPoint],
    elements: &Build<'_>,
) -> Vec<OtherLength> {
    let each = |length_mm: f64| {
        let own: Vec<&DataPoint> = points
            .iter()
            .filter(|p| p.at.direction().is_mean() && same(By::Length.value(p, &fit.muscle), length_mm))
            .collect();
        let left = Left::of(residuals(elements, muscle, &own).iter());
        OtherLength { set, fitted: fitted.to_owned(), length_mm, left }
    };
    By::Length.values(points, &fit.muscle).into_iter().map(each).collect()
}

/// The share of the points of each length that the ± holds.
pub fn cases(elements: &Build<'_>, progress: &dyn Progress) -> Result<Vec<VerificationRow>, Cancelled> {
    Ok(other_lengths(elements, progress)?.iter().map(row).collect())
}

fn row(found: &OtherLength) -> VerificationRow {
    let OtherLength { set, fitted, length_mm, left } = found;
    let name = format!(
        "{}: {} points of {length_mm} mm by fe with the constants of {fitted}, within the ±",
        set.facts.title, left.points
    );
    share_row(name, &set.facts.source, left.held, AT_LEAST)
}
