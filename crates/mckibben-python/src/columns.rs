//! Answers whose points are columns of numbers.

use crate::error::Wrong;
use crate::{run, value};
use mckibben::progress::Progress;
use mckibben_app::{AnswerColumns, Column, Problem, RequestFields, curve_columns, plan_columns, understood};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// A family of curves: what is said of all of it, and its points as columns.
#[pyfunction]
#[pyo3(signature = (request: "dict[str, typing.Any]", progress: "collections.abc.Callable[[int, int], object] | None" = None) -> "tuple[dict[str, typing.Any], dict[str, typing.Any]]")]
pub fn curve<'py>(
    py: Python<'py>,
    request: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyDict>)> {
    columns(py, request, progress, curve_columns)
}

/// A plan that was computed: what is said of all of it, and its points as columns.
#[pyfunction]
#[pyo3(signature = (request: "dict[str, typing.Any]", progress: "collections.abc.Callable[[int, int], object] | None" = None) -> "tuple[dict[str, typing.Any], dict[str, typing.Any]]")]
pub fn plan<'py>(
    py: Python<'py>,
    request: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyDict>)> {
    columns(py, request, progress, plan_columns)
}

fn columns<'py, R: RequestFields>(
    py: Python<'py>,
    request: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
    answer: fn(&R, &dyn Progress) -> Result<AnswerColumns, Problem>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyDict>)> {
    let request = value::request(request)?;
    let AnswerColumns { head, columns } = run::long(py, progress, |progress| {
        let request: R = understood(request)?;
        Ok::<_, Wrong>(answer(&request, progress)?)
    })?;
    let out = PyDict::new(py);
    for (name, column) in columns {
        match column {
            Column::Numbers(list) => out.set_item(name, list.into_pyarray(py))?,
            Column::Truths(list) => out.set_item(name, list.into_pyarray(py))?,
            Column::Texts(list) => out.set_item(name, PyList::new(py, list)?)?,
        }
    }
    Ok((value::answer(py, &head)?, out))
}
