//! Answers as labelled rows: the terminal and the report print these.

mod point;
mod show;

pub use point::point_rows;
pub use show::{Sheet, build_rows, characteristic_rows, muscle_sheets};

/// A label and a value with its unit.
pub type Row = (&'static str, String);
