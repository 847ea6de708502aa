//! The validation report of a measured muscle: the errors of each fit at the points it was fitted to and at the points it predicts.

pub use super::report_error::ReportError;

use super::case::{FittedSubset, MuscleCase};
use super::residual::{Left, Residual, compared, fitted, residuals};
use super::split::{Training, same, trainings};
use crate::identify::{Build, Identified, IdentifyError};
use crate::measured::{DataPoint, mean_of_data};
use mckibben::muscle::{Direction, Muscle};
use mckibben::progress::{CancelOnly, Progress};
use mckibben::threads;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A fit, and what is left of its points.
#[derive(Debug, Clone)]
pub struct FitResult {
    pub case: usize,
    pub fit: usize,
    /// The points it was fitted to: `all`, `nothing`, or their lengths or pressures.
    pub fitted_to: String,
    pub parameters: Vec<Identified>,
    pub muscle: Muscle,
    /// What is left, group by group: that of the fitted points before those that are predicted.
    pub groups: Vec<Group>,
}

/// What is left of some points.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    pub of: String,
    /// Whether nothing was fitted to them.
    pub blind: bool,
    /// Means of branches, and points without a branch.
    pub means: Left,
    /// Points of single branches, held against the ± with the part for friction.
    pub branches: Left,
    /// Those of each branch: while the muscle shortened or its pressure rose, and back.
    pub by_branch: Vec<(Direction, Left)>,
    /// Points to which the model has no answer.
    pub unanswered: usize,
    /// The means by ε.
    pub by_contraction: Vec<(Range<f64>, Left)>,
}

/// Bins of ε.
const BIN: f64 = 0.05;

/// Every fit of cases by a model, side by side; progress counts fits.
pub fn report(
    cases: &[&MuscleCase],
    build: &Build<'_>,
    progress: &dyn Progress,
) -> Result<Vec<FitResult>, ReportError> {
    let means: Vec<Vec<DataPoint>> = cases.iter().map(|case| mean_of_data(&case.points)).collect();
    let mut tasks = vec![];
    for (i, (case, means)) in cases.iter().zip(&means).enumerate() {
        for (k, fit) in case.fits.iter().enumerate() {
            tasks.extend(trainings(fit, means).into_iter().map(|t| (i, k, t)));
        }
    }
    let (done, quiet) = (AtomicUsize::new(0), CancelOnly(progress));
    let one = |(case, fit, training): &(usize, usize, Training)| {
        let result = run((cases[*case], &means[*case]), (*case, *fit), training, build, &quiet);
        progress.report(done.fetch_add(1, Ordering::Relaxed) + 1, tasks.len());
        result
    };
    threads::map(&tasks, one).into_iter().collect()
}

fn run(
    (case, means): (&MuscleCase, &[DataPoint]),
    (number, fit_number): (usize, usize),
    training: &Training,
    build: &Build<'_>,
    progress: &dyn Progress,
) -> Result<FitResult, ReportError> {
    progress.check()?;
    let fit = &case.fits[fit_number];
    let source = if fit.both_branches { &case.points } else { means };
    let (training_points, others): (Vec<DataPoint>, Vec<DataPoint>) =
        source.iter().partition(|p| training.holds(p, &fit.muscle));
    let label = training.label(&training_points, &fit.muscle);
    let (muscle, parameters) =
        fitted(fit, &training_points, build, progress).map_err(|error| match error {
            IdentifyError::Cancelled(cancelled) => cancelled.into(),
            error => ReportError::Fit {
                case: case.facts.name.clone(),
                fit: fit.name.clone(),
                fitted_to: label.clone(),
                error,
            },
        })?;
    let nothing = fit.free.is_empty();
    let compared = compared(means, &case.points);
    let group = |of: String, blind: bool, keep: &dyn Fn(&DataPoint) -> bool| {
        let wanted: Vec<&DataPoint> = compared.iter().copied().filter(|p| keep(p)).collect();
        let left = residuals(build, &muscle, &wanted);
        Group { unanswered: wanted.len() - left.len(), ..Group::of(of, blind, &left) }
    };
    let mut groups = vec![group(label.clone(), nothing, &|p| training.holds(p, &fit.muscle))];
    if let Some(by) = training.by {
        let values = by.values(&others, &fit.muscle);
        // One value each, or all that lie outside of a range.
        let ranged = matches!(fit.split.map(|s| s.fitted), Some(FittedSubset::Range(..)));
        if ranged && !values.is_empty() {
            groups.push(group(by.label(&values), true, &|p| !training.holds(p, &fit.muscle)));
        } else {
            groups.extend(values.iter().map(|v| {
                let keep = |p: &DataPoint| same(by.value(p, &fit.muscle), *v);
                group(by.label(&[*v]), true, &keep)
            }));
        }
    }
    let fitted_to = if nothing { "nothing".into() } else { label };
    Ok(FitResult { case: number, fit: fit_number, fitted_to, parameters, muscle, groups })
}

