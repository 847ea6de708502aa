//! Texts with a unit in a request, as the numbers that its schema wants; and numbers that were
//! likely meant in another unit.

use crate::{error::Wrong, value};
use mckibben::units::{Dimension, NamedUnit, parse_quantity, parse_values};
use mckibben_app::{Choice, CommandEntry, Problem, ProblemKind, TextFile, find, measured_folder};
use pyo3::prelude::*;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Parts of an interval without a step.
const DIVISIONS: usize = 20;
/// Schemas of requests, once they were made.
static SCHEMAS: Mutex<BTreeMap<&str, Arc<Value>>> = Mutex::new(BTreeMap::new());
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

/// A request of a command with numbers for its texts and with the files that it names; the caller
/// is warned of numbers that were likely meant in another unit.
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
    let said = find(command)
        .and_then(|entry| read(entry, &mut request))
        .map_err(Wrong::from)?;
    value::warn(py, &said)?;
    Ok(request)
}

/// Numbers for texts, in place. What is said of numbers that were likely meant in another unit.
fn read(entry: &'static CommandEntry, request: &mut Value) -> Result<Vec<String>, Problem> {
    let known = || SCHEMAS.lock().unwrap_or_else(PoisonError::into_inner);
    let schema = known().get(entry.name).cloned();
    let schema = schema.unwrap_or_else(|| {
        let made = Arc::new(entry.schema()["request"].take());
        known().entry(entry.name).or_insert(made).clone()
    });
    let mut reading = Reading {
        root: &schema,
        said: vec![],
    };
    let Some(fields) = request.as_object_mut() else {
        return Ok(vec![]);
    };
    for (name, value) in fields {
        reading
            .value(name, &schema["properties"][name], value)
            .map_err(|problem| match problem.field {
                None => problem.in_field(name.clone()),
                Some(_) => problem,
            })?;
    }
    Ok(reading.said)
}

/// A text such as `2.5 bar` in the unit inside. A number that has a unit must say it.
pub fn quantity(text: &str, kind: Dimension) -> Result<f64, Problem> {
    stated(text, kind)?;
    parse_quantity(text, kind).map_err(|e| Problem::new(ProblemKind::Quantity, e.to_string(), ""))
}

/// A text such as `0..2.5:0.5 bar` as numbers.
pub fn quantities(text: &str, kind: Dimension) -> Result<Vec<f64>, Problem> {
    Ok(several(text, kind)?.sampled(DIVISIONS))
}

fn several(text: &str, kind: Dimension) -> Result<mckibben::units::Values, Problem> {
    stated(text, kind)?;
    parse_values(text, kind).map_err(|e| Problem::new(ProblemKind::Range, e.to_string(), ""))
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
    let hint = format!("expected {}", kind.expectation());
    Err(Problem::new(
        ProblemKind::Quantity,
        format!("\"{text}\" has no unit"),
        hint,
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
    let meant = mckibben::units::short_numbers(&format!("{}", value * factor)).into_owned();
    Some(format!(
        "{name}={value} is {value} {unit}; if {value} {other} is meant, give {meant}, or \"{value} \
         {other}\"; \"{value} {unit}\" says that it is meant"
    ))
}

/// A request that is read by its schema.
struct Reading<'a> {
    root: &'a Value,
    said: Vec<String>,
}

impl<'a> Reading<'a> {
    /// A schema without its reference, and the name of that.
    fn resolved(&self, node: &'a Value) -> (&'a Value, &'a str) {
        let options = node["anyOf"].as_array().into_iter().flatten();
        let reference = std::iter::once(node)
            .chain(options)
            .find_map(|part| part["$ref"].as_str());
        let name = reference
            .and_then(|path| path.rsplit('/').next())
            .unwrap_or_default();
        if name.is_empty() {
            (node, name)
        } else {
            (&self.root["$defs"][name], name)
        }
    }

    fn value(&mut self, name: &str, node: &'a Value, value: &mut Value) -> Result<(), Problem> {
        let kind: Option<Dimension> = serde_json::from_value(node["x-quantity"].clone()).ok();
        let (target, of) = self.resolved(node);
        let is_list = node["type"] == "array" || node["type"][0] == "array";
        let file = if is_list {
            self.resolved(&node["items"]).1
        } else {
            of
        };
        if ["TextFile", "MeasuredFolder"].contains(&file) {
            if is_list && !value.is_array() {
                *value = json!([value.take()]);
            }
            let files = if let Value::Array(list) = value {
                list
            } else {
                std::slice::from_mut(value)
            };
            return files.iter_mut().try_for_each(|value| {
                match value.as_str().map(Path::new) {
                    Some(path) if file == "TextFile" => {
                        *value = json!(TextFile::of_field(name, path)?)
                    }
                    Some(path) => *value = json!(measured_folder(path)?),
                    None => {}
                }
                Ok(())
            });
        }
        match (value, kind) {
            (value @ Value::String(_), Some(kind)) => {
                let text = value.as_str().unwrap_or_default();
                *value = match of {
                    "Choice" => json!(Choice::from(several(text, kind)?)),
                    "Stiffness" if ["paper", "inextensible"].contains(&text.trim()) => {
                        json!(text.trim())
                    }
                    _ if is_list => json!(quantities(text, kind)?),
                    _ => json!(quantity(text, kind)?),
                };
            }
            (value @ Value::Number(_), _) => {
                self.said
                    .extend(value.as_f64().and_then(|number| unlikely(name, number)));
                if is_list {
                    *value = json!([value.take()]);
                }
            }
            (value @ (Value::Array(_) | Value::Object(_)), Some(kind)) => {
                self.item(name, kind, value)?
            }
            (Value::Array(list), None) => {
                let items = self.resolved(&target["items"]).0;
                list.iter_mut()
                    .try_for_each(|item| self.fields(items, item))?;
            }
            (value @ Value::Object(_), None) => self.fields(target, value)?,
            _ => {}
        }
        Ok(())
    }

    fn fields(&mut self, node: &'a Value, value: &mut Value) -> Result<(), Problem> {
        value
            .as_object_mut()
            .into_iter()
            .flatten()
            .try_for_each(|(name, value)| {
                self.value(name, &node["properties"][name], value)
                    .map_err(|problem| problem.in_field(name))
            })
    }

    fn item(&mut self, name: &str, kind: Dimension, value: &mut Value) -> Result<(), Problem> {
        match value {
            Value::String(text) => *value = json!(quantity(text, kind)?),
            Value::Number(number) => {
                self.said
                    .extend(number.as_f64().and_then(|number| unlikely(name, number)));
            }
            Value::Array(list) => list
                .iter_mut()
                .try_for_each(|item| self.item(name, kind, item))?,
            Value::Object(map) => map
                .values_mut()
                .try_for_each(|end| self.item(name, kind, end))?,
            _ => {}
        }
        Ok(())
    }
}

/// The kind of quantity that a name carries, where a text may stand in its place.
pub fn kind_of(name: &str) -> Result<Dimension, Problem> {
    NamedUnit::of_field(name)
        .and_then(|of| of.dimension)
        .ok_or_else(|| {
            Problem::new(ProblemKind::Quantity, "a plain number is no text", "").in_field(name)
        })
}
