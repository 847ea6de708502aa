//! Work on requests: its turn, its budget, its end.

use crate::refusal::Refusal;
use crate::room::Held;
use axum::http::StatusCode;
use mckibben::budget::{Budget, Exceeded, Limits, Resource};
use mckibben::progress::Progress;
use mckibben_app::{CommandEntry, JsonSize, Problem, ProblemKind, Ready, parsed};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};
use tokio::time::sleep;

/// Work has this long to see that its time is over.
const LATE: Duration = Duration::from_secs(2);

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
struct EndsWith(Budget);

impl Drop for EndsWith {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// Progress within a budget.
struct Within<R> {
    budget: Budget,
    report: R,
}

impl<R: Fn(usize, usize) + Sync> Progress for Within<R> {
    fn report(&self, done: usize, total: usize) {
        (self.report)(done, total);
    }

    fn cancelled(&self) -> bool {
        self.budget.check().is_err()
    }

    fn budget(&self) -> Budget {
        self.budget.clone()
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
    pub fn read(mut self, budget: &Budget) -> Result<Question, Refusal> {
        let no_request = |problem: Problem| {
            let status = match problem.kind {
                ProblemKind::Budget => StatusCode::PAYLOAD_TOO_LARGE,
                _ => StatusCode::BAD_REQUEST,
            };
            Refusal { status, problem: Box::new(problem) }
        };
        let size = JsonSize::of(&self.text).map_err(no_request)?;
        budget.admit(Resource::Bytes, size.bytes()).map_err(|e| no_request(e.into()))?;
        self.held.grow(size.bytes() as usize)?;
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
    limits: Limits,
    report: impl Fn(usize, usize) + Send + Sync + 'static,
    work: impl FnOnce(&dyn Progress) -> Result<T, Refusal> + Send + 'static,
) -> Result<T, Refusal> {
    tokio::select! {
        turn = place.turn() => turn?,
        Ok(_) = stopping.wait_for(|s| *s) => return Err(Refusal::ending()),
    }
    report(0, 0);
    let budget = Budget::new(limits);
    let _ends = EndsWith(budget.clone());
    let handle = tokio::task::spawn_blocking(move || {
        let done = work(&Within { budget: budget.clone(), report });
        drop(place);
        match (done, budget.exceeded()) {
            (Err(refusal), _) if refusal.problem.kind == ProblemKind::Internal => Err(refusal),
            // What work says that was ended on its way is neither an answer nor a reason.
            (_, Some(exceeded)) => Err(Problem::from(exceeded).into()),
            (done, None) => done,
        }
    });
    let late =
        limits.seconds.is_finite().then(|| Duration::from_secs_f64(limits.seconds.clamp(0.0, 1e9)) + LATE);
    tokio::select! {
        done = handle => done.unwrap_or_else(|e| Err(Problem::new(ProblemKind::Internal, e.to_string(), "").into())),
        Ok(_) = stopping.wait_for(|s| *s) => Err(Refusal::ending()),
        // Work that looks at no clock has its place until it ends, but nobody waits for it.
        () = sleep(late.unwrap_or_default()), if late.is_some() => {
            let spent = Exceeded::Spent { resource: Resource::Seconds, limit: limits.seconds };
            Err(Problem::from(spent).into())
        }
    }
}

/// The answer to a question, as JSON or packed.
pub fn answer(question: Question, packed: bool, progress: &dyn Progress) -> Result<Vec<u8>, Refusal> {
    let answer = question.request.answer(progress)?;
    Ok(if packed { mckibben_app::packed(answer) } else { answer.to_string().into_bytes() })
}
