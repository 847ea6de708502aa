//! Results as text, JSON and CSV, and where they go.

mod csv;
pub mod text;
mod write;

pub use write::{emit, save, warn};

use crate::failure::Failure;
use crate::flags::Format;
use crate::quantities::to_mind;
use mckibben_app::ProblemKind;
use serde::Serialize;
use serde_json::Value;
use std::path::Path;

/// An answer as JSON.
pub fn json<T: Serialize>(answer: &T) -> Result<Value, Failure> {
    serde_json::to_value(answer)
        .map_err(|e| Failure::input(ProblemKind::Output, format!("cannot make JSON: {e}"), ""))
}

/// Prints an answer in the form that was asked for: as text for people, as JSON, or as CSV with a row for each element of
/// the list named `rows` (for the answer itself where the name is empty).
pub fn show<T: Serialize>(
    answer: &T,
    format: Format,
    rows: &str,
    text: impl FnOnce() -> String,
    path: Option<&Path>,
) -> Result<(), Failure> {
    let out = match format {
        Format::Text => {
            to_mind().into_iter().for_each(warn);
            text()
        }
        Format::Json => format!("{:#}\n", json(answer)?),
        Format::Csv => match json(answer)? {
            value if rows.is_empty() => csv::rows(&[value])?,
            value => csv::rows(value[rows].as_array().map_or(&[][..], |list| list))?,
        },
    };
    emit(&out, path)
}
