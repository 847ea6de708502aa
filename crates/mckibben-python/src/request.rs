//! Requests as users write them: paths in the place of files, texts that must state their unit, and
//! numbers that were likely meant in another unit.

use crate::{error::Wrong, value};
use mckibben_app::{Problem, ProblemKind, TextFile, find};
use mckibben_core::units::{Dimension, NamedUnit, parse_quantity};
use pyo3::prelude::*;
use serde_json::{Value, json};
use std::{fmt::Display, path::Path};

/// Bare numbers of fields beyond which they were likely meant in another unit.
const LIKELY: [(&str, f64, f64); 7] = [
    ("outer_diameter_mm", 1.0, 1000.0),
    ("wall_mm", 0.02, 100.0),
    ("length_mm", 3.0, 30_000.0),
    ("angle_deg", 1.6, 90.0),
    ("pressure_mpa", 0.0, 1.0),
    ("pressures_mpa", 0.0, 1.0),
    ("max_pressure_mpa", 0.0, 1.0),
];

/// A request of a command with the files that it names; the caller is warned of numbers that were
/// likely meant in another unit.
#[pyfunction]
#[pyo3(name = "given", signature = (command, request: "object") -> "dict[str, typing.Any]")]
pub fn stated_request<'py>(
    py: Python<'py>,
    command: &str,
    request: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    value::answer(py, &given(py, command, request)?)
}

/// The same as the crates have it.
pub fn given(py: Python<'_>, command: &str, object: &Bound<'_, PyAny>) -> PyResult<Value> {
    let mut request = value::request(object)?;
    let root = find(command).map_err(Wrong::from)?.request_schema();
    let mut reading = Reading { root, said: vec![] };
    reading
        .fields("", root, &mut request)
        .map_err(Wrong::from)?;
    value::warn(py, &reading.said)?;
    Ok(request)
}

/// What a text of a field says, in the unit inside. A number that has a unit must state it.
pub fn of_text<T, E: Display>(
    name: &str,
    text: &str,
    wrong: ProblemKind,
    parse: impl Fn(&str, Dimension) -> Result<T, E>,
) -> PyResult<T> {
    let read = || {
        let no_text = || Problem::new(ProblemKind::Quantity, "a plain number is no text", "");
        let kind = dimension(name).ok_or_else(no_text)?;
        stated(text, kind)?;
        parse(text, kind).map_err(|e| Problem::new(wrong, e.to_string(), ""))
    };
    Ok(read().map_err(|problem| Wrong::from(problem.in_field(name)))?)
}

fn stated(text: &str, kind: Dimension) -> Result<(), Problem> {
    let digits = |part: &str| part.trim().parse::<f64>().is_ok();
    let bare = !text.is_empty()
        && text
            .split([',', ':', ' '])
            .flat_map(|part| part.split(".."))
            .all(digits);
    if kind == Dimension::Ratio || !bare {
        return Ok(());
    }
    Err(Problem::new(
        ProblemKind::Quantity,
        format!("\"{text}\" has no unit"),
        format!("expected {}", kind.expectation()),
    ))
}

/// What is said of a bare number that was likely meant in another unit.
#[pyfunction]
pub fn unlikely(name: &str, number: f64) -> Option<String> {
    let (value, (_, low, high)) = (number, *LIKELY.iter().find(|row| row.0 == name)?);
    if value <= 0.0 || !value.is_finite() || (low..=high).contains(&value) {
        return None;
    }
    let (unit, other, factor) = match name.rsplit('_').next()? {
        "deg" => ("deg", "rad", 180.0 / std::f64::consts::PI),
        "mpa" if value >= 1e4 => ("MPa", "Pa", 1e-6),
        "mpa" if value >= 50.0 => ("MPa", "kPa", 1e-3),
        "mpa" => ("MPa", "bar", 0.1),
        _ if value < low => ("mm", "m", 1e3),
        _ => ("mm", "um", 1e-3),
    };
    let meant = mckibben_core::units::short_numbers(&format!("{}", value * factor)).into_owned();
    Some(format!(
        "{name}={value} is {value} {unit}; if {value} {other} is meant, give {meant}, or \"{value} \
         {other}\"; \"{value} {unit}\" says that it is meant"
    ))
}

/// A request that is read along its schema.
struct Reading<'a> {
    root: &'a Value,
    said: Vec<String>,
}

impl<'a> Reading<'a> {
    /// A schema without its reference, and the name of that.
    fn resolved(&self, schema: &'a Value) -> (&'a Value, &'a str) {
        let options = schema["anyOf"].as_array().into_iter().flatten();
        std::iter::once(schema)
            .chain(options)
            .find_map(|part| part["$ref"].as_str())
            .and_then(|path| path.rsplit('/').next())
            .map_or((schema, ""), |name| (&self.root["$defs"][name], name))
    }

    fn value(&mut self, name: &str, schema: &'a Value, value: &mut Value) -> Result<(), Problem> {
        let (fields, kind) = self.resolved(schema);
        let items = &schema["items"];
        match value {
            Value::Array(list) => list
                .iter_mut()
                .try_for_each(|item| self.value(name, items, item)),
            Value::Null | Value::Bool(_) => Ok(()),
            // Lists of quantities take one by themselves, lists of such lists do not.
            one if items.is_object()
                && (schema["x-quantity"].is_null() || items["items"].is_object()) =>
            {
                *one = json!([one.take()]);
                self.value(name, schema, one)
            }
            Value::Object(_) => self.fields(name, fields, value),
            Value::Number(number) => {
                self.said
                    .extend(number.as_f64().and_then(|number| unlikely(name, number)));
                Ok(())
            }
            Value::String(text) => {
                if let Some(read) = read(name, kind, text)? {
                    *value = read;
                }
                Ok(())
            }
        }
    }

    fn fields(&mut self, of: &str, schema: &'a Value, request: &mut Value) -> Result<(), Problem> {
        for (field, value) in request.as_object_mut().into_iter().flatten() {
            // The ends of an interval are quantities of its field; a muscle goes by its file, a model
            // by its name.
            let name = match &**field {
                "low" | "high" | "file" | "name" if !of.is_empty() => of,
                field => field,
            };
            self.value(name, &schema["properties"][field], value)
                .map_err(|problem| match problem.field {
                    None => problem.in_field(name),
                    Some(_) => problem,
                })?;
        }
        Ok(())
    }
}

/// What a text stands for: the file of a path, or a number; none where it stays.
fn read(name: &str, kind: &str, text: &str) -> Result<Option<Value>, Problem> {
    let path = Path::new(text.trim());
    let is = |end: &str| {
        path.extension()
            .is_some_and(|of| of.eq_ignore_ascii_case(end))
    };
    Ok(match kind {
        "TextFile" => Some(json!(TextFile::of_field(name, path)?)),
        "MuscleFields" => Some(json!({ "file": TextFile::muscle(path)? })),
        "ModelFields" if is("json") => Some(json!({ "name": TextFile::formula(path)? })),
        "NameOrFile" if is("json") => Some(json!(TextFile::formula(path)?)),
        "NameOrFile" if is("toml") => Some(json!(TextFile::read(path)?)),
        _ => {
            let Some(kind) = dimension(name) else {
                return Ok(None);
            };
            stated(text, kind)?;
            parse_quantity(text, kind).ok().map(Value::from)
        }
    })
}

/// The kind of quantity that a name carries, where a text may stand in its place.
fn dimension(name: &str) -> Option<Dimension> {
    NamedUnit::of_field(name)?.dimension
}
