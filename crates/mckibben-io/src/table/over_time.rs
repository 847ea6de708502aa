//! Tables of times and values.

use super::vocabulary::OVER_TIME;
use super::{Columns, Table, TableError};

/// What a table holds over time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OverTime {
    /// Gauge pressures in MPa.
    Pressure,
    /// Openings of a valve, from −1 (wide open to the atmosphere) to 1 (to the supply).
    Opening,
    /// Volumes in mm³.
    Volume,
    /// Contraction ratios of a muscle.
    Contraction,
    /// Angles of a joint in degrees.
    Angle,
}

/// Reads times in s and values from a table in any common form.
///
/// ```
/// use mckibben_io::table::{OverTime, read_over_time};
/// let points = read_over_time("t [ms];p [bar]\n0;0\n100;3\n", OverTime::Pressure)?;
/// assert_eq!(points.len(), 2);
/// assert!((points[1].0 - 0.1).abs() < 1e-15 && (points[1].1 - 0.3).abs() < 1e-15);
/// # Ok::<(), mckibben_io::table::TableError>(())
/// ```
pub fn read_over_time(text: &str, what: OverTime) -> Result<Vec<(f64, f64)>, TableError> {
    let table = Table::read(text, &OVER_TIME[what as usize], &Columns::default())?;
    let times = table.numbers(table.needed(0)?)?;
    let values = table.numbers(table.needed(1)?)?;
    Ok(times.into_iter().zip(values).collect())
}
