//! Maps, lists and numbers of Python and of requests, from the one to the other by way of JSON's
//! text; and what is said to the caller.

use pyo3::{exceptions::PyValueError, prelude::*, types::PyDict};
use serde_json::Value;

/// Of maps with names, lists, texts and finite numbers; any other object is Python's `TypeError` or
/// `ValueError`.
pub fn request(object: &Bound<'_, PyAny>) -> PyResult<Value> {
    let finite = PyDict::new(object.py());
    finite.set_item("allow_nan", false)?;
    let text = object
        .py()
        .import("json")?
        .call_method("dumps", (object,), Some(&finite))?;
    serde_json::from_str(text.extract()?)
        .map_err(|e| PyValueError::new_err(format!("the request is not understood: {e}")))
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
