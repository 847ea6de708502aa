//! Maps, lists and numbers of Python and of requests, from the one to the other.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use pyo3::{Borrowed, IntoPyObjectExt};
use serde_json::{Map, Number, Value};

/// Deeper than any request; a list that holds itself ends here.
const DEEPEST: usize = 32;

pub fn request(object: &Bound<'_, PyAny>) -> PyResult<Value> {
    from_python(object.as_borrowed(), DEEPEST)
}

fn from_python(object: Borrowed<'_, '_, PyAny>, deeper: usize) -> PyResult<Value> {
    let Some(deeper) = deeper.checked_sub(1) else {
        return Err(PyValueError::new_err("the request is nested too deep, or a list contains itself"));
    };
    if object.is_none() {
        return Ok(Value::Null);
    }
    if let Ok(text) = object.cast::<PyString>() {
        return Ok(Value::String(text.to_str()?.to_owned()));
    }
    if let Ok(yes) = object.cast::<PyBool>() {
        return Ok(Value::Bool(yes.is_true()));
    }
    if object.cast::<PyInt>().is_ok() {
        if let Ok(whole) = object.extract::<u64>() {
            return Ok(Value::from(whole));
        }
        if let Ok(whole) = object.extract::<i64>() {
            return Ok(Value::from(whole));
        }
    }
    if object.cast::<PyFloat>().is_ok() || object.cast::<PyInt>().is_ok() {
        return number(object.extract()?);
    }
    if let Ok(map) = object.cast::<PyDict>() {
        let mut out = Map::new();
        for (key, value) in map.iter() {
            let Ok(key) = key.cast::<PyString>() else {
                return Err(PyTypeError::new_err(format!("a key of a request is a str, not {}", kind(&key))));
            };
            out.insert(key.to_str()?.to_owned(), from_python(value.as_borrowed(), deeper)?);
        }
        return Ok(Value::Object(out));
    }
    if object.cast::<PyList>().is_ok() || object.cast::<PyTuple>().is_ok() {
        return object.try_iter()?.map(|item| from_python(item?.as_borrowed(), deeper)).collect();
    }
    Err(PyTypeError::new_err(format!("{} is not a part of a request", kind(&object))))
}

fn kind(object: &Bound<'_, PyAny>) -> String {
    object.get_type().name().map_or_else(|_| "this".into(), |name| format!("an object of type {name}"))
}

fn number(value: f64) -> PyResult<Value> {
    let number = Number::from_f64(value);
    number.map(Value::Number).ok_or_else(|| PyValueError::new_err(format!("{value} is not a finite number")))
}

pub fn answer<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    match value {
        Value::Null => Ok(py.None().into_bound(py)),
        Value::Bool(yes) => yes.into_bound_py_any(py),
        Value::Number(n) => match (n.as_u64(), n.as_i64()) {
            (Some(whole), _) => whole.into_bound_py_any(py),
            (_, Some(whole)) => whole.into_bound_py_any(py),
            _ => n.as_f64().into_bound_py_any(py),
        },
        Value::String(text) => text.into_bound_py_any(py),
        Value::Array(list) => {
            let out = PyList::empty(py);
            for value in list {
                out.append(answer(py, value)?)?;
            }
            Ok(out.into_any())
        }
        Value::Object(map) => {
            let out = PyDict::new(py);
            for (key, value) in map {
                out.set_item(key, answer(py, value)?)?;
            }
            Ok(out.into_any())
        }
    }
}
