//! Logs of a test over time: a pressure that another instrument recorded, and the branches of a
//! motion.

use super::data::interpolate;
use mckibben_core::{by_number::*, extremes::ends, muscle::Direction};

/// Pressures over time that another instrument recorded.
#[derive(Debug, Clone)]
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

/// The pull follows the pressure if their correlation is at least this; clocks that differ must be
/// better by the second. A pressure that varies by less than the last tells nothing.
const FOLLOWS: f64 = 0.9;
const BETTER: f64 = 0.005;
const VARIES: f64 = 0.05;

impl PressureLog {
    /// The pressures at the times of pulls, none outside of the log, and how the two clocks were
    /// brought together.
    pub(super) fn pressures_at(&self, times: &[f64], pulls: &[f64]) -> (Vec<Option<f64>>, String) {
        let mut points = self.points.clone();
        points.sort_by_number(|a| a.0);
        let (offset, how) = match self.offset_s {
            Some(offset) => (offset, "given"),
            None => match offset(&points, times, pulls) {
                Some(offset) => (offset, "found: the pull follows the pressure"),
                None => (0.0, "both clocks are taken as one"),
            },
        };
        let joined = times
            .iter()
            .map(|t| interpolate(&points, t - offset))
            .collect();
        (
            joined,
            format!("from {} at its times + {:.4} s, {how}", self.name, offset),
        )
    }
}

/// The shift of the log at which the pull follows the pressure best, of those at which half of the
/// shorter one overlaps the other.
fn offset(log: &[(f64, f64)], times: &[f64], pulls: &[f64]) -> Option<f64> {
    let rows: Vec<(f64, f64)> = times
        .iter()
        .copied()
        .zip(pulls.iter().copied())
        .step_by(times.len().div_ceil(ROWS).max(1))
        .collect();
    let begin = log.first()?.0;
    let end = log.last()?.0;
    let (low, high) = ends(times.iter().copied());
    let (least, most) = ends(log.iter().map(|p| p.1));
    let half = 0.5 * (end - begin).min(high - low);
    let follows = |shift: f64| correlation(log, &rows, shift);
    let best = |middle: f64, width: f64| {
        (-SHIFTS..=SHIFTS)
            .map(|i| middle + width * f64::from(i) / f64::from(SHIFTS))
            .map(|shift| (shift, follows(shift)))
            .filter(|(_, r)| r.is_finite())
            .max_by_number(|a| a.1)
    };
    let first = low + half - end;
    let last = high - half - begin;
    let width = 0.5 * (last - first);
    let (coarse, _) = best(0.5 * (first + last), width)?;
    let (fine, found) = best(coarse, 2.0 * width / f64::from(SHIFTS))?;
    let as_one = follows(0.0);
    let varies = most - least > VARIES * most;
    (varies && found >= FOLLOWS && (as_one.is_nan() || found > as_one + BETTER)).then_some(fine)
}

/// Of pressure and pull at a shift; not a number where too few rows overlap.
fn correlation(log: &[(f64, f64)], rows: &[(f64, f64)], shift: f64) -> f64 {
    let [n, x, y, xx, yy, xy] = rows
        .iter()
        .filter_map(|(t, pull)| Some((interpolate(log, t - shift)?, *pull)))
        .fold([0.0; 6], |[n, x, y, xx, yy, xy], (p, f)| {
            [n + 1.0, x + p, y + f, xx + p * p, yy + f * f, xy + p * f]
        });
    (n * xy - x * y) / ((n * xx - x * x) * (n * yy - y * y)).sqrt()
}

/// A reversal moves by this share of the range: less is noise. Over less contraction the length is
/// held.
const REVERSAL: f64 = 0.02;
const HELD: f64 = 1e-3;

/// The branch of each row in time order, by the sign of the velocity of the contraction; where the
/// length is held, of the pressure. None where nothing moves.
pub fn branches(contractions: &[f64], pressures: &[f64]) -> Option<Vec<Direction>> {
    let (low, high) = ends(contractions.iter().copied());
    let values = if high - low < HELD {
        pressures
    } else {
        contractions
    };
    let mut out = vec![];
    for (end, rises) in runs(values, REVERSAL) {
        out.resize(end, direction(rises?));
    }
    (!out.is_empty()).then_some(out)
}

/// The runs of a series between its turns: their ends (exclusive), and whether they rise, which is
/// not known where it does not turn at all. A way back of less than a share of the range is no turn.
pub fn runs(values: &[f64], share: f64) -> Vec<(usize, Option<bool>)> {
    let (low, high) = ends(values.iter().copied());
    let step = share * (high - low);
    // Place and value of the extreme since the last turn.
    let mut place = 0;
    let mut extreme = values.first().copied().unwrap_or_default();
    let mut rises = None;
    let mut out = vec![];
    for (i, &value) in values.iter().enumerate() {
        let moved = value - extreme;
        let (turns, further) = match rises {
            None => (moved.abs() > step, false),
            Some(true) => (moved < -step, moved >= 0.0),
            Some(false) => (moved > step, moved <= 0.0),
        };
        if turns {
            out.extend(rises.map(|_| (place + 1, rises)));
            rises = Some(moved > 0.0);
        }
        if turns || further {
            (place, extreme) = (i, value);
        }
    }
    out.extend((!values.is_empty()).then_some((values.len(), rises)));
    out
}

fn direction(rising: bool) -> Direction {
    if rising {
        Direction::Contraction
    } else {
        Direction::Elongation
    }
}
