//! Tables of times and values.

use super::{
    columns::Columns, error::TableError, find::Table, kinds::OVER_TIME, vocabulary::Meaning,
};

/// Times in s and values.
pub type Series = Vec<(f64, f64)>;
/// Several quantities over time.
pub type Log = Vec<(OverTime, Series)>;

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
    /// Forces in N.
    Force,
    /// Torques in N m.
    Torque,
}

/// Reads times in s and values from a table in any common form; shortenings in mm are divided by
/// the muscle's length L0.
///
/// ```
/// use mckibben_io::table::{OverTime, read_over_time};
/// let points = read_over_time("t [ms];p [bar]\n0;0\n100;3\n", OverTime::Pressure, 285.0)?;
/// assert_eq!(points.len(), 2);
/// assert!((points[1].0 - 0.1).abs() < 1e-15 && (points[1].1 - 0.3).abs() < 1e-15);
/// # Ok::<(), mckibben_io::table::TableError>(())
/// ```
pub fn read_over_time(
    text: &str,
    what: OverTime,
    rest_length_mm: f64,
) -> Result<Series, TableError> {
    let table = Table::read(text, &OVER_TIME[what as usize], &Columns::default())?;
    let column = table.needed(1)?;
    let length = if column.meaning == Meaning::Shortening {
        rest_length_mm
    } else {
        1.0
    };
    let times = table.numbers(table.needed(0)?)?;
    let values = table.numbers(column)?;
    Ok(times
        .into_iter()
        .zip(values.into_iter().map(|value| value / length))
        .collect())
}

/// Reads those of some quantities over time that a table has.
pub fn read_log(text: &str, wanted: &[OverTime], rest_length_mm: f64) -> Result<Log, TableError> {
    let has =
        |what: OverTime| Table::read(text, &OVER_TIME[what as usize], &Columns::default()).is_ok();
    let found: Vec<OverTime> = wanted.iter().copied().filter(|what| has(*what)).collect();
    let found = if found.is_empty() { wanted } else { &found };
    found
        .iter()
        .map(|what| Ok((*what, read_over_time(text, *what, rest_length_mm)?)))
        .collect()
}
