//! Work on requests: its turn, its end.

use crate::refusal::Refusal;
use crate::room::Held;
use axum::http::StatusCode;
use mckibben::cancel::Cancel;
use mckibben::progress::Progress;
use mckibben_app::{CommandEntry, Problem, ProblemKind, Ready, parsed};
use std::sync::Arc;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};

/// A bounded queue: so many at work, so many waiting, no more.
#[derive(Debug)]
pub struct Gate {
    places: Arc<Semaphore>,
    turns: Arc<Semaphore>,
}

/// A place in the queue.
#[derive(Debug)]
pub struct QueueSlot {
    turns: Arc<Semaphore>,
    held: Vec<OwnedSemaphorePermit>,
}

impl Gate {
    pub fn new(workers: usize, waiting: usize) -> Self {
        let workers = workers.max(1);
        let places = Arc::new(Semaphore::new(workers.saturating_add(waiting).min(Semaphore::MAX_PERMITS)));
        Self { places, turns: Arc::new(Semaphore::new(workers)) }
    }

    /// A place, where there is one.
    pub fn enter(&self) -> Result<QueueSlot, Refusal> {
        let place = Arc::clone(&self.places).try_acquire_owned();
        let place = place.map_err(|_| Refusal::busy("too many requests are waiting"))?;
        Ok(QueueSlot { turns: Arc::clone(&self.turns), held: vec![place] })
    }
}

impl QueueSlot {
    /// Waits for the turn; who drops the place leaves the queue.
    pub async fn turn(&mut self) -> Result<(), Refusal> {
        let turn = Arc::clone(&self.turns).acquire_owned().await.map_err(|_| Refusal::ending())?;
        self.held.push(turn);
        Ok(())
    }
}

/// The work ends with its caller: a client that left, a job that was cancelled.
struct EndsWith(Cancel);

impl Drop for EndsWith {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// Reported progress.
struct Reported<R>(R);

impl<R: Fn(usize, usize) + Sync> Progress for Reported<R> {
    fn report(&self, done: usize, total: usize) {
        (self.0)(done, total);
    }
}

/// The text of a request to a command, with its share of the memory.
#[derive(Debug)]
pub struct Asked {
    pub command: &'static CommandEntry,
    pub text: String,
    pub held: Held,
}

/// A request that was read: once, and within its share of the memory.
#[derive(Debug)]
pub struct Question {
    pub command: &'static CommandEntry,
    pub request: Ready,
    /// Given back when the answer is made.
    _held: Held,
}

impl Asked {
    /// The request, where it is one at all, and none that touches the disk.
    pub fn read(self) -> Result<Question, Refusal> {
        let no_request =
            |problem: Problem| Refusal { status: StatusCode::BAD_REQUEST, problem: Box::new(problem) };
        let request = parsed(&self.text).map_err(no_request)?;
        if self.command.touches_disk(&request) {
            let hint =
                format!("on the command line it is `mckibben {}`", self.command.name.replace('-', " "));
            return Err(Refusal::new(StatusCode::FORBIDDEN, "the server touches no files", hint));
        }
        let request = self.command.read(request)?;
        Ok(Question { command: self.command, request, _held: self.held })
    }
}

/// Work on a thread of its own in its turn; ended when this future is dropped or the server ends.
pub async fn worked<T: Send + 'static>(
    mut place: QueueSlot,
    mut stopping: watch::Receiver<bool>,
    report: impl Fn(usize, usize) + Send + Sync + 'static,
    work: impl FnOnce(&dyn Progress) -> Result<T, Refusal> + Send + 'static,
) -> Result<T, Refusal> {
    tokio::select! {
        turn = place.turn() => turn?,
        Ok(_) = stopping.wait_for(|s| *s) => return Err(Refusal::ending()),
    }
    report(0, 0);
    let cancel = Cancel::default();
    let _ends = EndsWith(cancel.clone());
    let handle = tokio::task::spawn_blocking(move || {
        let _entered = cancel.enter();
        let done = work(&Reported(report));
        drop(place);
        match done {
            Err(refusal) if refusal.problem.kind == ProblemKind::Internal => Err(refusal),
            // What work says that was ended on its way is neither an answer nor a reason.
            done => cancel.check().map_err(|cancelled| Problem::from(cancelled).into()).and(done),
        }
    });
    tokio::select! {
        done = handle => done.unwrap_or_else(|e| Err(Problem::new(ProblemKind::Internal, e.to_string(), "").into())),
        Ok(_) = stopping.wait_for(|s| *s) => Err(Refusal::ending()),
    }
}

/// The answer to a question, as JSON or packed.
pub fn answer(question: Question, packed: bool, progress: &dyn Progress) -> Result<Vec<u8>, Refusal> {
    let answer = question.request.answer(progress)?;
    Ok(if packed { mckibben_app::packed(answer) } else { answer.to_string().into_bytes() })
}
