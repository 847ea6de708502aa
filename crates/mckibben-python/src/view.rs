//! The muscle in space, and reports, as pages in one piece.

use crate::{request, run};
use mckibben_app::{BuildRequest, Problem, ProblemKind, ShapeRequest, body, build, understood};
use pyo3::prelude::*;

/// A page of a request: of `shape` the deformed muscle, which turns under the mouse, of `build` all
/// that is known of a muscle.
#[pyfunction]
#[pyo3(signature = (command, request: "dict[str, typing.Any]", progress=None))]
pub fn page_html(
    py: Python<'_>,
    command: &str,
    request: &Bound<'_, PyAny>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    let request = request::given(py, command, request)?;
    run::long(py, progress, |progress| {
        let document = if command == "shape" {
            body(&understood::<ShapeRequest>(&request)?)?
        } else {
            let request: BuildRequest = understood(&request)?;
            build(&request, progress)?.document.unwrap_or_default()
        };
        document
            .to_html(&mckibben_web::viewer())
            .map_err(|e| Problem::new(ProblemKind::Plot, e.to_string(), "").into())
    })
}
