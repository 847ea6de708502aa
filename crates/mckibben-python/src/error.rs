//! What is wrong, as the exceptions of the package.

use crate::value;
use mckibben_app::{ArrayError, Problem};
use mckibben_core::joined;
use pyo3::{exceptions::PyRuntimeError, prelude::*};
use serde_json::json;

/// Why a call has no answer: a problem of the application layer, of a point of a list where it is
/// one; or an exception of Python itself.
pub enum Wrong {
    /// With the place in the list.
    Problem(Problem, Option<usize>),
    /// Raised by Python: Ctrl-C, an exception in the caller's progress function.
    Raised(PyErr),
}

impl From<Problem> for Wrong {
    fn from(problem: Problem) -> Self {
        Self::Problem(problem, None)
    }
}

impl From<ArrayError> for Wrong {
    fn from(no: ArrayError) -> Self {
        Self::Problem(no.problem, no.index)
    }
}

impl From<PyErr> for Wrong {
    fn from(error: PyErr) -> Self {
        Self::Raised(error)
    }
}

impl From<Wrong> for PyErr {
    fn from(wrong: Wrong) -> Self {
        match wrong {
            Wrong::Raised(error) => error,
            Wrong::Problem(problem, index) => {
                let text = problem.to_string();
                Python::attach(|py| {
                    raised(py, &problem, index).unwrap_or_else(|_| PyRuntimeError::new_err(text))
                })
            }
        }
    }
}

/// The exception that `mckibben._errors.of` makes of it.
fn raised(py: Python<'_>, problem: &Problem, index: Option<usize>) -> PyResult<PyErr> {
    let nearest = problem.nearest.map(
        |at| json!({ "force_n": at.force_n, "pressure_mpa": at.pressure_mpa, "contraction": at.contraction }),
    );
    let values = json!({
        "kind": problem.kind, "message": joined(problem.messages(), "\n"), "hint": problem.hint, "field": problem.field,
        "index": index, "nearest": nearest,
    });
    let made = py
        .import("mckibben._errors")?
        .getattr("of")?
        .call1((value::answer(py, &values)?,))?;
    Ok(PyErr::from_value(made))
}
