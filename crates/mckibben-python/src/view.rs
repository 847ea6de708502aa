//! The muscle in space, and reports, as pages in one piece.

use crate::{error::Wrong, request, run};
use mckibben_app::{BuildRequest, Problem, ProblemKind, ShapeRequest, body, build, understood};
use mckibben_report::Document;
use pyo3::prelude::*;

fn page(document: &Document) -> Result<String, Wrong> {
    let html = document.to_html(&mckibben_web::viewer());
    html.map_err(|e| Problem::new(ProblemKind::Plot, e.to_string(), "").into())
}

/// A page with the deformed muscle, which turns under the mouse.
#[pyfunction]
#[pyo3(signature = (request: "dict[str, typing.Any]"))]
pub fn body_html(py: Python<'_>, request: &Bound<'_, PyAny>) -> PyResult<String> {
    let request = request::given(py, "shape", request)?;
    run::long(py, None, |_| {
        let request: ShapeRequest = understood(&request)?;
        page(&body(&request)?)
    })
}

/// A page with all that is known of a muscle.
#[pyfunction]
#[pyo3(signature = (request: "dict[str, typing.Any]", progress: "collections.abc.Callable[[int, \
    int], object] | None" = None))]
pub fn report_html(
    py: Python<'_>,
    request: &Bound<'_, PyAny>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let request = request::given(py, "build", request)?;
    run::long(py, progress, |progress| {
        let request: BuildRequest = understood(&request)?;
        page(&build(&request, progress)?.document.unwrap_or_default())
    })
}
