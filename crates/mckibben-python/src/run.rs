//! Work with the interpreter released.
//!
//! Work that may take long runs on a separate thread, while the calling thread waits: it sees
//! signals (Ctrl-C) and calls the caller's progress function, which only the calling thread may do.
//! Either may raise, and then the work is cancelled, is waited for, and what was raised is what the
//! call ends with.

use crate::error::Wrong;
use mckibben_app::{Problem, ProblemKind, within};
use mckibben_core::{cancel::Cancel, progress::Progress};
use pyo3::prelude::*;
use std::{
    sync::{
        atomic::{AtomicUsize, Ordering},
        mpsc::{RecvTimeoutError, sync_channel},
    },
    thread,
    time::Duration,
};

/// How often the calling thread looks at signals and progress.
const TICK: Duration = Duration::from_millis(50);
/// After so many ticks without a word work is one step.
const SILENT: usize = 20;
/// Stack of the thread that works: as much as that of a program usually.
const STACK_BYTES: usize = 8 << 20;

/// What the work tells, and the wish to end it.
#[derive(Default)]
struct Watched {
    cancel: Cancel,
    done: AtomicUsize,
    total: AtomicUsize,
}

impl Progress for Watched {
    fn report(&self, done: usize, total: usize) {
        // Parts of the work may tell of themselves.
        self.done.fetch_max(done, Ordering::Relaxed);
        self.total.fetch_max(total, Ordering::Relaxed);
    }
}

/// Work of a moment.
pub fn quick<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&dyn Progress) -> Result<T, Wrong> + Send,
) -> PyResult<T> {
    let watched = Watched::default();
    Ok(py.detach(|| within(&watched.cancel, || work(&watched)))?)
}

/// Work that may take long. `progress(done, total)` is called now and then, and once at the end with
/// all done.
pub fn long<T: Send>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&dyn Progress) -> Result<T, Wrong> + Send,
) -> PyResult<T> {
    let watched = Watched::default();
    let progress: Option<Py<PyAny>> = progress.map(|p| p.clone().unbind());
    let done: Result<T, Wrong> = py.detach(|| {
        thread::scope(|scope| {
            let (sender, receiver) = sync_channel(1);
            let at_work = || within(&watched.cancel, || work(&watched));
            let body = move || drop(sender.send(at_work()));
            let started = thread::Builder::new()
                .stack_size(STACK_BYTES)
                .spawn_scoped(scope, body);
            if let Err(error) = started {
                return Err(Problem::new(
                    ProblemKind::Internal,
                    format!("cannot start a thread: {error}"),
                    "end other programs",
                )
                .into());
            }
            let mut raised = None;
            let mut reported = (0, 0);
            let mut ticks = 0;
            let done = loop {
                match receiver.recv_timeout(TICK) {
                    Ok(done) => break done,
                    Err(RecvTimeoutError::Timeout) => {
                        ticks += 1;
                        if ticks == SILENT {
                            watched.report(0, 1);
                        }
                        let heard = Python::attach(|py| {
                            listen(py, &watched, progress.as_ref(), &mut reported)
                        });
                        if let Err(error) = heard {
                            watched.cancel.cancel();
                            raised.get_or_insert(error);
                        }
                    }
                    Err(RecvTimeoutError::Disconnected) => {
                        break Err(Problem::new(
                            ProblemKind::Internal,
                            "the work ended without an answer",
                            "",
                        )
                        .into());
                    }
                }
            };
            if let Some(error) = raised {
                return Err(error.into());
            }
            if done.is_ok() {
                let all = watched.total.load(Ordering::Relaxed).max(1);
                watched.report(all, all);
            }
            Python::attach(|py| listen(py, &watched, progress.as_ref(), &mut reported))?;
            done
        })
    });
    Ok(done?)
}

/// Signals, then the caller's function where there is news.
fn listen(
    py: Python<'_>,
    watched: &Watched,
    progress: Option<&Py<PyAny>>,
    reported: &mut (usize, usize),
) -> PyResult<()> {
    py.check_signals()?;
    let Some(progress) = progress else {
        return Ok(());
    };
    let now = (
        watched.done.load(Ordering::Relaxed),
        watched.total.load(Ordering::Relaxed),
    );
    if now != *reported {
        *reported = now;
        progress.call1(py, now)?;
    }
    Ok(())
}
