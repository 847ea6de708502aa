//! Measured muscles by the families that they do not belong to.

use crate::{
    families::{Known, Series, experience, prior_of},
    fit::posterior,
    left_out::{Judged, SeriesJudged},
};
use mckibben_core::{
    analysis::{Evaluation, Options},
    built::{Experience, Predictor, Prior},
    extremes::peak,
    model::Workspace,
    muscle::Muscle,
    random::Random,
    threads,
};
use mckibben_fit::{
    identify::{Build, Quantity, written_bench},
    library::residual::of_branch,
    measured::DataPoint,
};

/// The points of a series by a predictor of its muscle, or of one made from it.
pub fn judged(
    series: &Series,
    muscle: &Muscle,
    predictor: &Predictor,
    points: &[DataPoint],
    build: &Build<'_>,
) -> Option<Vec<Judged>> {
    let model = build(muscle).ok()?;
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

/// Sets of own points of a series.
const DRAWS: u64 = 20;

/// `n` rows of a series, drawn at random, and all others.
fn drawn(points: &[DataPoint], n: usize, draw: u64) -> (Vec<DataPoint>, Vec<DataPoint>) {
    let mut random = Random(draw);
    let mut own = points.to_vec();
    for i in 0..n.min(own.len()) {
        let other = random.between(i as f64, own.len() as f64) as usize;
        own.swap(i, other);
    }
    let rest = own.split_off(n.min(own.len()));
    (own, rest)
}

/// The muscle of a series, and what is known of it, after some of its points were measured.
pub fn after(
    series: &Series,
    points: &[DataPoint],
    before: (&Experience, &Prior),
    build: &Build<'_>,
) -> Option<(Muscle, Predictor)> {
    let posterior = posterior(&series.muscle, points, before, build)?;
    let muscle = series.muscle.with_constants(&posterior.constants).ok()?;
    let bench = written_bench(&muscle, &posterior, "fe".to_owned(), false)?;
    let muscle = muscle.with_bench(bench);
    let predictor = Predictor::of(&muscle, before.0)?;
    Some((muscle, predictor))
}

/// Every series by the families that it does not belong to, and so many of its own points.
pub fn left_out(known: &[Known<'_>], own_points: usize, build: &Build<'_>) -> Vec<SeriesJudged> {
    let one = |of: &&Known<'_>| {
        let series = of.series;
        let others: Vec<&Known<'_>> = known
            .iter()
            .filter(|k| k.series.family != series.family)
            .collect();
        let experience = experience(&others);
        let prior = prior_of(series, &experience);
        let list = if own_points == 0 {
            let predictor = Predictor::about(&series.muscle, prior.centre, prior.covariance())?;
            judged(series, &series.muscle, &predictor, &series.points, build)?
        } else {
            let judged_by = |draw| {
                let (own, rest) = drawn(&series.points, own_points, draw);
                let (muscle, predictor) = after(series, &own, (&experience, &prior), build)?;
                judged(series, &muscle, &predictor, &rest, build)
            };
            let all: Vec<_> = (0..DRAWS).filter_map(judged_by).collect();
            all.concat()
        };
        // A series that is no longer than a bench leaves nothing to judge.
        (!list.is_empty()).then(|| (series.name.clone(), list))
    };
    let list: Vec<&Known<'_>> = known.iter().collect();
    threads::map(&list, one).into_iter().flatten().collect()
}
