//! What the ± covers where the family of a muscle is left out.

use super::{
    super::{
        coverage::validated,
        residual::{Fitter, of_branch},
    },
    Known, Series, experience, known, posterior, prior_of, series,
};
use crate::{
    identify::{farthest_first, written_bench},
    least_squares::Errors,
    measured::{DataPoint, Quantity},
    validation::case::MuscleCase,
};
use mckibben_core::{
    analysis::{Evaluation, Options},
    built::{Experience, Predictor, Prior},
    extremes::peak,
    model::Workspace,
    muscle::Muscle,
    threads,
    verification::{Measure, VerificationRow},
};
use std::fmt;

/// A measured point beside its prediction.
#[derive(Debug, Clone, Copy)]
pub struct Judged {
    /// Measured less median, over the largest pull of the series.
    pub off: f64,
    /// Half of the interval over it.
    pub half: f64,
}

/// The points of a series by a predictor of its muscle, or of one made from it.
pub(super) fn judged(
    series: &Series,
    muscle: &Muscle,
    predictor: &Predictor,
    points: &[DataPoint],
    by: Fitter<'_>,
) -> Option<Vec<Judged>> {
    let model = (by.build)(muscle).ok()?;
    let highest_mpa = peak(series.points.iter().map(|p| p.at.pressure_mpa));
    let largest_n = predictor.at(highest_mpa, 0.0, 0.0)?.force_n;
    let w = &mut Workspace::new();
    let one = |point: &DataPoint| {
        let (p, e) = (point.at.pressure_mpa, point.at.contraction);
        let branch = point.at.direction();
        let two_sided = Options {
            two_sided: true,
            ..branch.into()
        };
        let mut model = Evaluation::new(&*model, w, two_sided);
        let force_n = model.force_n(p, e).ok()?;
        let predicted = model.predicted_by(predictor, p, e, force_n)?;
        let (median_n, half_n) = of_branch(branch, predicted);
        // A muscle that pulls nothing is slack.
        let median_n = if point.measured == Quantity::Force {
            median_n.max(0.0)
        } else {
            median_n
        };
        Some(Judged {
            off: (point.at.force_n - median_n) / largest_n,
            half: half_n / largest_n,
        })
    };
    Some(points.iter().filter_map(one).collect())
}

/// How the muscles of a table are known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Way {
    /// By the other families alone.
    Nothing,
    /// By so many of its own points, and the other families.
    OwnPoints(usize),
}

impl Way {
    /// The ways of the table.
    pub const ALL: [Self; 4] = [
        Self::Nothing,
        Self::OwnPoints(1),
        Self::OwnPoints(3),
        Self::OwnPoints(10),
    ];

    fn name(self) -> String {
        match self {
            Self::Nothing => "no own points".to_owned(),
            Self::OwnPoints(1) => "1 own point".to_owned(),
            Self::OwnPoints(n) => format!("{n} own points"),
        }
    }
}

/// What the ± covers, by series.
pub struct Coverage {
    pub way: Way,
    pub series: Vec<(String, Vec<Judged>)>,
}

/// Points of a series that are spread over its pressures and contractions, from ε 0.03 on: `n` of
/// them.
fn spread(points: &[DataPoint], n: usize) -> Vec<usize> {
    const LEAST: f64 = 0.03;
    let highest_mpa = peak(points.iter().map(|p| p.at.pressure_mpa));
    let largest = peak(points.iter().map(|p| p.at.contraction));
    let mut order: Vec<usize> = (0..points.len())
        .filter(|&i| points[i].at.contraction >= LEAST)
        .collect();
    let place = |i: usize| {
        let at = points[i].at;
        (
            at.pressure_mpa / highest_mpa,
            at.contraction / largest,
            0.5 * at.direction().sign(),
        )
    };
    // The first in the middle, each further one farthest from those before it.
    let middle = (0.6, 0.4, 0.0);
    let apart =
        |a: (f64, f64, f64), b: (f64, f64, f64)| (a.0 - b.0).hypot(a.1 - b.1).hypot(a.2 - b.2);
    order.sort_by(|&i, &k| apart(place(i), middle).total_cmp(&apart(place(k), middle)));
    // Of equal ones that farthest from the middle.
    if let Some(rest) = order.get_mut(1..) {
        rest.reverse();
    }
    farthest_first(order.len(), n, |i, k| {
        apart(place(order[i]), place(order[k]))
    })
    .into_iter()
    .map(|i| order[i])
    .collect()
}

