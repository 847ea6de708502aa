//! Points from people's tables.

use super::{DataPoint, MeasuredPoint, PressureLog, Quantity, Section, over_time::branches};
use mckibben_core::{cancel, extremes::ends, muscle::Direction};
use mckibben_io::table::{
    Column, Columns, MEASURED, Meaning, Meaning::*, POINTS, RECORDED, Table, TableError,
    Understood, is_absolute, spoken,
};

type Result<T, E = TableError> = std::result::Result<T, E>;

/// What the table does not state.
#[derive(Debug, Default)]
pub struct PointOptions {
    /// Columns whose heading does not say what they are.
    pub columns: Columns,
    /// L0 of the muscle, for shortenings and lengths.
    pub rest_length_mm: Option<f64>,
    /// Pressures of another instrument, joined by time.
    pub log: Option<PressureLog>,
}

/// Groups of [`POINTS`].
const PRESSURE: usize = 0;
const CONTRACTION: usize = 1;
const FORCE: usize = 2;
const TIME: usize = 3;

/// [`read_points`] of a table that states everything.
pub fn read_data(text: &str) -> Result<Vec<DataPoint>> {
    Ok(read_points(text, &PointOptions::default())?.0)
}

/// Pressure, contraction, pull and branch of [`read_data`].
pub fn read_measured(text: &str) -> Result<Vec<MeasuredPoint>> {
    Ok(read_data(text)?.into_iter().map(|p| p.at).collect())
}

/// Reads points from a table in any common form ([`table`](mckibben_io::table)), with what was
/// understood of it.
///
/// Needed are pressures, contractions (or shortenings, or lengths that vary, with L0) and pulls,
/// each with its unit: `pressure_mpa`, `Druck in bar`, `p (psi)`; `contraction` is a ratio.
/// Understood are also `branch`, `measured` (force, contraction, pressure, volume),
/// `force_error_n`, `contraction_error`, `pressure_error_mpa`, `weight`, `outer_diameter_mm`,
/// `volume` (read in rows that state it in `measured`, and where there are no pulls), `wall_mm`,
/// `angle_deg`, L0 as `rest_length_mm` or, beside a contraction, `length_mm`; rows whose `status`
/// is not `ok` (points without answer, as `curve` writes them) are left out.
pub fn read_points(text: &str, options: &PointOptions) -> Result<(Vec<DataPoint>, Understood)> {
    let mut table = of_log(text, options)?;
    table.keep(Status, &["", "ok"]);
    let is_volume = |row: usize| matches!(table.text(row, Measured), Some((_, "volume")));
    if table.column(Force).is_some() && !(0..table.lines().len()).any(is_volume) {
        table.forget(Volume);
    }
    leave_blank_out(&mut table)?;
    let beside = table.needed(CONTRACTION)?.meaning != Length;
    let ours = table
        .column(Length)
        .is_some_and(|c| c.heading.eq_ignore_ascii_case("length_mm"));
    let length_is_l0 = beside && ours && table.column(RestLength).is_none();
    if length_is_l0 {
        table.rename(Length, RestLength);
    }
    let (pressures, joined) = pressures_by_log(&mut table, options.log.as_ref())?;
    let rest = table.above_zero(RestLength, MEASURE)?;
    let (contractions, note) = contractions(&table, &rest, options.rest_length_mm)?;
    if length_is_l0 {
        check_rest(&table, &rest, &contractions)?;
    }
    let by_velocity = matches!(table.text(0, Branch), Some((_, "velocity")));
    let branches = if by_velocity {
        table.forget(Branch);
        branches(&contractions, &pressures)
    } else {
        None
    };
    let mut points = rows(&table)?;
    // An error counts where its quantity was measured.
    for (quantity, error) in ERRORS.into_iter().enumerate() {
        if points.iter().all(|p| p.measured as usize != quantity) {
            table.forget(error);
        }
    }
    let forces = forces(&table, &points)?;
    for (i, point) in points.iter_mut().enumerate() {
        point.at.pressure_mpa = pressures[i];
        point.at.contraction = contractions[i];
        point.at.force_n = forces[i];
        point.section.length_mm = rest[i];
        if let Some(branches) = &branches {
            point.at.branch = Some(branches[i]);
        }
    }
    if points.is_empty() {
        return Err(table.no_points());
    }
    let by_velocity = by_velocity.then(|| "branches by the sign of the velocity".to_owned());
    let note = mckibben_core::joined(note.into_iter().chain(by_velocity), "; ");
    Ok((
        points,
        understood(&table, joined, (!note.is_empty()).then_some(note))?,
    ))
}

