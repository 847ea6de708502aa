//! What the points tell of an identified muscle, as its file keeps it: the covariance of its
//! constants, and up to 20 of the points with what the constants miss there.

use super::{Identification, Posterior, Request, posterior::PosteriorRequest};
use crate::measured::{DataPoint, Quantity, Section};
use mckibben_core::{
    built::{Experience, Prior},
    extremes::ends,
    muscle::{Bench, Constant, Direction, Muscle, OwnPoint},
};

/// Distances at which two points tell different things: of the contraction, and of the pressure over
/// the highest one.
const APART: (f64, f64) = (0.03, 0.25);

/// The points of a muscle in any of its lengths, as its constants have them.
pub fn of_muscle(muscle: &Muscle, points: impl Iterator<Item = DataPoint>) -> Vec<DataPoint> {
    let in_any_length = |p: &DataPoint| {
        let section = Section {
            length_mm: None,
            ..p.section
        };
        p.measured != Quantity::Volume
            && section.apply(muscle).is_ok_and(|of_row| of_row == *muscle)
    };
    points.filter(in_any_length).collect()
}

/// What the points tell of a muscle whose constants somebody found: these stay.
pub fn bench(request: &Request<'_>, result: &Identification) -> Option<Bench> {
    let candidate = &result.candidate;
    let muscle = &candidate.muscle;
    let points = result.points.iter().map(|f| {
        let mut point = f.point;
        point.at.contraction += candidate.contraction_offset;
        point.at.force_n -= candidate.force_offset_n;
        point
    });
    let points = of_muscle(muscle, points);
    let experience = Experience::built_in();
    let mut prior = Prior::of(muscle, experience);
    let share = prior.centre[Constant::Friction as usize];
    prior.centre = [0.0; Constant::ALL.len()];
    prior.centre[Constant::Friction as usize] = share;
    let posterior = PosteriorRequest {
        muscle,
        points: &points,
        build: request.build,
        experience,
        prior: &prior,
        progress: request.progress,
        search: false,
    };
    let posterior = posterior.posterior().ok().flatten()?;
    let model = (request.build)(muscle).ok()?.info().name.to_string();
    written(muscle, &posterior, model, request.history)
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
    let own: Vec<OwnPoint> = posterior
        .points
        .iter()
        .filter(|(point, _)| is_own(point))
        .map(|(point, predicted_n)| {
            let at = point.at;
            let off_n = at.force_n - predicted_n;
            (
                at.pressure_mpa,
                at.contraction,
                at.direction().sign(),
                digits(off_n),
            )
        })
        .collect();
    if own.is_empty() {
        return None;
    }
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
        covariance: posterior
            .covariance
            .iter()
            .map(|row| row.iter().map(|v| digits(*v)).collect())
            .collect(),
        own_points: spread(own),
        of: String::new(),
    };
    Some(bench.sealed(muscle))
}

/// The points that tell most: each farthest from those before it, the first with the largest
/// pressure.
fn spread(mut points: Vec<OwnPoint>) -> Vec<OwnPoint> {
    let highest_mpa = ends(points.iter().map(|p| p.0)).1.max(1e-3);
    let apart = |a: &OwnPoint, b: &OwnPoint| {
        let by_pressure = (a.0 - b.0) / (APART.1 * highest_mpa);
        by_pressure.hypot((a.1 - b.1) / APART.0).hypot(a.2 - b.2)
    };
    points.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut out: Vec<OwnPoint> = vec![];
    while out.len() < Bench::OWN_POINTS && !points.is_empty() {
        let nearest = |p: &OwnPoint| {
            out.iter()
                .map(|q| apart(p, q))
                .fold(f64::INFINITY, f64::min)
        };
        let place = (0..points.len()).max_by(|&i, &k| {
            nearest(&points[i])
                .total_cmp(&nearest(&points[k]))
                .then(k.cmp(&i))
        });
        out.extend(place.map(|place| points.remove(place)));
    }
    out
}

/// Five digits are enough for a ±.
fn digits(v: f64) -> f64 {
    format!("{v:.4e}").parse().unwrap_or(v)
}
