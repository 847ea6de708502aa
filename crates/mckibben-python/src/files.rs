//! Files that users name, read through the workspace's one door.

use crate::error::Wrong;
use mckibben::{formula, muscle};
use mckibben_app::{JointFields, MotionRequest, Problem, ProblemKind, Subject, TextFile};
use mckibben_table as table;
use pyo3::prelude::*;
use std::path::PathBuf;

/// A file written by hand: a muscle, a plan, a joint.
#[pyfunction]
pub fn read_text(path: PathBuf) -> PyResult<String> {
    Ok(muscle::file::read_text(&path).map_err(|e| Wrong::from(Problem::from(e.of(&path))))?)
}

/// A table, whatever program wrote it. Such files may be long.
#[pyfunction]
pub fn read_table(path: PathBuf) -> PyResult<String> {
    let name = path.display().to_string();
    let unread = |e: mckibben_files::ReadError| Problem::new(ProblemKind::File, format!("{name} {e}"), "");
    let bytes = mckibben_files::read(&path, table::MAX_BYTES as u64).map_err(|e| Wrong::from(unread(e)))?;
    let text = table::read_text(bytes.as_slice());
    Ok(text.map_err(|e| Wrong::from(Problem::of_table(&name, &e)))?)
}

/// The file of a formula.
#[pyfunction]
pub fn read_formula(path: PathBuf) -> PyResult<String> {
    Ok(formula::read_text(&path).map_err(|e| Wrong::from(Problem::from(e.in_file(&path))))?)
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
