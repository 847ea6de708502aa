//! Points from CSV: what was measured, where, on which muscle, and how well.

use super::point::{MeasuredError, MeasuredPoint, mean_of_branches};
use crate::muscle::{Direction, Muscle, MuscleError};
use serde::{Deserialize, Serialize};
use std::io::Read;

/// What the bench read; the two others were set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Quantity {
    /// The pull, at a set pressure and length (isometric, isobaric).
    #[default]
    Force,
    /// The contraction, at a set pressure and pull (isotonic).
    Contraction,
    /// The pressure, at a set pull and length.
    Pressure,
}

/// Measures of the muscle that a row states; the others are the muscle file's.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Section {
    /// D0 in mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outer_diameter_mm: Option<f64>,
    /// s in mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wall_mm: Option<f64>,
    /// L0 in mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length_mm: Option<f64>,
    /// θ0 in degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<f64>,
}

impl Section {
    /// The muscle with these measures.
    ///
    /// # Errors
    /// [`MuscleError`].
    pub fn apply(&self, muscle: &Muscle) -> Result<Muscle, MuscleError> {
        let mut tube = muscle.tube().clone();
        tube.outer_diameter_mm = self.outer_diameter_mm.unwrap_or(tube.outer_diameter_mm);
        let mut braid = muscle.braid_on(tube.outer_diameter_mm)?;
        tube.wall_mm = self.wall_mm.unwrap_or(tube.wall_mm);
        tube.length_mm = self.length_mm.unwrap_or(tube.length_mm);
        braid.angle_deg = self.angle_deg.unwrap_or(braid.angle_deg);
        Muscle::new(tube, braid, muscle.terminals().clone(), muscle.friction().copied())
    }
}

/// One row of data.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DataPoint {
    /// Pressure, contraction, pull, branch.
    #[serde(flatten)]
    pub at: MeasuredPoint,
    /// Which of them was read.
    pub measured: Quantity,
    /// Standard error of what was read, in its unit, where it is stated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
    /// How much it counts; 1 where nothing is said.
    pub weight: f64,
    /// Measures of its muscle.
    #[serde(flatten)]
    pub section: Section,
    /// Line in its file, the header being line 1; 0 where it comes from no file.
    pub line: u64,
    /// Which of several sets of data it belongs to.
    pub set: usize,
}

impl DataPoint {
    /// A measured pull.
    pub fn of(at: MeasuredPoint) -> Self {
        Self {
            at,
            measured: Quantity::Force,
            error: None,
            weight: 1.0,
            section: Section::default(),
            line: 0,
            set: 0,
        }
    }
}

struct Table {
    header: csv::StringRecord,
}

type Column = (usize, f64);

impl Table {
    fn find(&self, names: &[(&str, f64)]) -> Option<Column> {
        names.iter().find_map(|&(name, den)| {
            let strip = |h: &str| h.trim_start_matches('\u{feff}').eq_ignore_ascii_case(name);
            self.header.iter().position(strip).map(|i| (i, den))
        })
    }

    fn needed(&self, wanted: &'static str, names: &[(&str, f64)]) -> Result<Column, MeasuredError> {
        let found = || self.header.iter().collect::<Vec<_>>().join(", ");
        self.find(names).ok_or_else(|| MeasuredError::MissingColumn { wanted, found: found() })
    }
}

struct Row<'a> {
    table: &'a Table,
    record: csv::StringRecord,
    line: u64,
}

impl Row<'_> {
    fn text(&self, column: Option<Column>) -> &str {
        column.and_then(|c| self.record.get(c.0)).unwrap_or("")
    }

    fn number(&self, (i, den): Column) -> Result<f64, MeasuredError> {
        let text = self.record.get(i).unwrap_or("");
        match text.parse::<f64>() {
            Ok(v) if v.is_finite() => Ok(v / den),
            _ => {
                let column = self.table.header[i].to_owned();
                Err(MeasuredError::NotANumber { line: self.line, column, text: text.into() })
            }
        }
    }

    /// A number, where the field is not empty, that passes a test.
    fn some(
        &self,
        column: Option<Column>,
        sound: fn(f64) -> bool,
        expected: &'static str,
    ) -> Result<Option<f64>, MeasuredError> {
        let Some(column) = column.filter(|_| !self.text(column).is_empty()) else { return Ok(None) };
        let v = self.number(column)?;
        if sound(v) { Ok(Some(v)) } else { Err(self.impossible(column, v, expected)) }
    }

    fn impossible(&self, column: Column, value: f64, expected: &'static str) -> MeasuredError {
        let column = self.table.header[column.0].to_owned();
        MeasuredError::Impossible { line: self.line, column, value, expected }
    }

    fn word<T: Copy>(
        &self,
        column: Option<Column>,
        words: &[(&str, T)],
        unknown: impl Fn(u64, String) -> MeasuredError,
    ) -> Result<Option<T>, MeasuredError> {
        match self.text(column) {
            "" => Ok(None),
            text => match words.iter().find(|w| w.0 == text) {
                Some(w) => Ok(Some(w.1)),
                None => Err(unknown(self.line, text.into())),
            },
        }
    }
}

