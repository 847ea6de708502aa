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

use super::{Identification, PointFit, Request, problem::Problem};
use crate::{
    least_squares::{Estimate, Unknown, slopes, t95},
    measured::{DataPoint, MeasuredPoint, Section},
};
use mckibben_core::{
    extremes::ends,
    model::{ForceModel, ThickWall, Workspace},
    muscle::{Bench, Direction},
    units::plausible,
};

/// Pressures and contractions of the grid.
const GRID: (usize, usize) = (3, 5);

/// A minimum of the residuals, with the unknowns that are at their bounds set to these.
pub struct Minimum<'a> {
    pub unknowns: &'a [Unknown],
    pub estimate: &'a Estimate,
    pub x: &'a [f64],
}

/// The bench of the muscle itself; `None` where no point is of it, or the half-width of the fit is
/// not known.
pub fn bench(
    request: &Request<'_>,
    result: &Identification,
    minimum: &Minimum<'_>,
) -> Option<Bench> {
    let candidate = &result.candidate;
    let muscle = &candidate.muscle;
    let is_of_muscle = |section: Section| {
        let of_row = candidate.section_muscle(&section);
        of_row.is_ok_and(|of_row| of_row == *muscle)
    };
    // In any of its lengths.
    let in_any_length = |f: &&PointFit| {
        is_of_muscle(Section {
            length_mm: None,
            ..f.point.section
        })
    };
    let points: Vec<&PointFit> = result.points.iter().filter(in_any_length).collect();
    if !points.iter().any(|f| is_of_muscle(f.point.section)) {
        return None;
    }
    let offset = candidate.contraction_offset;
    let pressure_mpa = ends(points.iter().map(|f| f.point.at.pressure_mpa));
    let contraction = ends(points.iter().map(|f| f.point.at.contraction + offset));
    // The first row in time order may state none: the way of the others is known.
    let stated = request.history || points.iter().all(|f| f.point.at.branch.is_some());
    let seen = |b: &Direction| stated && points.iter().any(|f| f.point.at.branch == Some(*b));
    let branches: Vec<Direction> = Direction::ALL.into_iter().filter(seen).collect();
    // A muscle that would have to push may have no equilibrium; its ± is not needed.
    let long = ThickWall::new(muscle);
    let w = &mut Workspace::new();
    let mut half_width_n = |p: f64, e: f64| {
        long.force_n(w, p, e).ok().filter(|f| *f > 0.0)?;
        let at = MeasuredPoint {
            pressure_mpa: p,
            contraction: e - offset,
            force_n: 0.0,
            branch: branches.last().copied(),
        };
        let variance = minimum.variance(request, at)?;
        Some(t95(result.freedom) * variance.max(0.0).sqrt()).filter(|half| plausible(*half))
    };
    let mut row = |p| -> Vec<Option<f64>> {
        places(contraction, GRID.1)
            .map(|e| half_width_n(p, e))
            .collect()
    };
    let grid: Vec<Vec<Option<f64>>> = places(pressure_mpa, GRID.0).map(&mut row).collect();
    let largest = grid.iter().flatten().flatten().copied().reduce(f64::max)?;
    let half_widths = |row: &Vec<Option<f64>>| {
        row.iter()
            .map(|half| digits(half.unwrap_or(largest)))
            .collect()
    };
    let mut lengths_mm = vec![muscle.tube().length_mm];
    for point in &result.points {
        let stated = point.point.section.length_mm;
        lengths_mm.extend(stated.filter(|length| !lengths_mm.contains(length)));
    }
    let names = request.free.iter().map(|p| p.target.name(request.muscle));
    let bench = Bench {
        laboratory: None,
        model: (request.build)(muscle).ok()?.info().name.to_string(),
        lengths_mm,
        points: points.len(),
        pressure_mpa,
        contraction,
        scatter_n: digits(scatter_n(result, &points)),
        fit_n: grid.iter().map(half_widths).collect(),
        parameters: names.collect(),
        covariance: written(&minimum.estimate.covariance),
        of: String::new(),
        branches,
    };
    Some(bench.sealed(muscle))
}

impl Minimum<'_> {
    /// g C gᵀ at a point of the muscle, N².
    fn variance(&self, request: &Request<'_>, at: MeasuredPoint) -> Option<f64> {
        let point = [DataPoint::new(at)];
        let problem = Problem::new(request, (&point, None), self.x);
        let g = slopes(&problem, self.unknowns, self.x)?.concat();
        let dot = |row: &Vec<f64>| row.iter().zip(&g).map(|(c, g)| c * g).sum::<f64>();
        Some(
            self.estimate
                .covariance
                .iter()
                .zip(&g)
                .map(|(row, g)| g * dot(row))
                .sum(),
        )
    }
}

/// The residual in N that a further one does not exceed in 95 of 100 cases: of the muscle's points
/// where they are many, else of all.
fn scatter_n(result: &Identification, points: &[&PointFit]) -> f64 {
    let all = &result.points;
    let freedom = result.freedom as f64;
    let of_all = || largest_of_95(&all.iter().collect::<Vec<_>>());
    if let Some(largest) = largest_of_95(points).or_else(of_all) {
        largest * (all.len() as f64 / freedom).sqrt()
    } else {
        let squares: f64 = all.iter().map(|f| f.residual_n * f.residual_n).sum();
        t95(result.freedom) * (squares / freedom).sqrt()
    }
}

/// Points from which on their distribution is known.
const MANY: usize = 20;

/// The residual in N that 95 % of a further one do not exceed; `None` of few points.
fn largest_of_95(points: &[&PointFit]) -> Option<f64> {
    let mut sizes: Vec<f64> = points.iter().map(|f| f.residual_n.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let place = 0.95 * (sizes.len() + 1) as f64 - 1.0;
    let left = place.floor() as usize;
    let share = place.fract();
    let low = sizes.get(left).filter(|_| sizes.len() >= MANY)?;
    let high = sizes.get(left + 1).unwrap_or(low);
    Some((1.0 - share) * low + share * high)
}

/// Equal steps from end to end; one place where both are the same.
fn places((low, high): (f64, f64), count: usize) -> impl Iterator<Item = f64> {
    let count = if high > low { count } else { 1 };
    let steps = (count - 1).max(1) as f64;
    (0..count).map(move |i| low + (high - low) * i as f64 / steps)
}

/// A covariance as a muscle file holds it: without the constants whose variance is no number of
/// such a file.
fn written(covariance: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let kept = |i: usize| plausible(covariance[i][i]);
    let all = 0..covariance.len();
    let entry = |i: usize, k: usize| {
        Some(covariance[i][k])
            .filter(|v| kept(i) && kept(k) && plausible(*v))
            .unwrap_or(0.0)
    };
    let row = |i| all.clone().map(|k| entry(i, k)).collect();
    all.clone().map(row).collect()
}

/// Four digits are enough for a ±.
fn digits(v: f64) -> f64 {
    format!("{v:.3e}").parse().unwrap_or(v)
}
