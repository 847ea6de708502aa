//! Loads from people's tables.

use super::{LoadTable, LoadTableError};
use crate::table::{Columns, LOADS, Meaning, Table, TableError, read_text};
use std::io::Read;
use thiserror::Error;

/// Why a table is no load.
#[derive(Debug, Error)]
pub enum ReadLoadError {
    /// It cannot be read.
    #[error(transparent)]
    Table(#[from] TableError),
    /// Its points are no line.
    #[error(transparent)]
    Points(#[from] LoadTableError),
}

/// Groups of [`LOADS`].
const SHORTENING: usize = 0;
const FORCE: usize = 1;

/// Reads a load from a table in any common form ([`table`](crate::table)): shortenings in mm (or contraction ratios of a muscle of
/// length L0) and forces.
///
/// # Errors
/// [`ReadLoadError`].
pub fn read_load(input: impl Read, rest_length_mm: f64) -> Result<LoadTable, ReadLoadError> {
    let table = Table::read(&read_text(input)?, &LOADS, &Columns::default())?;
    let column = table.needed(SHORTENING)?;
    let length = if column.meaning == Meaning::Contraction { rest_length_mm } else { 1.0 };
    let shortenings = table.numbers(column)?;
    let forces = table.numbers(table.needed(FORCE)?)?;
    Ok(LoadTable::new(shortenings.into_iter().map(|x| x * length).zip(forces).collect())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_people_are_loads() {
        let table = read_load("Weg [mm];Kraft [N]\n0;10,5\n20;30\n".as_bytes(), 285.0).unwrap();
        assert_eq!(table.points(), [(0.0, 10.5), (20.0, 30.0)]);
        let table = read_load("contraction,force_n\n0,10\n0.1,30\n".as_bytes(), 200.0).unwrap();
        assert_eq!(table.points(), [(0.0, 10.0), (20.0, 30.0)]);
        assert!(read_load("a,b\n1,2\n".as_bytes(), 200.0).is_err());
        assert!(read_load("weg_mm,force_n\n1,2\n".as_bytes(), 200.0).is_err());
    }
}
