//! The ± of an identified muscle on the bench of its points.
//!
//! A further point of the same bench lies from the fit by less than t √(s² + g C gᵀ) in 95 of 100
//! cases (Seber & Wild 2003 \[seber2003\], ch. 5): s the standard deviation of the residuals, C the
//! covariance of the constants, g the slopes of the pull by them at that point, t Student's
//! quantile. t s and t √(g C gᵀ), on a grid over the range of the points, are kept.
//!
//! t s holds for errors with a normal distribution. Residuals of a measured muscle have shorter
//! tails: of 20 points on, the residual that 95 % of the points do not exceed takes the place of t
//! s (the 0.95 (n + 1)-th smallest of n, interpolated).

use super::problem::Problem;
use super::{Identification, PointFit, Request};
use crate::least_squares::{Estimate, Unknown, slopes, t95};
use crate::measured::{DataPoint, MeasuredPoint, Section};
use mckibben::model::{ForceModel, ThickWall, Workspace};
use mckibben::muscle::{Bench, Direction};
use mckibben::units::plausible;

/// Pressures and contractions of the grid.
const GRID: (usize, usize) = (3, 5);

/// A minimum of the residuals, with the unknowns that are at their bounds set to these.
pub(super) struct Minimum<'a> {
    pub unknowns: &'a [Unknown],
    pub estimate: &'a Estimate,
    pub x: &'a [f64],
}

/// The bench of the muscle itself; `None` where no point is of it, or the half-width of the fit is
/// not known.
pub(super) fn bench(
    request: &Request<'_>,
    result: &Identification,
    minimum: &Minimum<'_>,
) -> Option<Bench> {
    let (candidate, covariance) = (&result.candidate, &minimum.estimate.covariance);
    let muscle = &candidate.muscle;
    let is_of_muscle = |section: Section| {
        candidate
            .section_muscle(&section)
            .is_ok_and(|m| m == *muscle)
    };
    // In any of its lengths.
    let points = result.points.iter();
    let points = points.filter(|f| {
        is_of_muscle(Section {
            length_mm: None,
            ..f.point.section
        })
    });
    let points: Vec<&PointFit> = points.collect();
    let offset = candidate.contraction_offset;
    let range = |value: &dyn Fn(&PointFit) -> f64| {
        let list = points.iter().map(|f| value(f));
        list.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
            (low.min(v), high.max(v))
        })
    };
    let pressure_mpa = range(&|f| f.point.at.pressure_mpa);
    let contraction = range(&|f| f.point.at.contraction + offset);
    if !points.iter().any(|f| is_of_muscle(f.point.section)) {
        return None;
    }
    // The first row in time order may state none: the way of the others is known.
    let stated = request.history || points.iter().all(|f| f.point.at.branch.is_some());
    let seen = |b: &Direction| stated && points.iter().any(|f| f.point.at.branch == Some(*b));
    let branches: Vec<Direction> = Direction::ALL.into_iter().filter(seen).collect();
    let t = t95(result.freedom);
    let squares: f64 = result
        .points
        .iter()
        .map(|f| f.residual_n * f.residual_n)
        .sum();
    let scatter =
        largest_of_95(&points).or_else(|| largest_of_95(&result.points.iter().collect::<Vec<_>>()));
    // Constants that were fitted to the points make the residuals smaller.
    let fitted = (result.points.len() as f64 / result.freedom as f64).sqrt();
    let scatter_n = scatter.map_or_else(
        || t * (squares / result.freedom as f64).sqrt(),
        |n| n * fitted,
    );
    let half_width_n = |pressure_mpa: f64, e: f64| -> Option<f64> {
        let (contraction, branch) = (e - offset, branches.last().copied());
        let at = MeasuredPoint {
            pressure_mpa,
            contraction,
            force_n: 0.0,
            branch,
        };
        let point = [DataPoint::new(at)];
        let problem = Problem::new(request, (&point, None), minimum.x);
        let columns = slopes(&problem, minimum.unknowns, minimum.x)?;
        let g: Vec<f64> = columns
            .iter()
            .map(|c| c.first().copied().unwrap_or(0.0))
            .collect();
        let row = |row: &Vec<f64>| row.iter().zip(&g).map(|(c, g)| c * g).sum::<f64>();
        let variance: f64 = covariance.iter().zip(&g).map(|(c, g)| g * row(c)).sum();
        Some(t * variance.max(0.0).sqrt()).filter(|half| plausible(*half))
    };
    // A muscle that would have to push may have no equilibrium; its ± is not needed.
    let (long, w) = (ThickWall::new(muscle), &mut Workspace::new());
    let grid: Vec<Vec<Option<f64>>> = places(pressure_mpa, GRID.0)
        .map(|p| {
            let mut one = |e: f64| {
                long.force_n(w, p, e)
                    .ok()
                    .filter(|f| *f > 0.0)
                    .and_then(|_| half_width_n(p, e))
            };
            places(contraction, GRID.1).map(&mut one).collect()
        })
        .collect();
    let largest = grid.iter().flatten().flatten().copied().reduce(f64::max)?;
    let mut lengths_mm = vec![muscle.tube().length_mm];
    for length_mm in result
        .points
        .iter()
        .filter_map(|f| f.point.section.length_mm)
    {
        if !lengths_mm.contains(&length_mm) {
            lengths_mm.push(length_mm);
        }
    }
    let half_widths = |row: &Vec<Option<f64>>| {
        row.iter()
            .map(|half| digits(half.unwrap_or(largest)))
            .collect()
    };
    let bench = Bench {
        laboratory: None,
        model: (request.build)(muscle).ok()?.info().name.to_string(),
        lengths_mm,
        points: points.len(),
        branches,
        pressure_mpa,
        contraction,
        scatter_n: digits(scatter_n),
        fit_n: grid.iter().map(half_widths).collect(),
        parameters: request
            .free
            .iter()
            .map(|p| p.target.name(request.muscle))
            .collect(),
        covariance: written(covariance),
        of: String::new(),
    };
    Some(bench.sealed(muscle))
}

