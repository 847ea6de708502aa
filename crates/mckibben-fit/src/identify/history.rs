//! Rows in time order: the friction has the history of the rows.
//!
//!   F = F₀(P, ε; θ) − F_c(P, ε; θ) z
//!
//! F₀: the mean of both branches, F_c: half the width of the loop, z: the share of the
//! [`Presliding`](mckibben_core::muscle::Presliding) at the contraction times L0, with the history of
//! the rows before. A table begins on the branch that its first row states; without one at rest, z
//! = 0. Between two rows the muscle moves one way.

use super::{IdentifyError, Result};
use crate::measured::{DataPoint, Quantity};
use mckibben_core::muscle::{Direction, Muscle, Presliding};

/// Whether a row continues the history of another.
fn continues(row: &DataPoint, before: &DataPoint) -> bool {
    row.set == before.set && row.section == before.section
}

/// The rows with the direction in which the muscle came to them, for spreads and for the ± of the
/// bench.
pub fn directed(points: &[DataPoint]) -> Result<Vec<DataPoint>> {
    let mut out: Vec<DataPoint> = vec![];
    for row in points {
        if row.measured != Quantity::Force {
            let line = row.line;
            return Err(IdentifyError::Refused(format!(
                "line {line}: rows in time order state a measured force, at a set pressure and \
                 length"
            )));
        }
        let mut row = *row;
        if let Some(before) = out.last().filter(|before| continues(&row, before)) {
            let way = row.at.contraction - before.at.contraction;
            row.at.branch = match way {
                w if w > 0.0 => Some(Direction::Contraction),
                w if w < 0.0 => Some(Direction::Elongation),
                _ => before.at.branch,
            };
        }
        out.push(row);
    }
    Ok(out)
}

/// z at `points`, some of the rows in their order; `None` of a muscle without friction.
pub fn shares(rows: &[DataPoint], points: &[DataPoint], muscle: &Muscle) -> Option<Vec<f64>> {
    let friction = muscle.friction()?;
    let mut last: Option<(&DataPoint, Presliding)> = None;
    let mut remaining = points.iter().peekable();
    let mut out = vec![];
    for row in rows {
        let at_mm = row.at.contraction * row.section.length_mm.unwrap_or(muscle.length_mm());
        let before = last.take().filter(|(before, _)| continues(row, before));
        // While it shortens its friction is positive, and the pull smaller.
        let begin = || friction.presliding(at_mm, -row.at.direction().sign());
        let mut presliding = before.map_or_else(begin, |(_, presliding)| presliding);
        let z = presliding.travel(at_mm);
        last = Some((row, presliding));
        if remaining.next_if(|point| *point == row).is_some() {
            out.push(z);
        }
    }
    Some(out)
}
