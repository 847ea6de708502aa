//! Every command by name, and quantities as users write them.

use crate::{request, run, value};
use mckibben_app::{ProblemKind, ask_value};
use mckibben_core::units::{NamedUnit, parse_quantity, parse_values};
use pyo3::prelude::*;

/// Parts of an interval without a step.
const DIVISIONS: usize = 20;

/// The answer to a request with numbers and the contents of files.
///
/// `progress(done, total)` is called now and then.
#[pyfunction]
#[pyo3(signature = (command: "str", request: "object", progress=None) -> "dict[str, typing.Any]")]
pub fn ask<'py>(
    py: Python<'py>,
    command: &str,
    request: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let request = value::request(request)?;
    let work = |progress: &dyn mckibben_core::progress::Progress| {
        Ok(ask_value(command, request, progress)?)
    };
    value::answer(py, &run::long(py, progress, work)?)
}

/// A text such as `2.5 bar` in the unit that a name carries.
#[pyfunction]
pub fn quantity(name: &str, text: &str) -> PyResult<f64> {
    request::of_text(name, text, ProblemKind::Quantity, parse_quantity)
}

/// A text such as `0..2.5:0.5 bar` or `1,2,3 bar` as numbers; an interval without a step is cut
/// into 20 parts.
#[pyfunction]
pub fn quantities(name: &str, text: &str) -> PyResult<Vec<f64>> {
    Ok(request::of_text(name, text, ProblemKind::Range, parse_values)?.sampled(DIVISIONS))
}

/// The unit of a name's numbers; none of plain ones.
#[pyfunction]
pub fn unit_of(name: &str) -> Option<&'static str> {
    NamedUnit::of_field(name)
        .map(|of| of.unit)
        .filter(|unit| !unit.is_empty())
}
