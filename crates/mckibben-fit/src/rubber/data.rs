//! Tension tests from people's tables.

mod cell;
mod sheet;

use super::{Mode, TensionPoint};
use cell::{LARGEST_STRETCH, STRESS, STRETCH, Tests};
use mckibben_io::table::{Column, Columns, Meaning, TESTS, Table, TableError, Understood, read_text};
use std::io::Read;

type Result<T, E = TableError> = std::result::Result<T, E>;

/// What the file does not state.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadOptions {
    /// Columns whose heading does not say what they are.
    pub columns: Columns,
    /// The mode, where there is no column of it.
    pub mode: Mode,
    /// Cross-section of the specimen at rest, for a column of forces.
    pub area_mm2: Option<f64>,
    /// Length at rest, for a column of extensions or lengths.
    pub gauge_length_mm: Option<f64>,
}

/// [`read_tests`] of a table that states everything.
pub fn read_tension(input: impl Read, options: ReadOptions) -> Result<Vec<TensionPoint>> {
    Ok(read_tests(input, &options)?.0)
}

/// Reads points in the order of a table in any common form ([`table`](mckibben_io::table)), with what was understood of it.
pub fn read_tests(input: impl Read, options: &ReadOptions) -> Result<(Vec<TensionPoint>, Understood)> {
    let table = Table::read(&read_text(input)?, &TESTS, &options.columns)?;
    let (stretch, stress) = (table.needed(STRETCH)?, table.needed(STRESS)?);
    let gauge = match stretch.meaning {
        Meaning::Extension | Meaning::Length => options.gauge_length_mm.ok_or_else(|| {
            TableError::needs(stretch, "the length at rest: `gauge_length_mm`, such as 25 mm")
        })?,
        _ => 1.0,
    };
    let area = match stress.meaning {
        Meaning::Force => options.area_mm2.ok_or_else(|| {
            TableError::needs(stress, "the cross-section of the specimen at rest: `area_mm2`, such as 8 mm²")
        })?,
        _ => 1.0,
    };
    let lengths = stretches(&table, stretch, gauge)?;
    let mut points = vec![];
    let tests = Tests { table: &table, area_mm2: area, default_mode: options.mode };
    let has_sheets = table.column(Meaning::Stretch2).is_some();
    if has_sheets {
        points = tests.sheet_points(&lengths)?;
    } else {
        const NEEDS: &str = "the second stretch of the specimen: a column `stretch_2`";
        if stress.meaning == Meaning::TrueStressDifference {
            return Err(TableError::needs(stress, NEEDS));
        }
        for (row, (stretch, measured)) in lengths.into_iter().zip(table.numbers(stress)?).enumerate() {
            let nominal_stress_mpa = tests.nominal_mpa(row, stress, measured, stretch)?;
            let mode = tests.mode(row)?.unwrap_or(options.mode);
            if mode == Mode::General {
                return Err(TableError::needs(stress, NEEDS));
            }
            points.push(TensionPoint::new(mode, stretch, nominal_stress_mpa));
        }
    }
    if points.is_empty() {
        return Err(TableError::empty());
    }
    let over = match stretch.meaning {
        Meaning::Extension => Some(format!("over {gauge} mm")),
        Meaning::Length => Some(format!("L/L0, L0 {gauge} mm")),
        _ => None,
    };
    let under = (stress.meaning == Meaning::Force).then(|| format!("over {area} mm²"));
    let mut used = vec![(stretch, over), (stress, under)];
    used.extend(table.column(Meaning::Mode).map(|c| (c, None)));
    if has_sheets {
        let others = sheet::MEANINGS.into_iter().filter_map(|m| table.column(m));
        used.extend(others.filter(|c| c.index != stress.index).map(|c| (c, None)));
    }
    let understood = table.understood(&used);
    Ok((points, understood))
}

/// L/L0, row by row.
fn stretches(table: &Table, column: &Column, gauge: f64) -> Result<Vec<f64>> {
    let (stretch, too_far, too_short): (&dyn Fn(f64) -> f64, _, _) = match column.meaning {
        Meaning::Stretch => (
            &|v| v,
            "is not a valid stretch L/L0; if it is a strain in percent, name the column strain_percent",
            "is not a valid stretch L/L0, which is 1 at rest and above 0; if it is a strain, name the column engineering_strain",
        ),
        Meaning::Strain => (
            &|v| 1.0 + v,
            "is not a valid strain ΔL/L0; if it is in percent, name the column strain_percent",
            "is not a valid strain: the specimen would have no length left",
        ),
        Meaning::TrueStrain => {
            (&f64::exp, "is not a valid true strain ln(L/L0)", "is not a valid true strain ln(L/L0)")
        }
        Meaning::Length => (
            &|v| v / gauge,
            "is too long for this gauge length",
            "is not a valid length of a specimen in tension; check the gauge length",
        ),
        _ => (
            &|v| 1.0 + v / gauge,
            "is too much for this gauge length",
            "is not an extension: the specimen would have no length left",
        ),
    };
    let stretches: Vec<f64> = table.numbers(column)?.into_iter().map(stretch).collect();
    let sound = |s: &f64| s.is_finite() && (0.02..=LARGEST_STRETCH).contains(s);
    match stretches.iter().position(|s| !sound(s)) {
        Some(row) if stretches[row] < 0.02 => Err(table.impossible(row, column, too_short)),
        Some(row) => Err(table.impossible(row, column, too_far)),
        None => Ok(stretches),
    }
}
