//! Why a table cannot be read.

use thiserror::Error;

/// Why a table cannot be read. Lines are counted from 1, as an editor counts them. Fields of requests are named in
/// backquotes.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TableError {
    /// It cannot be read at all.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// More than anybody measures.
    #[error("the table is larger than {} MB; take fewer lines", .limit >> 20)]
    TooLarge { limit: usize },
    /// Another kind of file.
    #[error("this is not text but {what}; save the table as CSV")]
    NotText { what: &'static str },
    /// A field that runs over many lines.
    #[error("line {line}: a quote (\") is opened and not closed")]
    OpenQuote { line: u64 },
    /// A record that cannot be split.
    #[error("after line {line}: {why}")]
    Broken { line: u64, why: String },
    /// No column of that meaning.
    #[error(
        "no column of {wanted} (the columns are: {found}); name it {names}, or assign it with `columns` {example}"
    )]
    MissingColumn { wanted: &'static str, found: String, names: &'static str, example: String },
    /// A quantity in `columns` that this kind of table does not have.
    #[error("`columns`: {what} have no quantity \"{name}\"{meant}; they have {known}")]
    UnknownQuantity { what: &'static str, name: String, meant: String, known: String },
    /// A column in `columns` that is not there.
    #[error("`columns`: there is no column \"{heading}\" (the columns are: {found})")]
    NoSuchColumn { heading: String, found: String },
    /// A column in `columns` for two quantities.
    #[error("`columns`: the column \"{heading}\" is chosen for two quantities")]
    ChosenTwice { heading: String },
    /// A unit in `columns` that the quantity does not have.
    #[error("`columns`: \"{unit}\" is not a unit of {name}; its units are {units}")]
    ChosenUnit { unit: String, name: &'static str, units: String },
    /// Two columns for one quantity.
    #[error("the columns {found} could all be {name}: select one with `columns` {name}=\"{example}\"")]
    Ambiguous { name: &'static str, found: String, example: String },
    /// Nobody says in which unit a column is.
    #[error(
        "column {column} does not state its unit{stated}; write it after the heading, as {column} [{unit}], or give `columns` {name}=\"{column}:{unit}\" (units: {units})"
    )]
    NoUnit {
        column: String,
        /// What is in its place, where something does.
        stated: &'static str,
        name: &'static str,
        unit: &'static str,
        units: String,
    },
    /// A unit that the quantity does not have, in the line of units or behind a number.
    #[error("line {line}, column {column}: \"{unit}\" is not a unit of {name}{clash}; its units are {units}")]
    Unit {
        line: u64,
        column: String,
        unit: String,
        name: &'static str,
        /// What else was said.
        clash: String,
        units: String,
    },
    /// Absolute pressures.
    #[error(
        "column {column} has absolute pressures; use gauge pressures: subtract the atmospheric pressure (about 0.101 MPa)"
    )]
    Absolute { column: String },
    /// A column of ratios that holds percent or something else.
    #[error(
        "line {line}, column {column}: {text} is not a valid contraction ratio ΔL/L0, and its heading has no unit; write 0.15 for 15 %, name the column contraction_percent, or give `columns` contraction=\"{column}:%\" (:mm if it is a length)"
    )]
    Percent { line: u64, column: String, text: String },
    /// Numbers above the heading.
    #[error(
        "line {line} contains numbers, but the heading is in line {heading}: put the heading first, or make the line a comment (#)"
    )]
    AboveHeading { line: u64, heading: u64 },
    /// A line that ends too early.
    #[error(
        "line {line} has {found} fields and the heading {expected}; every line needs as many fields as the heading"
    )]
    TooShort { line: u64, found: usize, expected: usize },
    /// A line that goes on behind the last column.
    #[error("line {line} has {found} fields and the heading {expected}{hint}")]
    TooLong { line: u64, found: usize, expected: usize, hint: &'static str },
    /// A field that is not a finite number.
    #[error("line {line}, column {column}: \"{text}\" is not a finite number{hint}")]
    NotANumber { line: u64, column: String, text: String, hint: &'static str },
    /// A comma and a point that could be decimal or thousands.
    #[error(
        "line {line}, column {column}: \"{text}\" can be read in two ways: is its mark a decimal mark, or does it separate thousands? Write numbers without separators of thousands, with the same decimal mark in all lines"
    )]
    Thousands { line: u64, column: String, text: String },
    /// A number that cannot be.
    #[error("line {line}, column {column}: {text} {expected}")]
    Impossible { line: u64, column: String, text: String, expected: &'static str },
    /// A word that is not known.
    #[error("line {line}: the {name} \"{text}\" is {known}")]
    Word {
        line: u64,
        name: &'static str,
        text: String,
        /// That it is none of those that are.
        known: String,
    },
    /// A column that needs a number which no table carries.
    #[error("column {column} needs {needs}")]
    Needs {
        column: String,
        /// What is missing, and the field that gives it.
        needs: &'static str,
    },
    /// A length that says nothing about contraction, or perhaps both.
    #[error("column {column} {why}")]
    Length {
        column: String,
        /// Why it cannot be used, and what to do.
        why: &'static str,
    },
    /// No points at all.
    #[error("no points: nothing follows the heading")]
    Empty,
}

/// Somebody else's text, cut where it gets long.
pub(crate) fn short(text: &str) -> String {
    text.chars().take(60).map(|c| if c.is_control() { ' ' } else { c }).collect()
}
