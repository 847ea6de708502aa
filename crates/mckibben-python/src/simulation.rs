//! A drive in a control loop.

use crate::{error::Wrong, request, run, value};
use mckibben_app::{MotionRequest, Problem, SimulatedDrive, understood};
use mckibben_core::{progress::CancelOnly, threads::Threads};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2, PyReadwriteArray1};
use pyo3::{exceptions::PyValueError, prelude::*};
use serde_json::json;
use std::sync::{
    Mutex, MutexGuard, PoisonError,
    atomic::{AtomicUsize, Ordering},
};

/// A drive that is stepped.
#[pyclass(frozen, module = "mckibben._native")]
pub struct Simulation {
    /// One step at a time: other threads wait.
    drive: Mutex<SimulatedDrive>,
    /// Whether every step is recorded, not the last one alone.
    records: bool,
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
    #[pyo3(signature = (request: "dict[str, typing.Any]", step_s, records))]
    fn new(
        py: Python<'_>,
        request: &Bound<'_, PyAny>,
        step_s: f64,
        records: bool,
    ) -> PyResult<Self> {
        let request = request::given(py, "motion", request)?;
        run::long(py, None, |progress| {
            let request: MotionRequest = understood(&request)?;
            Ok(Self {
                drive: Mutex::new(SimulatedDrive::new(&request, step_s, progress)?),
                records,
            })
        })
    }

    /// One step on, with a command for each of the drive's and a force in N or torque in N m from
    /// outside; what was recorded at its end.
    fn step(&self, py: Python<'_>, commands: Vec<f64>, outside: f64) -> PyResult<Vec<f64>> {
        run::quick(py, |progress| {
            let mut drive = self.drive();
            drive.step(&commands, outside, progress)?;
            if !self.records {
                drive.forget();
            }
            Ok(last(&drive))
        })
    }

    /// Back to the start.
    fn reset(&self, py: Python<'_>) -> PyResult<Vec<f64>> {
        run::quick(py, |progress| {
            let mut drive = self.drive();
            drive.reset(progress)?;
            Ok(last(&drive))
        })
    }

    /// Another one in the same state.
    fn copy(&self, py: Python<'_>) -> Self {
        py.detach(|| Self {
            drive: Mutex::new(self.drive().duplicate()),
            records: self.records,
        })
    }

    /// Where it is, as numbers.
    #[pyo3(signature = () -> "Array")]
    fn numbers<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        py.detach(|| self.drive().numbers()).into_pyarray(py)
    }

    /// Goes to where a simulation of the same drive was, by its numbers.
    fn restore(&self, py: Python<'_>, numbers: Vec<f64>) -> PyResult<()> {
        run::quick(py, |progress| {
            Ok(self.drive().restore(&numbers, progress)?)
        })
    }

    /// What was recorded last, in the order of the names.
    fn last(&self, py: Python<'_>) -> Vec<f64> {
        py.detach(|| last(&self.drive()))
    }

    /// The names of the numbers that are recorded.
    #[getter]
    fn names(&self, py: Python<'_>) -> Vec<String> {
        py.detach(|| self.drive().series().names())
    }

    /// All that was recorded: a row for the start and for each step, one after the other.
    #[pyo3(signature = () -> "Array")]
    fn rows<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let rows = py.detach(|| {
            let drive = self.drive();
            let series = drive.series();
            let rows = (0..series.points()).filter_map(|i| series.row(i));
            rows.flatten().collect::<Vec<f64>>()
        });
        rows.into_pyarray(py)
    }

    /// The linear system about its rest at the first commands: A by its columns, B, and position per
    /// coordinate.
    fn linear(&self, py: Python<'_>) -> PyResult<Vec<f64>> {
        run::quick(py, |_| {
            let linear = self.drive().linear()?;
            let numbers = linear.a.iter().chain(&linear.b);
            Ok(numbers.chain([&linear.per_coordinate]).copied().collect())
        })
    }

    /// What happened: stops, slack, switching and reversals.
    #[pyo3(signature = () -> "list[dict[str, typing.Any]]")]
    fn events<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let events = py.detach(|| json!(self.drive().events()));
        value::answer(py, &events)
    }

    /// What is commanded (`pressure`, `opening` or `position`), how many commands there are, and
    /// whether a joint is moved.
    #[getter]
    fn commands(&self, py: Python<'_>) -> (&'static str, usize, bool) {
        py.detach(|| {
            let drive = self.drive();
            let (kind, count) = drive.commands();
            (kind, count, drive.is_joint())
        })
    }
}

/// Copies of a simulation, each with its own commands: a row of `commands` for each step of each
/// copy in turn, and into `out` what is recorded at the start and the end of each step. Copies run
/// side by side. Returns the first step that failed; from there on its copy is NaN.
#[pyfunction]
#[pyo3(signature = (simulation, steps, commands: "Array", out: "Array", nan, progress=None))]
pub fn rollout(
    py: Python<'_>,
    simulation: &Simulation,
    steps: usize,
    commands: PyReadonlyArray2<'_, f64>,
    mut out: PyReadwriteArray1<'_, f64>,
    nan: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<()> {
    let count = commands.as_array().ncols();
    let rows = commands.as_slice()?;
    let places = out.as_slice_mut()?;
    let width = py.detach(|| last(&simulation.drive()).len());
    let whole = (steps + 1) * width;
    if steps * count == 0 || rows.len() / (steps * count) * whole != places.len() {
        return Err(PyValueError::new_err("not as many places"));
    }
    let start = Mutex::new(py.detach(|| simulation.drive().duplicate()));
    run::long(py, progress, |progress| {
        let done = AtomicUsize::new(0);
        let total = places.len() / whole;
        let failed: Mutex<Option<(usize, Problem)>> = Mutex::new(None);
        Threads::shared().fill(places, whole, |place, part| {
            let copy = place / whole;
            let mut drive = start
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .duplicate();
            let own = rows.chunks_exact(count).skip(copy * steps);
            let mut ends = part.chunks_exact_mut(width);
            ends.next()
                .into_iter()
                .for_each(|end| end.copy_from_slice(&last(&drive)));
            for (step, (commands, end)) in own.zip(&mut ends).enumerate() {
                if let Err(problem) = drive.step(commands, 0.0, &CancelOnly(progress)) {
                    end.fill(f64::NAN);
                    ends.for_each(|end| end.fill(f64::NAN));
                    let mut failed = failed.lock().unwrap_or_else(PoisonError::into_inner);
                    let index = copy * steps + step;
                    if failed.as_ref().is_none_or(|(first, _)| *first > index) {
                        *failed = Some((index, problem));
                    }
                    break;
                }
                drive.forget();
                end.copy_from_slice(&last(&drive));
            }
            progress.report(done.fetch_add(1, Ordering::Relaxed) + 1, total);
        });
        progress.check().map_err(Problem::from)?;
        match failed.into_inner().unwrap_or_else(PoisonError::into_inner) {
            Some((index, problem)) if !nan => Err(Wrong::Problem(problem, Some(index))),
            _ => Ok(()),
        }
    })
}

fn last(drive: &SimulatedDrive) -> Vec<f64> {
    let series = drive.series();
    series
        .points()
        .checked_sub(1)
        .and_then(|i| series.row(i))
        .unwrap_or_default()
}
