//! Measured points, and the mean of both branches.

use super::read::read_data;
use crate::muscle::Direction;
use serde::{Deserialize, Serialize};
use std::io::Read;
use thiserror::Error;

/// One measured point of a muscle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MeasuredPoint {
    /// Gauge pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction ratio.
    pub contraction: f64,
    /// Pull in N.
    pub force_n: f64,
    /// The branch of the hysteresis loop; the mean where none is stated.
    #[serde(default, skip_serializing_if = "Direction::is_mean")]
    pub branch: Direction,
}

/// Why measured points cannot be read. Lines are counted from 1, the header being line 1.
#[derive(Debug, Error)]
pub enum MeasuredError {
    /// No column of that meaning.
    #[error(
        "no column {wanted} (the columns are: {found}); measured points need pressure_mpa (or pressure_kpa, pressure_bar), contraction and force_n, and may have branch"
    )]
    MissingColumn {
        /// What is needed.
        wanted: &'static str,
        /// What is there.
        found: String,
    },
    /// A field that is not a finite number.
    #[error("line {line}, column {column}: \"{text}\" is not a finite number")]
    NotANumber {
        /// Line in the file.
        line: u64,
        /// Column name.
        column: String,
        /// The field as written.
        text: String,
    },
    /// A number no muscle has.
    #[error("line {line}, column {column}: {value} {expected}")]
    Impossible {
        /// Line in the file.
        line: u64,
        /// Column name.
        column: String,
        /// The value.
        value: f64,
        /// What is expected.
        expected: &'static str,
    },
    /// A word in the branch column that is not known.
    #[error("line {line}: branch \"{text}\" is neither \"contraction\" nor \"elongation\"")]
    Branch {
        /// Line in the file.
        line: u64,
        /// The word.
        text: String,
    },
    /// A word in the column `measured` that is not known.
    #[error("line {line}: measured \"{text}\" is neither \"force\", \"contraction\" nor \"pressure\"")]
    Quantity {
        /// Line in the file.
        line: u64,
        /// The word.
        text: String,
    },
    /// No points at all.
    #[error("no points: the file ends after its header")]
    Empty,
    /// The table itself is broken (a line with missing fields, bytes that are not UTF-8, an unreadable file).
    #[error("{0}")]
    Csv(#[from] csv::Error),
}

/// Reads measured points from CSV with a header line; see [`read_data`] for its columns.
///
/// # Errors
/// [`MeasuredError`] names line and column.
pub fn read_measured(input: impl Read) -> Result<Vec<MeasuredPoint>, MeasuredError> {
    Ok(read_data(input)?.into_iter().map(|p| p.at).collect())
}

/// The mean of the two hysteresis branches: at every contraction of the lower branch, half the sum with the upper branch
/// interpolated there, pressure by pressure. Points without a branch, and pressures with one branch only, stay as they are.
pub fn mean_of_branches(points: &[MeasuredPoint]) -> Vec<MeasuredPoint> {
    let mut pressures: Vec<f64> = points.iter().map(|p| p.pressure_mpa).collect();
    pressures.sort_by(f64::total_cmp);
    pressures.dedup();
    let mut out = Vec::new();
    for pressure in pressures {
        let of = |branch| {
            let mut list: Vec<MeasuredPoint> =
                points.iter().filter(|p| p.pressure_mpa == pressure && p.branch == branch).copied().collect();
            list.sort_by(|a, b| a.contraction.total_cmp(&b.contraction));
            list
        };
        let (lower, upper) = (of(Direction::Contraction), of(Direction::Elongation));
        out.extend(of(Direction::Mean));
        if lower.is_empty() || upper.is_empty() {
            out.extend(lower.into_iter().chain(upper));
            continue;
        }
        out.extend(lower.iter().filter_map(|p| {
            let above = interpolate(&upper, p.contraction)?;
            Some(MeasuredPoint { force_n: 0.5 * (p.force_n + above), branch: Direction::Mean, ..*p })
        }));
    }
    out
}

/// Linear interpolation of the force at a contraction; `None` outside of the measured contractions.
fn interpolate(sorted: &[MeasuredPoint], contraction: f64) -> Option<f64> {
    let i = sorted.partition_point(|p| p.contraction < contraction);
    let right = sorted.get(i)?;
    if right.contraction == contraction {
        return Some(right.force_n);
    }
    let left = sorted.get(i.checked_sub(1)?)?;
    let t = (contraction - left.contraction) / (right.contraction - left.contraction);
    Some(left.force_n + t * (right.force_n - left.force_n))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<MeasuredPoint>, MeasuredError> {
        read_measured(text.as_bytes())
    }

    #[test]
    fn units_of_the_pressure_column_are_understood() {
        for (column, value) in [("pressure_mpa", "0.25"), ("pressure_kpa", "250"), ("pressure_bar", "2.5")] {
            let points = read(&format!("{column},contraction,force_n\n{value},0.1,300\n")).unwrap();
            assert_eq!(
                points,
                [MeasuredPoint {
                    pressure_mpa: 0.25,
                    contraction: 0.1,
                    force_n: 300.0,
                    branch: Direction::Mean
                }]
            );
        }
    }

    #[test]
    fn errors_name_line_and_column() {
        let cases = [
            ("contraction,force_n\n0,1\n", "no column pressure_mpa"),
            ("pressure_mpa,contraction,force_n\n0.1,NaN,3\n", "line 2, column contraction: \"NaN\""),
            ("pressure_mpa,contraction,force_n\n0.1,0,3\n0.1,,3\n", "line 3, column contraction: \"\""),
            ("pressure_mpa,contraction,force_n\n0.1,15,3\n", "write 0.15 for 15 %"),
            ("pressure_mpa,contraction,force_n\n-0.1,0,3\n", "below zero"),
            ("pressure_mpa,contraction,force_n\n0.1,0\n", "CSV error"),
            ("pressure_mpa,contraction,force_n\n", "no points"),
            ("pressure_mpa,contraction,force_n,branch\n0.1,0,3,up\n", "neither \"contraction\""),
        ];
        for (text, fragment) in cases {
            let message = read(text).unwrap_err().to_string();
            assert!(message.contains(fragment), "{text}: {message}");
        }
    }

    #[test]
    fn the_mean_of_two_parallel_branches_lies_between_them() {
        let text = "pressure_mpa,contraction,force_n,branch\n0.1,0,10,contraction\n0.1,0.2,6,contraction\n\
                    0.1,0.3,2,contraction\n0.1,0,12,elongation\n0.1,0.1,10,elongation\n0.1,0.25,7,elongation\n";
        let mean = mean_of_branches(&read(text).unwrap());
        assert_eq!(mean.len(), 2);
        assert_eq!(mean[0].force_n, 11.0);
        assert!((mean[1].force_n - 7.0).abs() < 1e-12);
    }
}