/// The muscle of a series, and what is known of it, after some of its points were measured.
pub(super) fn after(
    series: &Series,
    points: &[DataPoint],
    (experience, prior): (&Experience, &Prior),
    by: Fitter<'_>,
) -> Option<(Muscle, Predictor)> {
    let posterior = posterior(series, points, (experience, prior), by)?;
    let muscle = series.muscle.with_constants(&posterior.constants).ok()?;
    let bench = written_bench(&muscle, &posterior, "fe".to_owned(), false)?;
    let muscle = muscle.with_bench(bench);
    let predictor = Predictor::of(&muscle, experience)?;
    Some((muscle, predictor))
}

/// Every series by the families that it does not belong to.
pub fn left_out(known: &[Known<'_>], way: Way, by: Fitter<'_>) -> Coverage {
    let one = |of: &&Known<'_>| {
        let series = of.series;
        let others: Vec<&Known<'_>> = known
            .iter()
            .filter(|k| k.series.family != series.family)
            .collect();
        let experience = experience(&others);
        let prior = prior_of(series, &experience);
        let list = match way {
            Way::Nothing => {
                let predictor = Predictor::about(&series.muscle, prior.centre, prior.covariance())?;
                judged(series, &series.muscle, &predictor, &series.points, by)?
            }
            Way::OwnPoints(n) => {
                let own = spread(&series.points, n);
                let all = 0..series.points.len();
                let (own, rest): (Vec<_>, Vec<_>) = all.partition(|i| own.contains(i));
                let [fitted, rest] =
                    [own, rest].map(|list| Vec::from_iter(list.iter().map(|&i| series.points[i])));
                let (muscle, predictor) = after(series, &fitted, (&experience, &prior), by)?;
                judged(series, &muscle, &predictor, &rest, by)?
            }
        };
        Some((series.name.clone(), list))
    };
    let list: Vec<&Known<'_>> = known.iter().collect();
    Coverage {
        way,
        series: threads::map(&list, one).into_iter().flatten().collect(),
    }
}

fn inside(list: &[Judged]) -> f64 {
    let held = list.iter().filter(|j| j.off.abs() <= j.half).count();
    held as f64 / list.len().max(1) as f64
}

/// What the differences from the medians, and the halves of the intervals, amount to.
fn errors(list: &[Judged]) -> [Errors; 2] {
    [|j: &Judged| j.off, |j: &Judged| j.half].map(|of| Errors::new(list.iter().map(of)))
}

impl Coverage {
    fn all(&self) -> Vec<Judged> {
        self.series
            .iter()
            .flat_map(|s| s.1.iter().copied())
            .collect()
    }

    /// Share of the points inside, mean half-width and bias over the largest pull, and the share of
    /// the worst series.
    pub fn summary(&self) -> (f64, f64, f64, f64) {
        let all = self.all();
        let [off, half] = errors(&all);
        let worst = self.series.iter().map(|s| inside(&s.1));
        (
            inside(&all),
            half.mean,
            // Below zero where the prediction is too strong.
            off.mean,
            worst.fold(1.0, f64::min),
        )
    }
}

/// The rows of each way: the share of the points inside, and that of the worst series.
pub(in crate::validation) fn cases(
    sets: &[&'static MuscleCase],
    by: Fitter<'_>,
) -> Vec<VerificationRow> {
    let all = series(sets);
    let known = known(&all, by);
    Way::ALL
    .into_iter()
    .map(|way| {
        let coverage = left_out(&known, way, by);
        let (share, half, bias, worst) = coverage.summary();
        let name = format!(
            "families left out, {}: {} points of {} series within the ± ({:.1} % of the largest \
             pull, bias {:+.1} %, worst series {:.0} %)",
            way.name(),
            coverage.all().len(),
            coverage.series.len(),
            100.0 * half,
            100.0 * bias,
            100.0 * worst
        );
        let row = VerificationRow::new(name, "all measured muscles", 0.95, Some(share), 0.0);
        validated(row, Measure::Share, Some((0.95 - share).max(0.0)))
    })
    .collect()
}

impl fmt::Display for Coverage {
    /// The summary, and series by series.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (share, half, bias, worst) = self.summary();
        writeln!(
            f,
            "{}: inside {:.1} %, half-width {:.1} %, bias {:+.1} %, worst series {:.0} %",
            self.way.name(),
            100.0 * share,
            100.0 * half,
            100.0 * bias,
            100.0 * worst
        )?;
        for (name, list) in &self.series {
            let [off, half] = errors(list);
            writeln!(
                f,
                "  {name}: {} points, inside {:.0} %, half-width {:.1} %, bias {:+.1} %, rms {:.1} %",
                list.len(),
                100.0 * inside(list),
                100.0 * half.mean,
                100.0 * off.mean,
                100.0 * off.rms
            )?;
        }
        Ok(())
    }
}
