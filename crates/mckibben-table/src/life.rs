//! Life curves of rubbers.

use super::vocabulary::LIVES;
use super::{Columns, Meaning, Table, TableError, read_text};
use std::io::Read;

/// Groups of [`LIVES`].
const LEVEL: usize = 0;
const CYCLES: usize = 1;

/// Cycles to failure of a rubber over what it is loaded with.
#[derive(Debug, Clone, PartialEq)]
pub struct LifeTable {
    /// Whether levels are energy densities in MPa; else they are stretches.
    pub of_energy: bool,
    /// (level, cycles) in the order of the table.
    pub points: Vec<(f64, f64)>,
}

/// Reads the life curve of a rubber from a table in any common form: largest stretches (a strain is one less) or energy densities, and cycles
/// to failure.
pub fn read_life(input: impl Read) -> Result<LifeTable, TableError> {
    let table = Table::read(&read_text(input)?, &LIVES, &Columns::default())?;
    let column = table.needed(LEVEL)?;
    let rest = if column.meaning == Meaning::Strain { 1.0 } else { 0.0 };
    let of_energy = column.meaning == Meaning::EnergyDensity;
    let levels = table.numbers(column)?;
    let cycles = table.numbers(table.needed(CYCLES)?)?;
    Ok(LifeTable { of_energy, points: levels.into_iter().map(|x| x + rest).zip(cycles).collect() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_strains_and_energies_are_life_curves() {
        let read = |text: &str| read_life(text.as_bytes()).unwrap();
        let stretch = read("stretch,cycles\n1.5,1e6\n2,1e5\n");
        assert_eq!(stretch, LifeTable { of_energy: false, points: vec![(1.5, 1e6), (2.0, 1e5)] });
        assert_eq!(read("strain [%];Lastwechsel\n50;1000000\n100;100000\n"), stretch);
        let energy = read("energy density [kPa],N\n100,1e6\n1000,1e4\n");
        assert_eq!(energy, LifeTable { of_energy: true, points: vec![(0.1, 1e6), (1.0, 1e4)] });
        assert!(read_life("stretch,force_n\n1.5,3\n".as_bytes()).is_err());
        assert!(read_life("energy_density,cycles\n1.5,3\n".as_bytes()).is_err(), "without a unit");
    }
}
