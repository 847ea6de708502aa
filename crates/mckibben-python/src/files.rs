//! Files that users name, through the workspace's doors in and out, and TOML as maps and lists.

use crate::{error::Wrong, value};
use mckibben::{formula, muscle};
use mckibben_app::{JointFields, MotionRequest, Problem, ProblemKind, Subject, TextFile};
use pyo3::prelude::*;
use serde_json::{Map, Value};
use std::path::PathBuf;
use toml_edit::{DocumentMut, Item, Table};

/// A file written by hand: a muscle, a plan, a joint.
#[pyfunction]
pub fn read_text(path: PathBuf) -> PyResult<String> {
    Ok(muscle::file::read_text(&path).map_err(|e| Wrong::from(Problem::from(e.in_file(&path))))?)
}

/// The name and the text of a table, whatever program wrote it. Such files may be long.
#[pyfunction]
pub fn read_table(path: PathBuf) -> PyResult<(String, String)> {
    let file = TextFile::table(&path).map_err(Wrong::from)?;
    Ok((file.name, file.text))
}

#[pyfunction]
pub fn read_formula(path: PathBuf) -> PyResult<String> {
    Ok(formula::read_text(&path).map_err(|e| Wrong::from(Problem::from(e.in_file(&path))))?)
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

/// Maps and lists as a text in TOML. Tables, and those in them, have a heading each; maps in these are inline.
#[pyfunction]
#[pyo3(signature = (tables: "dict[str, typing.Any]"))]
pub fn toml_text(tables: &Bound<'_, PyAny>) -> PyResult<String> {
    let mut document = DocumentMut::new();
    if let Value::Object(map) = value::request(tables)? {
        *document.as_table_mut() = table_of(&map, 2);
    }
    Ok(document.to_string())
}

fn table_of(map: &Map<String, Value>, deeper: u8) -> Table {
    let mut out = Table::new();
    // What holds nothing but tables needs no heading.
    out.set_implicit(!map.is_empty() && map.values().all(Value::is_object));
    for (key, value) in map {
        match (value, deeper.checked_sub(1)) {
            (Value::Object(map), Some(deeper)) => drop(out.insert(key, Item::Table(table_of(map, deeper)))),
            _ => drop(inline(value).map(|value| out.insert(key, Item::Value(value)))),
        }
    }
    out
}

/// A value; none of null, which TOML does not have.
fn inline(value: &Value) -> Option<toml_edit::Value> {
    Some(match value {
        Value::Null => return None,
        Value::Bool(yes) => (*yes).into(),
        Value::Number(number) => match number.as_i64() {
            Some(whole) => whole.into(),
            None => number.as_f64()?.into(),
        },
        Value::String(text) => text.as_str().into(),
        Value::Array(list) => toml_edit::Value::Array(list.iter().filter_map(inline).collect()),
        Value::Object(map) => {
            let pairs = map.iter().filter_map(|(key, value)| Some((key, inline(value)?)));
            toml_edit::Value::InlineTable(pairs.collect())
        }
    })
}
