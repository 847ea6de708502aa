//! What the points tell of an identified muscle, as its file keeps it: the covariance of its
//! constants, and up to 20 of the points with what the constants miss there.

use super::{IdentificationRequest, Posterior, PosteriorRequest, Result};
use crate::measured::{DataPoint, Section};
use mckibben_core::{
    built::{Experience, Prior},
    by_number::SortByNumber,
    extremes::ends,
    muscle::{Bench, Constant, Constants, Direction, Muscle, OwnPoint},
};

/// Distances at which two points tell different things: of the contraction, and of the pressure over
/// the highest one.
const APART: (f64, f64) = (0.03, 0.25);

/// The points of a muscle in any of its lengths, as its constants have them.
fn of_muscle(muscle: &Muscle, points: &[DataPoint]) -> Vec<DataPoint> {
    let in_any_length = |p: &DataPoint| {
        let section = Section {
            length_mm: None,
            ..p.section
        };
        section.apply(muscle).is_ok_and(|of_row| of_row == *muscle)
    };
    points.iter().copied().filter(in_any_length).collect()
}

/// What points leave of a muscle whose constants were found, beside the factor on the pull and the
/// friction among them. Nothing is sought.
pub fn left_over(
    request: &IdentificationRequest<'_>,
    muscle: &Muscle,
    points: &[DataPoint],
    found: &Constants,
) -> Result<Option<Posterior>> {
    let experience = Experience::built_in();
    let mut prior = Prior::of(muscle, experience);
    prior.centre = Constant::ALL.map(|constant| match constant {
        Constant::PullFactor | Constant::Friction => found[constant as usize],
        _ => 0.0,
    });
    PosteriorRequest {
        muscle,
        points: &of_muscle(muscle, points),
        build: request.build,
        experience,
        prior: &prior,
        progress: request.progress,
        bounds: &[],
        search: false,
        zero: false,
    }
    .posterior()
}

/// What a posterior says of the muscle with its constants; `None` where no point is of its length.
pub fn written(
    muscle: &Muscle,
    posterior: &Posterior,
    model: String,
    history: bool,
) -> Option<Bench> {
    let is_own = |p: &DataPoint| p.section.apply(muscle).is_ok_and(|m| m == *muscle);
    let all: Vec<DataPoint> = posterior.points.iter().map(|p| p.0).collect();
    let own = posterior.points.iter().filter(|(point, ..)| is_own(point));
    let own = own.map(|&(DataPoint { at, .. }, off_n, noise_n)| {
        let sign = at.direction().sign();
        let own = (at.pressure_mpa, at.contraction, sign, digits(off_n));
        (own, digits(noise_n))
    });
    let own: Vec<(OwnPoint, f64)> = own.collect();
    if own.is_empty() {
        return None;
    }
    let (own_points, mut own_noise): (Vec<_>, Vec<_>) = spread(own).into_iter().unzip();
    let is_usual = |p: &DataPoint| p.error.is_none() && p.weight == 1.0;
    if all.iter().all(is_usual) {
        own_noise.clear();
    }
    let factor = posterior.variance_factor;
    // The first row in time order may state none: the way of the others is known.
    let stated = history || all.iter().all(|p| p.at.branch.is_some());
    let seen = |b: &Direction| stated && all.iter().any(|p| p.at.branch == Some(*b));
    let mut lengths_mm = vec![muscle.length_mm()];
    for length in all.iter().filter_map(|p| p.section.length_mm) {
        if !lengths_mm.contains(&length) {
            lengths_mm.push(length);
        }
    }
    let bench = Bench {
        laboratory: None,
        model,
        lengths_mm,
        points: all.len(),
        branches: Direction::ALL.into_iter().filter(seen).collect(),
        pressure_mpa: ends(all.iter().map(|p| p.at.pressure_mpa)),
        contraction: ends(all.iter().map(|p| p.at.contraction)),
        pull_factor: digits(posterior.constants[Constant::PullFactor as usize].exp()),
        friction_share: digits(posterior.constants[Constant::Friction as usize]),
        constants: Constant::ALL.to_vec(),
        shift: vec![],
        covariance: posterior
            .covariance
            .iter()
            .map(|row| row.iter().map(|v| digits(factor * v)).collect())
            .collect(),
        variance_factor: Some(digits(factor)).filter(|factor| *factor > 1.0),
        own_points,
        own_noise,
        of: String::new(),
    };
    Some(bench.sealed(muscle))
}

/// With the constants that were found beside a muscle, and what had been found of it before.
pub fn shifted(mut bench: Bench, base: &Muscle, found: &Constants) -> Bench {
    let shift = Constant::ALL.iter().zip(found).map(|(constant, x)| {
        let at = |bench: &Bench| bench.constants.iter().position(|c| c == constant);
        let earlier = base.bench().and_then(|bench| bench.shift.get(at(bench)?));
        digits(x + earlier.unwrap_or(&0.0))
    });
    bench.shift = shift.collect();
    bench
}

/// The points that tell most: each farthest from those before it, the first with the largest
/// pressure.
fn spread(mut points: Vec<(OwnPoint, f64)>) -> Vec<(OwnPoint, f64)> {
    let highest_mpa = ends(points.iter().map(|(p, _)| p.0)).1.max(1e-3);
    let apart = |(a, _): &(OwnPoint, f64), (b, _): &(OwnPoint, f64)| {
        let by_pressure = (a.0 - b.0) / (APART.1 * highest_mpa);
        by_pressure.hypot((a.1 - b.1) / APART.0).hypot(a.2 - b.2)
    };
    points.sort_by_number(|(a, _)| -a.0);
    let order = farthest_first(points.len(), Bench::OWN_POINTS, |i, k| {
        apart(&points[i], &points[k])
    });
    order.into_iter().map(|i| points[i]).collect()
}

/// Some of `count` things, by their places: the first one, then each farthest from those before it; of
/// equal ones the first.
pub(crate) fn farthest_first(
    count: usize,
    some: usize,
    apart: impl Fn(usize, usize) -> f64,
) -> Vec<usize> {
    let mut out: Vec<usize> = vec![];
    while out.len() < some.min(count) {
        let nearest = |i: usize| {
            out.iter()
                .map(|&k| apart(i, k))
                .fold(f64::INFINITY, f64::min)
        };
        let next = (0..count)
            .filter(|i| !out.contains(i))
            .max_by(|&i, &k| nearest(i).total_cmp(&nearest(k)).then(k.cmp(&i)));
        out.extend(next);
    }
    out
}

/// Five digits are enough for a ±.
fn digits(v: f64) -> f64 {
    format!("{v:.4e}").parse().unwrap_or(v)
}
