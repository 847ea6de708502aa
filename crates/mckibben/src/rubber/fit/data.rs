//! Tension tests from CSV.

use super::columns::{self, StressKind, StretchKind};
use super::mode::Mode;
use serde::{Deserialize, Serialize};
use std::io::Read;
use thiserror::Error;

/// One point of a test.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TensionPoint {
    /// How the specimen was stretched.
    pub mode: Mode,
    /// L/L0.
    pub stretch: f64,
    /// Force over the area at rest, in MPa.
    pub nominal_stress_mpa: f64,
}

/// What the file does not say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReadOptions {
    /// The mode, where there is no column of it.
    pub mode: Mode,
    /// Cross-section of the specimen at rest, for a column of forces.
    pub area_mm2: Option<f64>,
    /// Length at rest, for a column of extensions.
    pub gauge_length_mm: Option<f64>,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self { mode: Mode::Uniaxial, area_mm2: None, gauge_length_mm: None }
    }
}

/// Why a tension test cannot be read. Lines are counted from 1, the header being line 1.
#[derive(Debug, Error)]
pub enum TensionError {
    /// No column of that meaning.
    #[error("no column of {wanted} (the columns are: {found}); name it {names}")]
    MissingColumn {
        /// What is needed.
        wanted: &'static str,
        /// What is there.
        found: String,
        /// What it may be called.
        names: &'static str,
    },
    /// A stress without a unit.
    #[error(
        "column {column} does not say its unit; name it {column}_mpa, {column}_kpa or {column}_psi (a force: {column}_n)"
    )]
    NoUnit {
        /// Column name.
        column: String,
    },
    /// A column that needs a number which no file carries.
    #[error("column {column} needs {needs}")]
    Needs {
        /// Column name.
        column: String,
        /// What is missing, and the field that gives it.
        needs: &'static str,
    },
    /// A field that is not a finite number.
    #[error("line {line}, column {column}: \"{text}\" is not a finite number{hint}")]
    NotANumber {
        /// Line in the file.
        line: u64,
        /// Column name.
        column: String,
        /// The field as written.
        text: String,
        /// What was probably meant.
        hint: &'static str,
    },
    /// A number that no test gives.
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
    /// A word in the column of modes that is not known.
    #[error("line {line}: the mode \"{text}\" is none of {}", Mode::WORDS)]
    Mode {
        /// Line in the file.
        line: u64,
        /// The word.
        text: String,
    },
    /// No points at all.
    #[error("no points: the file ends after its header")]
    Empty,
    /// The table itself is broken (a line with missing fields, bytes that are not UTF-8, an unreadable file).
    #[error("{0}; every line needs as many fields as the header")]
    Csv(#[from] csv::Error),
    /// The file cannot be read.
    #[error("{0}")]
    Io(#[from] std::io::Error),
}

/// No rubber is stretched further: a larger number is in percent, or in another unit.
const LARGEST_STRETCH: f64 = 25.0;

/// Reads points in the order of the file. Fields are separated by comma, semicolon or tab; decimal commas are understood
/// where the separator is another. Lines that start with `#` are comments.
///
/// # Errors
/// [`TensionError`] names line and column.
// Bytes that are not UTF-8 (a degree sign or ² from an old program) are no reason to refuse a table of numbers.
pub fn read_tension(mut input: impl Read, options: ReadOptions) -> Result<Vec<TensionPoint>, TensionError> {
    let mut bytes = vec![];
    input.read_to_end(&mut bytes)?;
    let text = String::from_utf8_lossy(&bytes);
    let first = text.lines().find(|l| !l.starts_with('#') && !l.trim().is_empty()).unwrap_or("");
    let separator = [b';', b'\t'].into_iter().find(|s| first.as_bytes().contains(s)).unwrap_or(b',');
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .delimiter(separator)
        .from_reader(text.as_bytes());
    let header = reader.headers()?.clone();
    let table = Table::new(&header, options, separator != b',')?;
    let mut points = vec![];
    for record in reader.records() {
        let record = record?;
        if record.iter().all(str::is_empty) {
            continue;
        }
        points.push(table.point(&record)?);
    }
    if points.is_empty() { Err(TensionError::Empty) } else { Ok(points) }
}

struct Table<'a> {
    header: &'a csv::StringRecord,
    stretch: (usize, StretchKind),
    stress: (usize, StressKind),
    mode: Option<usize>,
    options: ReadOptions,
    decimal_comma: bool,
}