/// The table, whose pressures may be those of a log.
fn of_log(text: &str, options: &PointOptions) -> Result<Table> {
    let Some(log) = &options.log else {
        return Table::read(text, &POINTS, &options.columns);
    };
    let mut columns = options.columns.clone();
    let pressure = ("pressure".to_owned(), format!("={}", log.name));
    columns.0.extend([pressure]);
    Table::read(text, &RECORDED, &columns)
}

/// The pressures of the rows, or those of a log at their times, without rows outside of it.
fn pressures_by_log(table: &mut Table, log: Option<&PressureLog>) -> Result<(Vec<f64>, Note)> {
    let Some(log) = log else {
        return Ok((pressures(table)?, None));
    };
    let times = table.numbers(table.needed(TIME)?)?;
    let pulls = table.numbers(table.needed(FORCE)?)?;
    let (pressures, joined) = log.pressures_at(&times, &pulls);
    table.retain(|row| pressures[row].is_some());
    let outside = pressures.len() - table.lines().len();
    Ok((
        pressures.into_iter().flatten().collect(),
        Some(format!("{joined}; {outside} rows outside of it")),
    ))
}

/// Leaves out the rows of a sheet whose measured quantity is not filled in yet.
fn leave_blank_out(table: &mut Table) -> Result<()> {
    let contraction = table.needed(CONTRACTION)?.meaning;
    let force = table.needed(FORCE)?.meaning;
    table.keep_filled(|table, row| match table.text(row, Measured) {
        Some((_, "contraction")) => contraction,
        Some((_, "pressure")) => Pressure,
        Some((_, "volume")) => Volume,
        _ => force,
    });
    Ok(())
}

const MEASURE: &str = "is not a measure of a muscle; it must be above zero";

/// Pulls; 0 in rows of volumes that state none.
fn forces(table: &Table, points: &[DataPoint]) -> Result<Vec<f64>> {
    let column = table.needed(FORCE)?;
    let is_pull = |p: &DataPoint| p.measured != Quantity::Volume;
    if points.iter().all(is_pull) {
        return table.numbers(column);
    }
    let stated = table.some_numbers(Force)?;
    let one = |(row, force): (usize, Option<f64>)| match force {
        None if is_pull(&points[row]) => {
            Err(table.impossible(row, column, "is empty, and the row is none of a volume"))
        }
        force => Ok(force.unwrap_or(0.0)),
    };
    stated.into_iter().enumerate().map(one).collect()
}

fn pressures(table: &Table) -> Result<Vec<f64>> {
    let column = table.needed(PRESSURE)?;
    if !column.chosen && is_absolute(&column.heading) {
        return Err(TableError::Refused(format!(
            "column {column} has absolute pressures; use gauge pressures: subtract the atmospheric \
             pressure (about 0.101 MPa)",
            column = column.heading
        )));
    }
    let values = table.numbers(column)?;
    match values.iter().position(|p| *p < 0.0) {
        Some(row) => {
            Err(table.impossible(row, column, "is below zero; gauge pressure starts at 0"))
        }
        None => Ok(values),
    }
}

/// How a column was converted, where that is not plain.
type Note = Option<String>;

