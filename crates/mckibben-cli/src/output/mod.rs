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
    let format = format_of(path, format)?;
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

/// The format of a file by its ending; without one, or for standard output, that of `--format`.
fn format_of(path: Option<&Path>, format: Format) -> Result<Format, Failure> {
    let Some(ending) = path.and_then(Path::extension) else { return Ok(format) };
    let by_ending = match ending.to_string_lossy().to_ascii_lowercase().as_str() {
        "txt" | "md" => Format::Text,
        "json" => Format::Json,
        "csv" => Format::Csv,
        other => {
            let message = format!("--output: nothing is written that ends in .{other}");
            return Err(Failure::input(ProblemKind::Output, message, "the endings are .txt, .json and .csv"));
        }
    };
    if format == Format::Text || format == by_ending {
        return Ok(by_ending);
    }
    let message = "--output and --format name two formats";
    Err(Failure::input(ProblemKind::Output, message, "leave out --format: the ending of the file says it"))
}
