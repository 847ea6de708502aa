//! Files that users name, through the workspace's doors in and out, and TOML as maps and lists.

use crate::{error::Wrong, value};
use mckibben_app::{JointFields, MotionRequest, Problem, ProblemKind, TextFile};
use pyo3::prelude::*;
use serde_json::json;
use std::path::PathBuf;

/// A file that users name, as requests hold it: of a person (`text`), a `muscle`, a `table`; or of
/// several, with those that it names: a `joint`, a `drive`.
#[pyfunction]
#[pyo3(signature = (path, kind) -> "dict[str, typing.Any]")]
pub fn read<'py>(py: Python<'py>, path: PathBuf, kind: &str) -> PyResult<Bound<'py, PyAny>> {
    let file = |file: Result<TextFile, Problem>| file.map(|file| json!(file));
    let read = match kind {
        "table" => file(TextFile::table(&path)),
        "muscle" => file(TextFile::muscle(&path)),
        "joint" => JointFields::read(&path).map(|fields| json!(fields)),
        "drive" => MotionRequest::default().with_drive(&path).map(|r| {
            json!({ "drive": r.drive, "muscle": r.muscle, "joint": r.joint.joint, "muscles": r.joint.muscles, "tables": r.tables })
        }),
        _ => file(TextFile::read(&path)),
    };
    value::answer(py, &read.map_err(Wrong::from)?)
}

/// Puts a file at its place, whole or not at all.
#[pyfunction]
#[pyo3(signature = (path, content: "bytes"))]
pub fn write_file(path: PathBuf, content: &[u8]) -> PyResult<()> {
    let hint = "nothing was written; an existing file is as it was";
    let wrong = |e| {
        Problem::new(
            ProblemKind::Output,
            format!("cannot write {}: {e}", path.display()),
            hint,
        )
    };
    Ok(mckibben_io::files::put(&path, content, true).map_err(|e| Wrong::from(wrong(e)))?)
}

/// A text in TOML as maps and lists.
#[pyfunction]
#[pyo3(signature = (name, text) -> "dict[str, typing.Any]")]
pub fn toml<'py>(py: Python<'py>, name: &str, text: &str) -> PyResult<Bound<'py, PyAny>> {
    let wrong = |e: toml_edit::de::Error| {
        Problem::new(ProblemKind::File, format!("{name}: {}", e.message()), "")
    };
    value::answer(
        py,
        &toml_edit::de::from_str(text).map_err(|e| Wrong::from(wrong(e)))?,
    )
}

/// Maps and lists as a text in TOML.
#[pyfunction]
#[pyo3(signature = (tables: "dict[str, typing.Any]"))]
pub fn toml_text(tables: &Bound<'_, PyAny>) -> PyResult<String> {
    let wrong = |e: toml_edit::ser::Error| Problem::new(ProblemKind::File, e.to_string(), "");
    Ok(toml_edit::ser::to_string_pretty(&value::request(tables)?)
        .map_err(|e| Wrong::from(wrong(e)))?)
}