/// Contraction ratios, and how they were made.
fn contractions(
    table: &Table,
    rest: &[Option<f64>],
    muscle: Option<f64>,
) -> Result<(Vec<f64>, Note)> {
    let column = table.needed(CONTRACTION)?;
    let raw = table.numbers(column)?;
    let (values, note) = match column.meaning {
        Contraction => (raw, None),
        Extension => {
            let free = table.above_zero(FreeLength, MEASURE)?;
            let one = |(at, free): (usize, Option<f64>)| {
                let free = free?;
                let rest = rest[at].or(muscle)?;
                Some(rounded(1.0 - (free + raw[at]) / rest))
            };
            let ratios: Option<Vec<f64>> = free.into_iter().enumerate().map(one).collect();
            let needs = "the length of the muscle at that pressure without load, from which it \
                counts, and L0: free_length=250mm in `set`, or a column free_length_mm";
            (
                ratios.ok_or_else(|| column.needs(needs))?,
                Some("from the free length at its pressure".into()),
            )
        }
        meaning => {
            let in_rows = rest.iter().any(Option::is_some);
            let rest: Vec<f64> = rest.iter().filter_map(|l| l.or(muscle)).collect();
            if rest.len() != raw.len() {
                let needs = "the length L0 at rest: give the muscle with its `length_mm`, or a \
                    column rest_length_mm";
                return Err(column.needs(needs));
            }
            let l0 = match muscle {
                Some(l0) if !in_rows => format!("L0 {l0} mm"),
                _ => "the L0 of each row".into(),
            };
            let ratios = raw.iter().zip(&rest);
            if meaning == Length {
                check_varies(column, &raw)?;
                let ratios = ratios.map(|(l, l0)| rounded(1.0 - l / l0));
                (ratios.collect(), Some(format!("1 − L/L0, {l0}")))
            } else {
                (
                    ratios.map(|(x, l0)| rounded(x / l0)).collect(),
                    Some(format!("over {l0}")),
                )
            }
        }
    };
    let Some(row) = values.iter().position(|e: &f64| !(-0.9..0.95).contains(e)) else {
        return Ok((values, note));
    };
    let wrong = |expected| Err(table.impossible(row, column, expected));
    match (column.meaning, column.unit) {
        (Contraction, None) => Err(table.percent(row, column)),
        (Contraction, Some(unit)) if unit.name.is_empty() => wrong(
            "is not a valid contraction ratio ΔL/L0; write 0.15 for 15 %, or name the column \
             contraction_percent",
        ),
        (Contraction, _) => wrong("is not a valid contraction: no muscle shortens by so much"),
        (Length, _) => {
            wrong("is not a valid length of this muscle; check its unit and L0 (`length_mm`)")
        }
        _ => wrong("is not a valid shortening of this muscle; check its unit and L0 (`length_mm`)"),
    }
}

/// Zero without the rounding of a conversion from inches.
fn rounded(contraction: f64) -> f64 {
    if contraction.abs() < 1e-6 {
        0.0
    } else {
        contraction
    }
}

/// A length that is the same in all lines could be that at rest.
fn check_varies(column: &Column, lengths: &[f64]) -> Result<()> {
    let why = "is the same in all lines and does not give the contraction: add a column of \
        contractions, \
               or, if it is the present length, say so with `columns` length=\"HEADING:mm\"";
    if lengths.is_empty() || column.chosen || spread(lengths.iter().copied()) >= 1e-9 {
        return Ok(());
    }
    Err(TableError::Refused(format!(
        "column {} {why}",
        column.heading
    )))
}

/// Largest less smallest, relative to the largest.
fn spread(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) = ends(values);
    if high > 0.0 { (high - low) / high } else { 0.0 }
}

/// Beside a contraction `length_mm` means L0; a length that shrinks with the contraction is another
/// one.
fn check_rest(table: &Table, rest: &[Option<f64>], contractions: &[f64]) -> Result<()> {
    let lengths = || rest.iter().flatten().copied();
    if lengths().count() != contractions.len() || spread(lengths()) < 0.005 {
        return Ok(());
    }
    let ways = table
        .column(Shortening)
        .filter(|_| table.column(Contraction).is_none())
        .map(|column| table.numbers(column))
        .transpose()?;
    let rests = lengths()
        .zip(contractions)
        .enumerate()
        .map(|(i, (l, e))| match &ways {
            Some(ways) => l + ways[i],
            None => l / (1.0 - e),
        });
    match table.column(RestLength) {
        Some(Column { heading, .. }) if spread(rests.clone()) < 0.2 * spread(lengths()) => {
            Err(TableError::Refused(format!(
                "column {heading} decreases with the contraction; together with a contraction it \
                 means the length at rest: \
                 give the column another name (Length [mm]), and it is left out"
            )))
        }
        _ => Ok(()),
    }
}