/// Reads points from CSV with a header line. Lines that start with `#` are comments; lines whose `status` is not `ok`
/// (points without answer, as `curve` writes them) are left out.
///
/// Columns: `pressure_mpa` (or `pressure_kpa`, `pressure_bar`), `contraction` (or `contraction_percent`), `force_n`; and where
/// they stand `branch`, `measured` (force, contraction, pressure), `force_error_n`, `contraction_error`,
/// `pressure_error_mpa`, `weight`, `outer_diameter_mm`, `wall_mm`, `length_mm`, `angle_deg`, `status`.
///
/// # Errors
/// [`MeasuredError`] names line and column.
pub fn read_data(input: impl Read) -> Result<Vec<DataPoint>, MeasuredError> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(input);
    let table = Table { header: reader.headers()?.clone() };
    let pressure = [("pressure_mpa", 1.0), ("pressure_kpa", 1e3), ("pressure_bar", 10.0)];
    let pressure = table.needed("pressure_mpa", &pressure)?;
    let contraction = table.needed("contraction", &[("contraction", 1.0), ("contraction_percent", 100.0)])?;
    let force = table.needed("force_n", &[("force_n", 1.0)])?;
    let optional = |name: &str| table.find(&[(name, 1.0)]);
    let (branch, status, measured) = (optional("branch"), optional("status"), optional("measured"));
    let errors = [optional("force_error_n"), optional("contraction_error"), optional("pressure_error_mpa")];
    let weight = optional("weight");
    let section = ["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg"].map(optional);
    let mut points = Vec::new();
    for record in reader.records() {
        let record = record?;
        let line = record.position().map_or(0, csv::Position::line);
        let row = Row { table: &table, record, line };
        // A point of `curve --format csv` that has no answer.
        if !["", "ok"].contains(&row.text(status)) {
            continue;
        }
        let (p, e, f) = (row.number(pressure)?, row.number(contraction)?, row.number(force)?);
        if p < 0.0 {
            return Err(row.impossible(pressure, p, "MPa is below zero; gauge pressure starts at 0"));
        }
        if !(-0.9..0.95).contains(&e) {
            let expected =
                "is no contraction ratio ΔL/L0; write 0.15 for 15 %, or name the column contraction_percent";
            return Err(row.impossible(contraction, e, expected));
        }
        let branches = [("contraction", Direction::Contraction), ("elongation", Direction::Elongation)];
        let branch = row
            .word(branch, &branches, |line, text| MeasuredError::Branch { line, text })?
            .unwrap_or_default();
        let quantities = [
            ("force", Quantity::Force),
            ("contraction", Quantity::Contraction),
            ("pressure", Quantity::Pressure),
        ];
        let measured = row
            .word(measured, &quantities, |line, text| MeasuredError::Quantity { line, text })?
            .unwrap_or_default();
        let above = |v: f64| v > 0.0;
        let error =
            row.some(errors[measured as usize], above, "is no standard error; it must be above zero")?;
        let weight =
            row.some(weight, |v| v >= 0.0, "is no weight; it must not be below zero")?.unwrap_or(1.0);
        let measure =
            |i: usize| row.some(section[i], above, "is no measure of a muscle; it must be above zero");
        points.push(DataPoint {
            at: MeasuredPoint { pressure_mpa: p, contraction: e, force_n: f, branch },
            measured,
            error,
            weight,
            section: Section {
                outer_diameter_mm: measure(0)?,
                wall_mm: measure(1)?,
                length_mm: measure(2)?,
                angle_deg: measure(3)?,
            },
            line,
            set: 0,
        });
    }
    if points.is_empty() { Err(MeasuredError::Empty) } else { Ok(points) }
}

/// The mean of the two hysteresis branches, muscle by muscle; see [`mean_of_branches`]. A mean keeps the line of its
/// lower point.
pub fn mean_of_data(points: &[DataPoint]) -> Vec<DataPoint> {
    let mut groups: Vec<Vec<DataPoint>> = vec![];
    for p in points {
        match groups
            .iter_mut()
            .find(|g| g[0].section == p.section && g[0].set == p.set && g[0].measured == p.measured)
        {
            Some(group) => group.push(*p),
            None => groups.push(vec![*p]),
        }
    }
    let mut out = vec![];
    for group in groups {
        let rows: Vec<MeasuredPoint> = group.iter().map(|p| p.at).collect();
        for mean in mean_of_branches(&rows) {
            let same = |p: &&DataPoint| {
                p.at.pressure_mpa == mean.pressure_mpa && p.at.contraction == mean.contraction
            };
            let lower = |p: &&DataPoint| same(p) && p.at.branch != Direction::Elongation;
            let origin = group.iter().find(lower).or_else(|| group.iter().find(same));
            out.extend(origin.map(|p| DataPoint { at: mean, ..*p }));
        }
    }
    out
}
