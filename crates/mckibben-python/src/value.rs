//! Maps, lists and numbers of Python and of requests, from the one to the other by way of JSON's
//! text; and what is said to the caller.

use crate::error::Wrong;
use mckibben_app::{Problem, ProblemKind};
use pyo3::{exceptions::PyValueError, prelude::*};
use serde_json::Value;

/// Of maps with names, lists, texts and finite numbers; any other object is Python's `TypeError` or
/// `ValueError`.
pub fn request(object: &Bound<'_, PyAny>) -> PyResult<Value> {
    let text = object
        .py()
        .import("json")?
        .call_method1("dumps", (object,))?;
    let text: &str = text.extract()?;
    serde_json::from_str(text).map_err(|e| {
        let (before, after) = text.split_at(e.column().saturating_sub(1).min(text.len()));
        // The name before it, in JSON that lets NaN and Infinity stand.
        match before.rsplit('"').nth(1) {
            Some(field) if after.starts_with(['N', 'I']) => Wrong::from(
                Problem::new(ProblemKind::Quantity, "is not a finite number", "").in_field(field),
            )
            .into(),
            _ => PyValueError::new_err(format!("the request is not understood: {e}")),
        }
    })
}

/// An answer, with plain spaces in the place of those that join a quantity of a sentence to its
/// unit.
pub fn answer<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?
        .call_method1("loads", (value.to_string().replace('\u{a0}', " "),))
}

/// Warns the caller of units, at the line that called the package.
pub fn warn(py: Python<'_>, said: &[String]) -> PyResult<()> {
    said.iter().try_for_each(|text| {
        py.import("mckibben._errors")?
            .call_method1("warned", (text,))
            .map(drop)
    })
}
