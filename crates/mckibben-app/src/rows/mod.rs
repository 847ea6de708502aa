//! Answers as labelled rows: the terminal and the report print these.

mod check;
mod point;

pub use check::{characteristic_rows, limit_rows, muscle_sheets};
pub use point::point_rows;

use crate::muscle::MuscleSummary;

/// What belongs behind numbers that follow from estimates of the strands.
pub fn estimated(muscle: &MuscleSummary) -> &'static str {
    if muscle.stiffness_factor.is_some() {
        " (estimate: the strands of this sleeve are not stated)"
    } else {
        ""
    }
}

/// A label and a value with its unit.
pub type Row = (&'static str, String);
