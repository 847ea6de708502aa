//! Tension tests from people's tables.

mod cell;
mod sheet;

use super::TensionPoint;
use crate::measured::distinct;
use cell::{LARGEST_STRETCH, STRESS, STRETCH, Tests};
use mckibben_core::joined;
use mckibben_io::table::{
    Column, Columns,
    Meaning::{self, *},
    TESTS, Table, TableError, Understood,
};

type Result<T, E = TableError> = std::result::Result<T, E>;

/// [`read_tests`] of a table that states everything.
pub fn read_tension(text: &str) -> Result<Vec<TensionPoint>> {
    Ok(read_tests(text, &Columns::default())?.0)
}

/// Reads points in the order of a table in any common form ([`table`](mckibben_io::table)), with
/// what was understood of it. Where neither the table nor its constants state the mode, the tests
/// are uniaxial.
pub fn read_tests(text: &str, columns: &Columns) -> Result<(Vec<TensionPoint>, Understood)> {
    let table = Table::read(text, &TESTS, columns)?;
    let stretch = table.needed(STRETCH)?;
    let stress = table.needed(STRESS)?;
    let gauges = match stretch.meaning {
        Extension | Length => {
            let needs =
                "the length at rest: a column `gauge_length`, or `set` such as gauge_length=25mm";
            of_specimen(&table, RestLength, stretch, needs)?
        }
        _ => vec![1.0; table.lines().len()],
    };
    let areas = match stress.meaning {
        Force => of_specimen(
            &table,
            Area,
            stress,
            "the cross-section of the specimen at rest: a column `area`, or `set` such \
                as area=8mm2",
        )?,
        _ => vec![],
    };
    let lengths = stretches(&table, stretch, &gauges)?;
    let tests = Tests {
        table: &table,
        areas_mm2: &areas,
    };
    let has_sheets = table.column(Stretch2).is_some();
    let points = if has_sheets {
        tests.sheet_points(&lengths)
    } else {
        tests.strip_points(&lengths, stress)
    }?;
    if points.is_empty() {
        return Err(TableError::empty());
    }
    let over = match stretch.meaning {
        Extension => Some(format!("over {} mm", listed(&gauges))),
        Length => Some(format!("L/L0, L0 {} mm", listed(&gauges))),
        _ => None,
    };
    let under = (stress.meaning == Force).then(|| format!("over {} mm²", listed(&areas)));
    let mut used = vec![(stretch, over), (stress, under)];
    let of_specimen = [Meaning::Mode, RestLength, Area];
    used.extend(
        of_specimen
            .into_iter()
            .filter_map(|m| Some((table.column(m)?, None))),
    );
    if has_sheets {
        let others = sheet::MEANINGS.into_iter().filter_map(|m| table.column(m));
        used.extend(
            others
                .filter(|c| c.index != stress.index)
                .map(|c| (c, None)),
        );
    }
    Ok((points, table.understood(&used)))
}

/// A dimension of the specimen of each row.
fn of_specimen(table: &Table, meaning: Meaning, of: &Column, needs: &str) -> Result<Vec<f64>> {
    table
        .above_zero(
            meaning,
            "is not a dimension of a specimen; it must be above zero",
        )?
        .into_iter()
        .map(|row| row.ok_or_else(|| of.needs(needs)))
        .collect()
}

/// The different values, for people.
fn listed(values: &[f64]) -> String {
    joined(
        distinct(values.iter().copied()).iter().map(f64::to_string),
        ", ",
    )
}

/// L/L0, row by row.
fn stretches(table: &Table, column: &Column, gauges: &[f64]) -> Result<Vec<f64>> {
    let (stretch, too_far, too_short): (&dyn Fn(f64, f64) -> f64, _, _) = match column.meaning {
        Stretch => (
            &|v, _| v,
            "is not a valid stretch L/L0; if it is a strain in percent, name the column \
             strain_percent",
            "is not a valid stretch L/L0, which is 1 at rest and above 0; if it is a strain, name \
             the column engineering_strain",
        ),
        Strain => (
            &|v, _| 1.0 + v,
            "is not a valid strain ΔL/L0; if it is in percent, name the column strain_percent",
            "is not a valid strain: the specimen would have no length left",
        ),
        TrueStrain => (
            &|v, _| v.exp(),
            "is not a valid true strain ln(L/L0)",
            "is not a valid true strain ln(L/L0)",
        ),
        Length => (
            &|v, gauge| v / gauge,
            "is too long for this gauge length",
            "is not a valid length of a specimen in tension; check the gauge length",
        ),
        _ => (
            &|v, gauge| 1.0 + v / gauge,
            "is too much for this gauge length",
            "is not an extension: the specimen would have no length left",
        ),
    };
    let stretches: Vec<f64> = table
        .numbers(column)?
        .into_iter()
        .zip(gauges)
        .map(|(value, gauge)| stretch(value, *gauge))
        .collect();
    let sound = |s: &f64| s.is_finite() && (0.02..=LARGEST_STRETCH).contains(s);
    match stretches.iter().position(|s| !sound(s)) {
        Some(row) if stretches[row] < 0.02 => Err(table.impossible(row, column, too_short)),
        Some(row) => Err(table.impossible(row, column, too_far)),
        None => Ok(stretches),
    }
}