const NEEDS_VOLUME: &str = "needs a volume in this row: add a column volume_mm3 or Volume [mL]";
const NEEDS_PULL: &str = "needs a pull in this row: add a column force_n";
const NO_ERROR: &str = "is not a valid standard error; it must be above zero";
const NO_WEIGHT: &str = "is not a valid weight; it must not be below zero";

/// Standard errors of each [`Quantity`].
const ERRORS: [Meaning; 4] = [ForceError, ContractionError, PressureError, VolumeError];

/// The rows, without pressure, contraction, pull and length.
fn rows(table: &Table) -> Result<Vec<DataPoint>> {
    let weights = table.some_numbers(Weight)?;
    let stated = ERRORS
        .map(|meaning| table.some_numbers(meaning))
        .into_iter()
        .collect::<Result<Vec<_>>>()?;
    let volumes = table.above_zero(Volume, "is not a volume of a muscle; it must be above zero")?;
    // Without pulls the volumes were measured.
    let alone = table.column(Force).is_none();
    let otherwise = if alone {
        Quantity::Volume
    } else {
        Quantity::Force
    };
    let diameters = table.above_zero(OuterDiameter, MEASURE)?;
    let walls = table.above_zero(Wall, MEASURE)?;
    let angles = table.above_zero(Angle, MEASURE)?;
    let branches = Direction::ALL.into_iter();
    let branches = branches.flat_map(|d| spoken(&format!("branch_{d}")).map(move |word| (word, d)));
    let branches: Vec<(&str, Direction)> = branches.collect();
    let one = |(row, line): (usize, u64)| {
        cancel::check()?;
        let branch = table.word(
            row,
            Branch,
            &branches,
            "neither \"contraction\" (while it shortens) nor \"elongation\" (while it \
            lengthens) nor \"mean\" (of both); say what your words mean with `set`, such as \
            Up=contraction, or let branch=velocity cut a log",
        )?;
        let measured = table
            .word(
                row,
                Measured,
                &Quantity::WORDS,
                "neither \"force\", \"contraction\", \"pressure\" nor \"volume\"",
            )?
            .unwrap_or(otherwise);
        let error = stated[measured as usize][row];
        let is_volume = measured == Quantity::Volume;
        let of_error = ERRORS[measured as usize];
        for (wrong, meaning, expected) in [
            (is_volume && volumes[row].is_none(), Measured, NEEDS_VOLUME),
            (alone && !is_volume, Measured, NEEDS_PULL),
            (error.is_some_and(|e| e <= 0.0), of_error, NO_ERROR),
            (weights[row].is_some_and(|w| w < 0.0), Weight, NO_WEIGHT),
        ] {
            if wrong {
                let column = table.column(meaning);
                return Err(column
                    .map(|column| table.impossible(row, column, expected))
                    .unwrap_or_else(TableError::empty));
            }
        }
        let at = MeasuredPoint {
            branch,
            ..Default::default()
        };
        Ok(DataPoint {
            measured,
            volume_mm3: volumes[row].filter(|_| is_volume),
            error,
            weight: weights[row].unwrap_or(1.0),
            section: Section {
                outer_diameter_mm: diameters[row],
                wall_mm: walls[row],
                length_mm: None,
                angle_deg: angles[row],
            },
            line,
            ..DataPoint::new(at)
        })
    };
    table.lines().into_iter().enumerate().map(one).collect()
}

fn understood(table: &Table, joined: Note, note: Note) -> Result<Understood> {
    let mut used = vec![
        (table.needed(PRESSURE)?, joined),
        (table.needed(CONTRACTION)?, note),
        (table.needed(FORCE)?, None),
    ];
    let others = [RestLength, FreeLength]
        .iter()
        .chain(MEASURED)
        .filter(|meaning| **meaning != Force);
    used.extend(others.filter_map(|meaning| Some((table.column(*meaning)?, None))));
    Ok(table.understood(&used))
}

#[cfg(test)]
mod tests;
