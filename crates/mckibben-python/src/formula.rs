//! A fitted formula as a function of arrays, over muscles of any diameter and wall.

use crate::{error::Wrong, run};
use mckibben_app::{Problem, ProblemKind};
use mckibben_core::formula::{Document, Formula as Fitted};
use numpy::{PyReadonlyArray2, PyReadwriteArray1};
use pyo3::prelude::*;
use std::{f64::consts::PI, path::Path};

/// How far a point may be outside of the range by rounding.
const EDGE: f64 = 1e-12;
/// What rounding leaves of no pull, as a share of the pressure on the outer section.
const ROUNDING: f64 = 1e-9;

#[pyclass(frozen, module = "mckibben._native")]
pub struct Formula {
    formula: Fitted,
}

#[pymethods]
impl Formula {
    /// The formula of a file's text.
    #[new]
    fn new(name: String, text: &str) -> PyResult<Self> {
        let read = Document::parse(text)
            .map_err(|e| Wrong::from(Problem::from(e.in_file(Path::new(&name)))));
        match read? {
            Document::Section(formula) => Ok(Self { formula: *formula }),
            Document::Universal(_) => {
                let problem = Problem::usage(
                    "a universal formula needs the whole muscle",
                    "ask its model of a muscle",
                );
                Err(Wrong::from(problem).into())
            }
        }
    }

    /// Pulls in N at points: in each row pressure, contraction, wall and diameter. The first one
    /// outside of the range raises, unless this is not looked at; or it is NaN.
    #[pyo3(signature = (points: "Array", out: "Array", extrapolate, two_sided, nan))]
    fn fill(
        &self,
        py: Python<'_>,
        points: PyReadonlyArray2<'_, f64>,
        mut out: PyReadwriteArray1<'_, f64>,
        extrapolate: bool,
        two_sided: bool,
        nan: bool,
    ) -> PyResult<()> {
        let numbers = points.as_slice()?;
        let places = out.as_slice_mut()?;
        run::quick(py, |_| {
            let range = &self.formula.range;
            let (points, _) = numbers.as_chunks::<4>();
            for (index, (&[p, e, s, d], place)) in points.iter().zip(places).enumerate() {
                let outside = [
                    ("pressure_mpa", p, range.pressure_mpa),
                    ("contraction", e, range.contraction),
                    ("wall_mm", s, range.wall_mm),
                    ("outer_diameter_mm", d, range.outer_diameter_mm),
                ]
                .into_iter()
                .find(|(_, value, (low, high))| !(low - EDGE..=high + EDGE).contains(value));
                if let Some((field, value, (low, high))) = outside.filter(|_| !extrapolate) {
                    *place = f64::NAN;
                    if nan {
                        continue;
                    }
                    let message =
                        format!("{value} is outside of the formula's range, {low} to {high}");
                    let problem = Problem::new(
                        ProblemKind::OutOfRange,
                        message,
                        "extrapolate=True computes it all the same",
                    )
                    .in_field(field);
                    return Err(Wrong::Problem(problem, Some(index)));
                }
                let force = self.formula.force_n(d, s, p, e);
                let nothing = force.abs() <= ROUNDING * p * PI * 0.25 * d * d;
                *place = if nothing || (force < 0.0 && !two_sided) {
                    0.0
                } else {
                    force
                };
            }
            Ok(())
        })
    }
}
