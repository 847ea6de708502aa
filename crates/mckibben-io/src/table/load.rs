//! Loads from people's tables.

use super::{columns::Columns, error::TableError, find::Table, kinds::LOADS, vocabulary::Meaning};

/// Groups of [`LOADS`].
const SHORTENING: usize = 0;
const FORCE: usize = 1;

/// Reads a load from a table in any common form: shortenings in mm (contraction ratios are
/// multiplied by the muscle's length L0) and forces in N, in the order of the table.
pub fn read_load(text: &str, rest_length_mm: f64) -> Result<Vec<(f64, f64)>, TableError> {
    let table = Table::read(text, &LOADS, &Columns::default())?;
    let column = table.needed(SHORTENING)?;
    let length = if column.meaning == Meaning::Contraction {
        rest_length_mm
    } else {
        1.0
    };
    let shortenings = table.numbers(column)?;
    let forces = table.numbers(table.needed(FORCE)?)?;
    Ok(shortenings
        .into_iter()
        .map(|x| x * length)
        .zip(forces)
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_people_are_loads() {
        let points = read_load("Weg [mm];Kraft [N]\n0;10,5\n20;30\n", 285.0).unwrap();
        assert_eq!(points, [(0.0, 10.5), (20.0, 30.0)]);
        let points = read_load("contraction,force_n\n0,10\n0.1,30\n", 200.0).unwrap();
        assert_eq!(points, [(0.0, 10.0), (20.0, 30.0)]);
        assert!(read_load("a,b\n1,2\n", 200.0).is_err());
    }
}
