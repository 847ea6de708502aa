//! `[identified]`: what a bench says of the muscle, written by `identify` and read again.

use super::{error::FileError, source::Source};
use crate::{
    built::learnt::cholesky,
    muscle::{Bench, Direction},
};

/// Lengths at most.
const MOST: usize = 64;
const LONGEST: usize = 200;

pub fn check(bench: &Bench, source: &Source<'_>) -> Result<(), FileError> {
    let is_name =
        |name: &str| !name.is_empty() && name.len() <= LONGEST && !name.contains(char::is_control);
    let is_range = |(low, high): (f64, f64)| low <= high;
    let name = "must be a short text on one line";
    let range = "must hold the lowest and the highest value";
    let Bench {
        contraction,
        constants,
        covariance,
        own_points,
        ..
    } = bench;
    let lowest = contraction.0;
    let distinct = (1..constants.len()).all(|i| !constants[..i].contains(&constants[i]));
    let checks = [
        (
            "laboratory",
            bench.laboratory.as_deref().is_none_or(is_name),
            name,
        ),
        ("model", is_name(&bench.model), name),
        ("of", is_name(&bench.of), name),
        (
            "points",
            (1..=1_000_000_000).contains(&bench.points),
            "must be a whole number above zero",
        ),
        (
            "branches",
            bench.branches.len() <= Direction::ALL.len(),
            "must hold three words at most",
        ),
        ("pressure", is_range(bench.pressure_mpa), range),
        ("contraction", is_range(*contraction), range),
        (
            "contraction",
            lowest > -1.0 && contraction.1 < 1.0,
            "must lie between -1 and 1",
        ),
        ("pull_factor", bench.pull_factor > 0.0, "must be above zero"),
        (
            "friction_share",
            bench.friction_share >= 0.0,
            "must not be below zero",
        ),
        ("constants", distinct, "names a constant twice"),
        (
            "own_points",
            own_points.len() <= Bench::OWN_POINTS
                && own_points
                    .iter()
                    .all(|p| p.0 >= 0.0 && p.1.abs() < 1.0 && p.2.abs() <= 1.0),
            "must hold up to 20 points of pressure, contraction, branch (-1, 0 or 1) and pull",
        ),
        (
            "covariance",
            is_covariance(covariance, constants.len()),
            "must be symmetric, with a row and a column for each of `constants`, and no \
             combination of them may have a variance below zero",
        ),
        (
            "lengths",
            bench.lengths_mm.len() <= MOST && bench.lengths_mm.iter().all(|l| *l > 0.0),
            "must hold up to 64 lengths above zero",
        ),
    ];
    checks
        .iter()
        .find(|check| !check.1)
        .map_or(Ok(()), |(key, _, must)| {
            Err(source.error(&format!("identified.{key}"), *must))
        })
}

/// Whether rows are a covariance of so many: symmetric, and positive definite to rounding.
fn is_covariance(rows: &[Vec<f64>], n: usize) -> bool {
    const ROUNDING: f64 = 1e-9;
    let symmetric = |i: usize, k: usize| {
        let (a, b): (f64, f64) = (rows[i][k], rows[k][i]);
        (a - b).abs() <= ROUNDING * (a.abs() + b.abs())
    };
    if rows.len() != n
        || rows.iter().any(|row| row.len() != n)
        || !(0..n).all(|i| (0..i).all(|k| symmetric(i, k)))
    {
        return false;
    }
    let mut rounded = rows.to_vec();
    for (i, row) in rounded.iter_mut().enumerate() {
        row[i] += ROUNDING * row[i].abs() + f64::MIN_POSITIVE;
    }
    cholesky(&rounded).is_some()
}
