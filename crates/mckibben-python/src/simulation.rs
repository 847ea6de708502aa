//! A drive in a control loop.

use crate::{error::Wrong, run, value};
use mckibben_app::{MotionRequest, SimulatedDrive, understood};
use numpy::{IntoPyArray, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use serde_json::json;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A drive that is stepped.
#[pyclass(frozen, module = "mckibben._native")]
pub struct Simulation {
    /// One step at a time: other threads wait.
    drive: Mutex<SimulatedDrive>,
}

impl Simulation {
    fn drive(&self) -> MutexGuard<'_, SimulatedDrive> {
        self.drive.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[pymethods]
impl Simulation {
    /// The drive of a request of `motion`, with steps of a length in s.
    #[new]
    #[pyo3(signature = (request: "dict[str, typing.Any]", step_s))]
    fn new(py: Python<'_>, request: &Bound<'_, PyAny>, step_s: f64) -> PyResult<Self> {
        let request = value::request(request)?;
        Ok(run::long(py, None, |progress| {
            let request: MotionRequest = understood(&request)?;
            Ok(Self { drive: Mutex::new(SimulatedDrive::new(&request, step_s, progress)?) })
        })?)
    }

    /// One step on, with a command for each of the drive's and a force in N or torque in N m from outside; what was recorded at its end.
    fn step(&self, py: Python<'_>, commands: Vec<f64>, outside: f64) -> PyResult<Vec<f64>> {
        Ok(run::quick(py, |progress| {
            let mut drive = self.drive();
            drive.step(&commands, outside, progress)?;
            Ok::<_, Wrong>(last(&drive))
        })?)
    }

    /// Back to the start.
    fn reset(&self, py: Python<'_>) -> PyResult<Vec<f64>> {
        Ok(run::quick(py, |progress| {
            let mut drive = self.drive();
            drive.reset(progress)?;
            Ok::<_, Wrong>(last(&drive))
        })?)
    }

    /// Another one in the same state.
    fn copy(&self, py: Python<'_>) -> Self {
        py.detach(|| Self { drive: Mutex::new(self.drive().duplicate()) })
    }

    /// What was recorded last, in the order of the names.
    fn last(&self, py: Python<'_>) -> Vec<f64> {
        py.detach(|| last(&self.drive()))
    }

    /// The names of the numbers that are recorded.
    #[getter]
    fn names(&self, py: Python<'_>) -> Vec<String> {
        py.detach(|| self.drive().motion().series.names())
    }

    /// All that was recorded: a row for the start and for each step.
    #[pyo3(signature = () -> "numpy.typing.NDArray[numpy.float64]")]
    fn rows<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (rows, width) = py.detach(|| {
            let drive = self.drive();
            let series = &drive.motion().series;
            let rows: Vec<f64> = (0..series.points()).filter_map(|i| series.row(i)).flatten().collect();
            (rows, series.names().len())
        });
        let shape = [rows.len() / width.max(1), width];
        rows.into_pyarray(py).reshape(shape)
    }

    /// What happened: stops, slack, switching and reversals.
    #[pyo3(signature = () -> "list[dict[str, typing.Any]]")]
    fn events<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let events = py.detach(|| json!(self.drive().motion().events));
        value::answer(py, &events)
    }

    /// What is commanded (`pressure`, `opening` or `position`), how many commands there are, and whether a joint is moved.
    #[getter]
    fn commands(&self, py: Python<'_>) -> (&'static str, usize, bool) {
        py.detach(|| {
            let drive = self.drive();
            let (kind, count) = drive.commands();
            (kind, count, drive.is_joint())
        })
    }
}

fn last(drive: &SimulatedDrive) -> Vec<f64> {
    let series = &drive.motion().series;
    series.points().checked_sub(1).and_then(|i| series.row(i)).unwrap_or_default()
}
