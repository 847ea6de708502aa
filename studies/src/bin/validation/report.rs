//! The errors of each fit of a measured muscle, at the points it was fitted to and at the points it
//! predicts.

use crate::{
    Result,
    case::{By, CaseFit, FitOn, MuscleCase},
    fit::{compared, fitted},
};
use mckibben_core::{
    muscle::{Direction, Muscle},
    threads,
};
use mckibben_fit::{
    identify::{Build, Identified},
    library::residual::{ForceErrors, Residual, residuals},
    measured::{DataPoint, distinct, mean_of_data, same},
};

/// A fit to some points, with its constants and its errors.
pub struct Fitted<'a> {
    pub case: &'a MuscleCase,
    pub fit: &'a CaseFit,
    /// Its points: `all`, `nothing`, or their lengths, pressures or contractions.
    pub to: String,
    pub constants: Vec<Identified>,
    pub muscle: Muscle,
    /// Errors, group by group: those of the fitted points before those that are predicted.
    pub groups: Vec<Group>,
}

/// Errors at some points: measured − computed.
pub struct Group {
    /// The points that are compared.
    pub of: String,
    /// Whether nothing was fitted to them.
    pub blind: bool,
    /// Means of branches and points without a branch.
    pub means: ForceErrors,
    /// The points of each branch of the hysteresis, where it was measured; the ± has its part for
    /// friction if the muscle states none.
    pub branches: Vec<(Direction, ForceErrors)>,
    /// The bias of the means by contraction, in bins of [`BIN`].
    pub bias_n: [Option<f64>; BINS],
}

/// Width of a bin of ε, and how many there are.
pub const BIN: f64 = 0.05;
pub const BINS: usize = 7;

/// Every fit of cases by a model.
pub fn report<'a>(cases: &[&'a MuscleCase], build: &Build<'_>) -> Result<Vec<Fitted<'a>>> {
    let mut all = vec![];
    for &case in cases {
        let means = mean_of_data(&case.points);
        let of_fit = |fit| trainings(case, fit, &means);
        all.extend(case.fits.iter().flat_map(of_fit));
    }
    let made = threads::map(&all, |training| training.fitted(build));
    made.into_iter().collect()
}

/// Points that are fitted in one go.
struct Training<'a> {
    case: &'a MuscleCase,
    fit: &'a CaseFit,
    /// Both ends in it.
    range: (f64, f64),
    /// Fitted are those outside.
    outside: bool,
}

fn trainings<'a>(case: &'a MuscleCase, fit: &'a CaseFit, means: &[DataPoint]) -> Vec<Training<'a>> {
    let of = |low, high, outside| Training {
        case,
        fit,
        range: (low, high),
        outside,
    };
    let all = of(f64::NEG_INFINITY, f64::INFINITY, false);
    let each = |outside| {
        all.values(means)
            .into_iter()
            .map(|v| of(v, v, outside))
            .collect()
    };
    match fit.split.map(|split| (split.fit_on, split.from, split.to)) {
        Some((Some(FitOn::One), ..)) => each(false),
        Some((Some(FitOn::Others), ..)) => each(true),
        Some((None, Some(from), Some(to))) => vec![of(from, to, false)],
        _ => vec![all],
    }
}

impl<'a> Training<'a> {
    fn fitted(&self, build: &Build<'_>) -> Result<Fitted<'a>> {
        let Self { case, fit, .. } = *self;
        let means = mean_of_data(&case.points);
        let source = if fit.both_branches {
            &case.points
        } else {
            &means
        };
        let (inside, others): (Vec<DataPoint>, Vec<DataPoint>) =
            source.iter().partition(|p| self.holds(p));
        let label = self.label(&self.values(&inside));
        let (muscle, constants) = fitted(build, fit, &inside)
            .map_err(|e| format!("{}, fit \"{}\" on {label}: {e}", case.name, fit.name))?;
        let compared = compared(&means, &case.points);
        let group = |of: String, blind: bool, keep: &dyn Fn(&DataPoint) -> bool| {
            let points = compared.iter().copied().filter(|p| keep(p));
            Group::new(
                of,
                blind,
                &residuals(build, &muscle, points, case.friction_share()),
            )
        };
        let nothing = fit.free.is_empty();
        let mut groups = vec![group(label.clone(), nothing, &|p| self.holds(p))];
        let values = self.values(&others);
        // A group for each value, or one for all outside of a range.
        if self.range.0 < self.range.1 && !values.is_empty() {
            groups.push(group(self.label(&values), true, &|p| !self.holds(p)));
        } else {
            groups.extend(values.iter().map(|v| {
                let keep = |p: &DataPoint| self.value(p).is_some_and(|value| same(value, *v));
                group(self.label(&[*v]), true, &keep)
            }));
        }
        Ok(Fitted {
            case,
            fit,
            to: if nothing { "nothing".into() } else { label },
            constants,
            muscle,
            groups,
        })
    }

    /// The quantity that divides the points.
    fn value(&self, point: &DataPoint) -> Option<f64> {
        let length_mm = point.section.length_mm;
        Some(match self.fit.split?.by {
            By::Length => length_mm.unwrap_or(self.fit.muscle.length_mm()),
            By::Pressure => point.at.pressure_mpa,
            By::Contraction => point.at.contraction,
        })
    }

    fn holds(&self, point: &DataPoint) -> bool {
        let Some(v) = self.value(point) else {
            return true;
        };
        let (low, high) = self.range;
        let inside = (v > low || same(v, low)) && (v < high || same(v, high));
        inside != self.outside
    }

    /// The values of points, each once.
    fn values(&self, points: &[DataPoint]) -> Vec<f64> {
        distinct(points.iter().filter_map(|p| self.value(p)))
    }

    /// `233, 281 mm`, or `0.04 to 0.6 MPa` where there are many.
    fn label(&self, values: &[f64]) -> String {
        let unit = match self.fit.split.map(|split| split.by) {
            None => return "all".into(),
            Some(By::Length) => " mm",
            Some(By::Pressure) => " MPa",
            Some(By::Contraction) => "",
        };
        let texts: Vec<String> = values.iter().map(f64::to_string).collect();
        match texts.as_slice() {
            [first, .., last] if texts.len() > 5 => format!("{first} to {last}{unit}"),
            _ => texts.join(", ") + unit,
        }
    }
}

impl Group {
    pub fn new(of: String, blind: bool, residuals: &[Residual]) -> Self {
        let means = || residuals.iter().filter(|r| r.branch.is_mean());
        let on = |branch| ForceErrors::new(residuals.iter().filter(|r| r.branch == branch));
        let branches = [Direction::Contraction, Direction::Elongation];
        let branches = branches.map(|branch| (branch, on(branch))).into_iter();
        let bias_n = std::array::from_fn(|i| {
            let is_in = |r: &&Residual| (r.contraction / BIN) as usize == i;
            let errors = ForceErrors::new(means().filter(is_in));
            (errors.points > 0).then_some(errors.bias_n)
        });
        Self {
            of,
            blind,
            means: ForceErrors::new(means()),
            branches: branches.filter(|b| b.1.points > 0).collect(),
            bias_n,
        }
    }
}
