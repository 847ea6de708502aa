//! Rows in time order: the friction has the history of the rows.
//!
//!   F = F₀(P, ε; θ) − F_c(P, ε; θ) Σ sᵢ zᵢ
//!
//! F₀: the mean of both branches, F_c: half the width of the loop, zᵢ: states of the [`Presliding`](mckibben::muscle::Presliding), moved from row to row by the change of the
//! contraction times L0. A table begins on the branch that its first row states; without one at z = 0. Between two rows the muscle moves one way.

use super::{IdentifyError, Result};
use crate::measured::{DataPoint, Quantity};
use mckibben::muscle::{Direction, Muscle};

/// Whether a row continues the history of another.
fn continues(row: &DataPoint, before: &DataPoint) -> bool {
    row.set == before.set && row.section == before.section
}

/// The rows with the direction in which the muscle came to them, for spreads and for the ± of the bench.
pub(super) fn directed(points: &[DataPoint]) -> Result<Vec<DataPoint>> {
    let mut out: Vec<DataPoint> = vec![];
    for row in points {
        if row.measured != Quantity::Force {
            let line = row.line;
            return Err(IdentifyError::Refused(format!(
                "line {line}: rows in time order state a measured force, at a set pressure and length"
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

/// Σ sᵢ zᵢ at `points`, some of the rows in their order; `None` of a muscle without friction.
pub(super) fn shares(rows: &[DataPoint], points: &[DataPoint], muscle: &Muscle) -> Option<Vec<f64>> {
    let presliding = muscle.friction()?.presliding();
    let (mut z, mut last): (Vec<f64>, Option<&DataPoint>) = (vec![], None);
    let (mut remaining, mut out) = (points.iter().peekable(), vec![]);
    for row in rows {
        match last.filter(|before| continues(row, before)) {
            Some(before) => {
                let way_mm = row.section.length_mm.unwrap_or(muscle.length_mm());
                presliding.travel(&mut z, (row.at.contraction - before.at.contraction) * way_mm);
            }
            // While it shortens its friction is positive, and the pull smaller.
            None => z = vec![-row.at.direction().sign(); presliding.0.len()],
        }
        last = Some(row);
        if remaining.next_if(|point| *point == row).is_some() {
            out.push(presliding.share(&z));
        }
    }
    Some(out)
}
