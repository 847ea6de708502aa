//! Files that users name, through the workspace's doors in and out, and TOML as maps and lists.

use crate::{error::Wrong, value};
use mckibben::{formula, muscle};
use mckibben_app::{JointFields, MotionRequest, Problem, ProblemKind, Subject, TextFile};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// A file that a person wrote (a muscle, a plan, a joint), of a `table` (whatever program wrote it) or of a `formula`: its name and its text.
#[pyfunction]
pub fn read_file(path: PathBuf, kind: &str) -> PyResult<(String, String)> {
    let file = match kind {
        "table" => TextFile::table(&path),
        "formula" => read(&path, |path| Ok(formula::read_text(path).map_err(|e| e.in_file(path))?)),
        _ => read(&path, |path| Ok(muscle::file::read_text(path).map_err(|e| e.in_file(path))?)),
    };
    Ok(file.map(|file| (file.name, file.text)).map_err(Wrong::from)?)
}

fn read(path: &Path, text: impl FnOnce(&Path) -> Result<String, Problem>) -> Result<TextFile, Problem> {
    Ok(TextFile { name: path.display().to_string(), text: text(path)? })
}

/// Puts a file at its place, whole or not at all.
#[pyfunction]
#[pyo3(signature = (path, content: "bytes"))]
pub fn write_file(path: PathBuf, content: &[u8]) -> PyResult<()> {
    let hint = "nothing was written; an existing file is as it was";
    let wrong = |e| Problem::new(ProblemKind::Output, format!("cannot write {}: {e}", path.display()), hint);
    Ok(mckibben_io::files::put(&path, content, true).map_err(|e| Wrong::from(wrong(e)))?)
}

/// The muscle files that a joint file names.
#[pyfunction]
pub fn joint_files(name: String, text: String) -> PyResult<Vec<String>> {
    Ok(JointFields::files_of(&TextFile { name, text }).map_err(Wrong::from)?)
}

/// What a drive file names: `muscle` or `joint`, the name of its file, and its tables.
#[pyfunction]
pub fn drive_files(name: String, text: String) -> PyResult<(&'static str, String, Vec<String>)> {
    let names = MotionRequest::names_of(&TextFile { name, text }).map_err(Wrong::from)?;
    let (subject, file) = match names.subject {
        Subject::Muscle(file) => ("muscle", file),
        Subject::Joint(file) => ("joint", file),
    };
    Ok((subject, file, names.tables))
}

/// A text in TOML as maps and lists.
#[pyfunction]
#[pyo3(signature = (name, text) -> "dict[str, typing.Any]")]
pub fn toml<'py>(py: Python<'py>, name: &str, text: &str) -> PyResult<Bound<'py, PyAny>> {
    let wrong =
        |e: toml_edit::de::Error| Problem::new(ProblemKind::File, format!("{name}: {}", e.message()), "");
    value::answer(py, &toml_edit::de::from_str(text).map_err(|e| Wrong::from(wrong(e)))?)
}

/// Maps and lists as a text in TOML.
#[pyfunction]
#[pyo3(signature = (tables: "dict[str, typing.Any]"))]
pub fn toml_text(tables: &Bound<'_, PyAny>) -> PyResult<String> {
    let wrong = |e: toml_edit::ser::Error| Problem::new(ProblemKind::File, e.to_string(), "");
    Ok(toml_edit::ser::to_string_pretty(&value::request(tables)?).map_err(|e| Wrong::from(wrong(e)))?)
}
