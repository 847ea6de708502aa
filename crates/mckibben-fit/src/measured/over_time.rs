//! Logs of a test over time: a pressure that another instrument recorded, and the branches of a motion.

use mckibben::muscle::Direction;

/// Pressures over time that another instrument recorded.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PressureLog {
    /// Its file, to say so.
    pub name: String,
    /// Times in s and gauge pressures in MPa.
    pub points: Vec<(f64, f64)>,
    /// What its times lack to those of the other table; found where none is given.
    pub offset_s: Option<f64>,
}

/// Shifts that are tried, and rows that are looked at.
const SHIFTS: i32 = 500;
const ROWS: usize = 500;

/// The pull follows the pressure if their correlation is at least this; clocks that differ must be better by the second.
const FOLLOWS: f64 = 0.9;
const BETTER: f64 = 0.005;

impl PressureLog {
    /// The pressures at the times of pulls, none outside of the log, and how the two clocks were brought together.
    pub(super) fn at(&self, times: &[f64], pulls: &[f64]) -> (Vec<Option<f64>>, String) {
        let mut points = self.points.clone();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (offset, how) = match self.offset_s {
            Some(offset) => (offset, "given"),
            None => match offset(&points, times, pulls) {
                Some(offset) => (offset, "found: the pull follows the pressure"),
                None => (0.0, "both clocks are taken as one"),
            },
        };
        let joined = times.iter().map(|t| interpolate(&points, t - offset)).collect();
        (joined, format!("from {} at its times + {:.4} s, {how}", self.name, offset))
    }
}

/// The value of a table at a time, none beyond its ends.
fn interpolate(sorted: &[(f64, f64)], time: f64) -> Option<f64> {
    let i = sorted.partition_point(|p| p.0 < time);
    let right = sorted.get(i)?;
    let left = if i == 0 { sorted.first().filter(|p| p.0 == time)? } else { &sorted[i - 1] };
    let width = right.0 - left.0;
    let share = if width > 0.0 { (time - left.0) / width } else { 0.0 };
    Some(left.1 + share * (right.1 - left.1))
}

/// The shift of the log at which the pull follows the pressure best, of those at which half of the shorter one overlaps the other.
fn offset(log: &[(f64, f64)], times: &[f64], pulls: &[f64]) -> Option<f64> {
    let rows: Vec<(f64, f64)> =
        times.iter().copied().zip(pulls.iter().copied()).step_by(times.len().div_ceil(ROWS).max(1)).collect();
    let (begin, end) = (log.first()?.0, log.last()?.0);
    let low = times.iter().copied().fold(f64::INFINITY, f64::min);
    let high = times.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let half = 0.5 * (end - begin).min(high - low);
    let correlation = |shift: f64| correlation(log, &rows, shift);
    let best = |middle: f64, width: f64| {
        let shifts = (-SHIFTS..=SHIFTS).map(|i| middle + width * f64::from(i) / f64::from(SHIFTS));
        shifts.max_by(|a, b| correlation(*a).total_cmp(&correlation(*b)))
    };
    let (first, last) = (low + half - end, high - half - begin);
    let width = 0.5 * (last - first);
    let coarse = best(0.5 * (first + last), width)?;
    let fine = best(coarse, 2.0 * width / f64::from(SHIFTS))?;
    let found = correlation(fine);
    (found >= FOLLOWS && found > correlation(0.0) + BETTER).then_some(fine)
}

/// Of pressure and pull at a shift; below −1 where fewer than three rows overlap.
fn correlation(log: &[(f64, f64)], rows: &[(f64, f64)], shift: f64) -> f64 {
    let pairs = rows.iter().filter_map(|(t, pull)| Some((interpolate(log, t - shift)?, *pull)));
    let pairs: Vec<(f64, f64)> = pairs.collect();
    let n = pairs.len() as f64;
    if pairs.len() < 3 {
        return -2.0;
    }
    let mean = pairs.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
    let sums = pairs.iter().fold([0.0; 3], |[xx, yy, xy], p| {
        let (x, y) = (p.0 - mean.0, p.1 - mean.1);
        [xx + x * x, yy + y * y, xy + x * y]
    });
    let size = (sums[0] * sums[1]).sqrt();
    if size > 0.0 { sums[2] / size } else { 0.0 }
}

/// A reversal moves by this share of the range: less is noise.
const REVERSAL: f64 = 0.02;

/// The branch of each row in time order, by the sign of the velocity of the contraction; where the length is held, of the pressure. None where nothing moves.
pub(super) fn branches(contractions: &[f64], pressures: &[f64]) -> Option<Vec<Direction>> {
    let range = |values: &[f64]| {
        let (low, high) =
            values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
        high - low
    };
    let held = range(contractions) < 1e-3;
    let values = if held { pressures } else { contractions };
    let step = REVERSAL * range(values);
    let mut out = vec![];
    // The extreme so far, and the first row behind the last reversal.
    let (mut extreme, mut rising) = (*values.first()?, None);
    let mut turned = 0;
    for (row, value) in values.iter().enumerate() {
        let ahead = |rising: bool| if rising { value - extreme } else { extreme - value };
        match rising {
            None if (value - extreme).abs() > step => {
                (rising, extreme, turned) = (Some(*value > extreme), *value, row)
            }
            Some(up) if ahead(up) >= 0.0 => (extreme, turned) = (*value, row),
            Some(up) if ahead(up) < -step => {
                out.resize(turned + 1, direction(up));
                (rising, extreme, turned) = (Some(!up), *value, row);
            }
            _ => {}
        }
    }
    out.resize(values.len(), direction(rising?));
    Some(out)
}

fn direction(rising: bool) -> Direction {
    if rising { Direction::Contraction } else { Direction::Elongation }
}
