//! A model bound to its muscle, evaluated for arrays.

use crate::{error::Wrong, run, value};
use mckibben_app::{BoundModel, Many, Problem};
use mckibben_core::{progress::Progress, units::named};
use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;
use serde_json::json;

/// A model bound to its muscle.
#[pyclass(frozen, module = "mckibben._native")]
pub struct Model {
    pub bound: BoundModel,
}

#[pymethods]
impl Model {
    /// The model's name.
    #[getter]
    fn name(&self) -> &str {
        &self.bound.info().name
    }

    /// Whether a point takes finite elements.
    #[getter]
    fn is_elements(&self) -> bool {
        self.bound.is_elements()
    }

    /// Lowest and highest pressure in MPa of the model, at most the allowed one, and contraction.
    fn bounds(&self, py: Python<'_>) -> PyResult<[(f64, f64); 2]> {
        let allowed = run::quick(py, |_| Ok(self.bound.limits()?))?
            .allowed_pressure_mpa
            .unwrap_or(f64::INFINITY);
        let range = &self.bound.info().range;
        let (low, high) = range.pressure_mpa;
        let (least, most) = range.contraction;
        // A contraction of 1 is none.
        Ok([
            (low, high.min(allowed)),
            (least, most.min(1.0_f64.next_down())),
        ])
    }

    /// All that is known of each point, or why it has no answer.
    #[pyo3(signature = (pressures, contractions, nan, progress=None) -> "list[dict[str, typing.Any]]")]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        pressures: Vec<f64>,
        contractions: Vec<f64>,
        nan: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let points = Vec::from_iter(pressures.into_iter().zip(contractions));
        let work = |progress: &dyn Progress| {
            let answers = self.bound.answers(&points, progress)?.into_iter();
            let row = |(index, answer)| match answer {
                Ok(answer) => Ok(json!(answer)),
                Err(Problem { kind, message, .. }) if nan => {
                    Ok(json!({ "status": kind, "cause": message }))
                }
                Err(problem) => Err(Wrong::Problem(problem, Some(index))),
            };
            Ok(json!(
                answers
                    .enumerate()
                    .map(row)
                    .collect::<Result<Vec<_>, _>>()?
            ))
        };
        value::answer(py, &self.work(py, points.len(), progress, work)?)
    }

    /// Answers every pair of two lists into `out`, with slopes all numbers of a point one after the
    /// other. Points without an answer are NaN where `nan` is true, else the first one raises.
    /// Returns what is to be said of the points, where `warnings` is true.
    #[pyo3(signature = (wanted, first: "Array", second: "Array", out: "Array", slopes, parameters, nan, warnings=false, progress=None))]
    #[expect(clippy::too_many_arguments, reason = "called by the package alone")]
    fn fill(
        &self,
        py: Python<'_>,
        wanted: &str,
        first: PyReadonlyArray1<'_, f64>,
        second: PyReadonlyArray1<'_, f64>,
        mut out: PyReadwriteArray1<'_, f64>,
        slopes: bool,
        parameters: Vec<String>,
        nan: bool,
        warnings: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Vec<String>> {
        let parameters = parameters
            .iter()
            .map(|name| self.bound.parameter(name))
            .collect::<Result<_, _>>()
            .map_err(Wrong::from)?;
        let many = Many {
            wanted: named(wanted).unwrap_or_default(),
            slopes,
            parameters,
            nan,
            warnings,
        };
        self.answer(
            py,
            [first.as_slice()?, second.as_slice()?],
            &many,
            out.as_slice_mut()?,
            progress,
        )
    }

    /// The answer to one pair of numbers, NaN where it has none and `nan` is true, and what is to
    /// be said of it.
    fn answer_pair(
        &self,
        py: Python<'_>,
        wanted: &str,
        first: f64,
        second: f64,
        nan: bool,
    ) -> PyResult<(f64, Vec<String>)> {
        let many = Many {
            wanted: named(wanted).unwrap_or_default(),
            nan,
            warnings: true,
            ..Many::default()
        };
        let mut place = [f64::NAN];
        let said = self.answer(py, [&[first], &[second]], &many, &mut place, None)?;
        Ok((place[0], said))
    }
}

impl Model {
    /// Answers pairs into their places; what is to be said of them.
    fn answer(
        &self,
        py: Python<'_>,
        pairs: [&[f64]; 2],
        many: &Many,
        places: &mut [f64],
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Vec<String>> {
        let numbers = places.len();
        let work = |progress: &dyn Progress| Ok(self.bound.fill(pairs, many, places, progress)?);
        Ok(self
            .work(py, numbers, progress, work)?
            .iter()
            .map(|warning| warning.to_string().replace('\u{a0}', " "))
            .collect())
    }

    /// Work on so many numbers, on a thread of its own where it may take long.
    fn work<T: Send>(
        &self,
        py: Python<'_>,
        numbers: usize,
        progress: Option<&Bound<'_, PyAny>>,
        work: impl FnOnce(&dyn Progress) -> Result<T, Wrong> + Send,
    ) -> PyResult<T> {
        if progress.is_none() && self.bound.is_moment(numbers) {
            run::quick(py, work)
        } else {
            run::long(py, progress, work)
        }
    }
}