impl<'a> Table<'a> {
    fn new(
        header: &'a csv::StringRecord,
        options: ReadOptions,
        decimal_comma: bool,
    ) -> Result<Self, TensionError> {
        let plain: Vec<String> = header.iter().map(columns::plain).collect();
        let missing = |wanted, names| TensionError::MissingColumn {
            wanted,
            found: header.iter().collect::<Vec<_>>().join(", "),
            names,
        };
        let stretch = columns::stretch(&plain)
            .ok_or_else(|| missing("stretches", "stretch, engineering_strain or strain_percent"))?;
        let stress = columns::stress(&plain)
            .ok_or_else(|| {
                missing("stresses", "nominal_stress_mpa (or _kpa, _psi), true_stress_mpa or force_n")
            })?
            .map_err(|i| TensionError::NoUnit { column: header[i].into() })?;
        let needs = |i: usize, needs| TensionError::Needs { column: header[i].into(), needs };
        if matches!(stress.1, StressKind::Force(_)) && options.area_mm2.is_none() {
            return Err(needs(
                stress.0,
                "the cross-section of the specimen at rest: `area_mm2`, such as 8 mm²",
            ));
        }
        if stretch.1 == StretchKind::ExtensionMm && options.gauge_length_mm.is_none() {
            return Err(needs(stretch.0, "the length at rest: `gauge_length_mm`, such as 25 mm"));
        }
        Ok(Self { header, stretch, stress, mode: columns::mode(&plain), options, decimal_comma })
    }

    fn point(&self, record: &csv::StringRecord) -> Result<TensionPoint, TensionError> {
        let line = record.position().map_or(0, csv::Position::line);
        let mode = match self.mode.and_then(|i| record.get(i)) {
            None => self.options.mode,
            Some(text) => Mode::parse(text).ok_or_else(|| TensionError::Mode { line, text: text.into() })?,
        };
        let raw = self.number(record, self.stretch.0, line)?;
        let impossible = |expected| TensionError::Impossible {
            line,
            column: self.header[self.stretch.0].into(),
            value: raw,
            expected,
        };
        let gauge = self.options.gauge_length_mm.unwrap_or(f64::NAN);
        let (stretch, too_far, too_short) = match self.stretch.1 {
            StretchKind::Stretch => (
                raw,
                "is no stretch L/L0; if it is a strain in percent, name the column strain_percent",
                "is no stretch L/L0, which is 1 at rest and above 0; if it is a strain, name the column engineering_strain",
            ),
            StretchKind::Strain(k) => (
                1.0 + k * raw,
                "is no strain ΔL/L0; if it is in percent, name the column strain_percent",
                "is no strain: the specimen would have no length left",
            ),
            StretchKind::TrueStrain => {
                (raw.exp(), "is no true strain ln(L/L0)", "is no true strain ln(L/L0)")
            }
            StretchKind::ExtensionMm => (
                1.0 + raw / gauge,
                "mm is too much for this gauge length",
                "mm: the specimen would have no length left",
            ),
        };
        if !(stretch.is_finite() && stretch <= LARGEST_STRETCH) {
            return Err(impossible(too_far));
        }
        if stretch < 0.02 {
            return Err(impossible(too_short));
        }
        let stress = self.number(record, self.stress.0, line)?;
        let nominal_stress_mpa = match self.stress.1 {
            StressKind::Nominal(k) => k * stress,
            StressKind::True(k) => k * stress / stretch,
            StressKind::Force(k) => k * stress / self.options.area_mm2.unwrap_or(f64::NAN),
        };
        if nominal_stress_mpa.is_nan() || nominal_stress_mpa.abs() >= 1e6 {
            return Err(TensionError::Impossible {
                line,
                column: self.header[self.stress.0].into(),
                value: stress,
                expected: "gives no stress a rubber bears; look at the unit",
            });
        }
        Ok(TensionPoint { mode, stretch, nominal_stress_mpa })
    }

    fn number(&self, record: &csv::StringRecord, i: usize, line: u64) -> Result<f64, TensionError> {
        let text = record.get(i).unwrap_or("");
        let dotted = text.replace(',', ".");
        let readable = if self.decimal_comma { &dotted } else { text };
        match readable.parse::<f64>() {
            Ok(v) if v.is_finite() => Ok(v),
            _ => {
                let hint = if text.is_empty() {
                    "; the field is empty: leave the whole line out"
                } else if text.contains(',') {
                    "; write a decimal point"
                } else {
                    ""
                };
                let column = self.header[i].into();
                Err(TensionError::NotANumber { line, column, text: text.chars().take(60).collect(), hint })
            }
        }
    }
}