/// Points from which on their distribution is known.
const MANY: usize = 20;

/// The residual in N that 95 % of a further one do not exceed; `None` of few points.
fn largest_of_95(points: &[&PointFit]) -> Option<f64> {
    let mut sizes: Vec<f64> = points.iter().map(|f| f.residual_n.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let place = 0.95 * (sizes.len() + 1) as f64 - 1.0;
    let (left, share) = (place.floor() as usize, place.fract());
    let low = sizes.get(left).filter(|_| sizes.len() >= MANY)?;
    let high = sizes.get(left + 1).unwrap_or(low);
    Some((1.0 - share) * low + share * high)
}

/// Equal steps from end to end; one place where both are the same.
fn places((low, high): (f64, f64), count: usize) -> impl Iterator<Item = f64> {
    let count = if high > low { count } else { 1 };
    (0..count).map(move |i| {
        if i == 0 {
            low
        } else {
            low + (high - low) * i as f64 / (count - 1) as f64
        }
    })
}

/// A covariance as a muscle file holds it: without the constants whose variance is no number of
/// such a file.
fn written(covariance: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let kept = |i: usize| plausible(covariance[i][i]);
    let entry = |i: usize, k: usize, v: f64| {
        if kept(i) && kept(k) && plausible(v) {
            v
        } else {
            0.0
        }
    };
    let row = |(i, row): (usize, &Vec<f64>)| {
        row.iter()
            .enumerate()
            .map(|(k, v)| entry(i, k, *v))
            .collect()
    };
    covariance.iter().enumerate().map(row).collect()
}

/// Four digits are enough for a ±.
fn digits(v: f64) -> f64 {
    format!("{v:.3e}").parse().unwrap_or(v)
}