impl Group {
    fn of(of: String, blind: bool, left: &[Residual]) -> Self {
        let means = || left.iter().filter(|r| r.branch.is_mean());
        let end = means().map(|r| r.contraction).fold(0.0, f64::max);
        let bins = (0..).map(|i| f64::from(i) * BIN..f64::from(i + 1) * BIN);
        let bins = bins.take_while(|bin| bin.start <= end).map(|bin| {
            let left = Left::of(means().filter(|r| bin.contains(&r.contraction)));
            (bin, left)
        });
        let branches = [Direction::Contraction, Direction::Elongation];
        let by_branch = branches.map(|b| (b, Left::of(left.iter().filter(|r| r.branch == b))));
        Self {
            of,
            blind,
            unanswered: 0,
            by_contraction: bins.filter(|(_, left)| left.points > 0).collect(),
            by_branch: by_branch.into_iter().filter(|(_, left)| left.points > 0).collect(),
            means: Left::of(means()),
            branches: Left::of(left.iter().filter(|r| !r.branch.is_mean())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::case::muscles;
    use super::super::elements;
    use super::*;
    use mckibben::cancel::Cancelled;
    use mckibben::progress::Silent;

    /// Constants from 1 to 3 bar predict 4 and 5 bar; a law that stiffens at large stretch does so better on the hand-made muscle, whose
    /// rubber is not stated. A regression: nobody else has derived it.
    #[test]
    fn points_that_were_not_fitted_are_blind() {
        let mut case = muscles().unwrap().into_iter().find(|c| c.facts.name == "tondu2012").unwrap().clone();
        case.fits.retain(|fit| fit.split.is_some());
        let found = report(&[&case], &elements, &Silent).unwrap();
        let [plain, gent] = &found[..] else { panic!("{}", found.len()) };
        for r in [plain, gent] {
            assert_eq!(r.fitted_to, "0.1, 0.2, 0.3 MPa");
            assert_eq!((r.groups[0].blind, r.groups[1].blind), (false, true));
            assert_eq!(r.groups[1].of, "0.4, 0.5 MPa");
            let all: usize = r.groups.iter().map(|g| g.means.points).sum();
            let binned: usize = r.groups.iter().flat_map(|g| &g.by_contraction).map(|b| b.1.points).sum();
            assert_eq!((all, binned), (189, 189));
        }
        let blind = |r: &FitResult| r.groups[1].means.rms_n;
        assert!(blind(gent) < blind(plain), "{} {}", blind(gent), blind(plain));
    }

    #[test]
    fn a_caller_who_has_gone_ends_it() {
        struct Gone;
        impl Progress for Gone {
            fn cancelled(&self) -> bool {
                true
            }
        }
        assert_eq!(report(&muscles().unwrap(), &elements, &Gone).unwrap_err(), Cancelled.into());
    }
}
