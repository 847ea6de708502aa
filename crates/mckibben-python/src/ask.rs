//! Every command by name, and quantities as users write them.

use crate::{error::Wrong, run, value};
use mckibben::units::{Dimension, NamedUnit, Values, parse_quantity, parse_values};
use mckibben_app::{Choice, Problem, ProblemKind, ask_value, bundle, find};
use pyo3::prelude::*;
use serde_json::{Value, json};

/// Parts of an interval without a step.
const DIVISIONS: usize = 20;

/// The answer to a request.
///
/// `progress(done, total)` is called now and then.
#[pyfunction]
#[pyo3(signature = (command: "str", request: "dict[str, typing.Any]", progress: "collections.abc.Callable[[int, int], object] | None" = None) -> "dict[str, typing.Any]")]
pub fn ask<'py>(
    py: Python<'py>,
    command: &str,
    request: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let entry = find(command).map_err(Wrong::from)?;
    let request = value::request(request)?;
    let work = |progress: &dyn mckibben::progress::Progress| Ok(ask_value(entry.name, request, progress)?);
    value::answer(py, &run::long(py, progress, work)?)
}

/// Request, answer and error of every command as JSON Schema, and in `$defs` what they refer to.
#[pyfunction]
#[pyo3(signature = () -> "dict[str, typing.Any]")]
pub fn schema(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    value::answer(py, &bundle())
}

fn kind(word: &str) -> Result<Dimension, Wrong> {
    serde_json::from_value(Value::String(word.into()))
        .map_err(|e| Problem::new(ProblemKind::Usage, e.to_string(), "").in_field("kind").into())
}

/// A text such as `2.5 bar` as a number in mm, MPa, N, degrees, or the unit inside of its kind.
#[pyfunction]
#[pyo3(signature = (text, kind, field = None))]
pub fn quantity(text: &str, kind: &str, field: Option<&str>) -> PyResult<f64> {
    Ok(parse_quantity(text, self::kind(kind)?).map_err(|e| wrong(ProblemKind::Quantity, e, field))?)
}

/// What a field of a name measures, where a text with a unit may stand in its place, and the unit of its numbers; none for plain numbers.
#[pyfunction]
#[pyo3(signature = (name: "str") -> "tuple[str | None, str] | None")]
pub fn unit_of(name: &str) -> Option<(Option<String>, &'static str)> {
    let NamedUnit { unit, dimension } = NamedUnit::of_field(name)?;
    let word = |d: Dimension| json!(d).as_str().map(str::to_owned);
    Some((dimension.and_then(word), unit))
}

/// A text such as `0..2.5:0.5bar` or `1,2,3 bar` as numbers; an interval without a step is cut into 20 parts.
#[pyfunction]
#[pyo3(signature = (text, kind, field = None))]
pub fn values(text: &str, kind: &str, field: Option<&str>) -> PyResult<Vec<f64>> {
    Ok(parsed(text, kind, field)?.sampled(DIVISIONS))
}

/// A text such as `30..50 mm` as the values that a design searches through: one, several, or all between two.
#[pyfunction]
#[pyo3(signature = (text: "str", kind: "str", field: "str | None" = None) -> "typing.Any")]
pub fn choice<'py>(
    py: Python<'py>,
    text: &str,
    kind: &str,
    field: Option<&str>,
) -> PyResult<Bound<'py, PyAny>> {
    value::answer(py, &json!(Choice::from(parsed(text, kind, field)?)))
}

fn parsed(text: &str, kind: &str, field: Option<&str>) -> Result<Values, Wrong> {
    parse_values(text, self::kind(kind)?).map_err(|e| wrong(ProblemKind::Range, e, field))
}

fn wrong(kind: ProblemKind, error: impl ToString, field: Option<&str>) -> Wrong {
    let problem = Problem::new(kind, error.to_string(), "");
    Problem { field: field.map(str::to_owned), ..problem }.into()
}
