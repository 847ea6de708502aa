//! Jobs: work that is asked for in one request and answered in others.

use crate::config::JobConfig;
use crate::refusal::Refusal;
use crate::work::{Gate, Question, QueueSlot, answer, worked};
use axum::http::StatusCode;
use mckibben::threads::Threads;
use mckibben_app::{Problem, ProblemKind};
use serde_json::json;
use std::collections::{HashMap, VecDeque};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, OnceLock, PoisonError};
use tokio::sync::watch;
use tokio::task::AbortHandle;
use tokio::time::{Instant, sleep};

/// Jobs have threads of their own, so that the parts of a short request do not wait behind those of a long one.
fn threads() -> &'static Threads {
    static THREADS: LazyLock<Threads> = LazyLock::new(|| {
        // Where the system gives no more of them, a job works alone.
        Threads::new(Threads::shared().count()).unwrap_or_default()
    });
    &THREADS
}

/// Where a job is on its way.
#[derive(Debug, Clone)]
pub enum Phase {
    Queued,
    Running,
    Done(Arc<str>),
    Failed(Arc<Refusal>),
}

impl Phase {
    fn name(&self) -> &'static str {
        match self {
            Self::Queued => "queued",
            Self::Running => "running",
            Self::Done(_) => "done",
            Self::Failed(why) if why.problem.kind == ProblemKind::Cancelled => "cancelled",
            Self::Failed(_) => "failed",
        }
    }

    pub fn ended(&self) -> bool {
        matches!(self, Self::Done(_) | Self::Failed(_))
    }
}

/// A job.
#[derive(Debug)]
pub struct Job {
    id: String,
    command: &'static str,
    phase: watch::Sender<Phase>,
    done: AtomicUsize,
    total: AtomicUsize,
    /// Clients that listen to its events; and how often one has left.
    listeners: AtomicUsize,
    left: AtomicUsize,
    work: OnceLock<AbortHandle>,
}

impl Job {
    pub fn phase(&self) -> watch::Receiver<Phase> {
        self.phase.subscribe()
    }

    /// How many of how many steps are done.
    pub fn progress(&self) -> (usize, usize) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }

    /// Its state; an answer is put in as it is, which saves reading it again.
    pub fn to_json(&self) -> String {
        let (done, total) = self.progress();
        let phase = self.phase.borrow().clone();
        let mut text = json!({
            "id": self.id, "command": self.command, "state": phase.name(), "done": done, "total": total
        })
        .to_string();
        text.pop();
        match phase {
            Phase::Queued | Phase::Running => text + "}",
            Phase::Done(answer) => format!("{text},\"answer\":{answer}}}"),
            Phase::Failed(why) => format!("{text},\"problem\":{}}}", why.to_json()),
        }
    }

    /// The first end counts.
    fn end(&self, phase: Phase) {
        self.phase.send_if_modified(|now| {
            let open = !now.ended();
            if open {
                *now = phase;
            }
            open
        });
    }

    fn cancel(&self) {
        if let Some(work) = self.work.get() {
            work.abort();
        }
        self.end(Phase::Failed(Arc::new(Problem::cancelled().into())));
    }
}

#[derive(Debug, Clone)]
pub struct Jobs {
    config: JobConfig,
    gate: Arc<Gate>,
    kept: Arc<Mutex<Kept>>,
}

#[derive(Debug, Default)]
struct Kept {
    jobs: HashMap<String, Arc<Job>>,
    /// Those that have ended, from the oldest on, with the length of their answers and when they go.
    ended: VecDeque<(String, usize, Instant)>,
}

impl Kept {
    /// Forgets what is too much or too old.
    fn prune(&mut self, config: &JobConfig) {
        let mut all: usize = self.ended.iter().map(|(_, bytes, _)| bytes).sum();
        while let Some((id, bytes, until)) = self.ended.front() {
            let many = self.ended.len() > config.kept.max(1);
            let long = all > config.kept_bytes && self.ended.len() > 1;
            if !many && !long && Instant::now() < *until {
                break;
            }
            all -= bytes;
            self.jobs.remove(id);
            self.ended.pop_front();
        }
    }
}

impl Jobs {
    pub fn new(config: &JobConfig) -> Self {
        let gate = Gate::new(config.workers, config.waiting);
        Self { config: config.clone(), gate: Arc::new(gate), kept: Arc::default() }
    }

    fn kept(&self) -> MutexGuard<'_, Kept> {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.prune(&self.config);
        kept
    }

    /// A place for another one.
    pub fn enter(&self) -> Result<QueueSlot, Refusal> {
        self.gate.enter()
    }

    pub fn start(
        &self,
        place: QueueSlot,
        stopping: watch::Receiver<bool>,
        question: Question,
    ) -> Result<String, Refusal> {
        let mut bytes = [0; 16];
        getrandom::fill(&mut bytes).map_err(|e| {
            let message = format!("the system gives no random numbers: {e}");
            Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, message, "")
        })?;
        let id: String = bytes.iter().map(|b| format!("{b:02x}")).collect();
        let job = Arc::new(Job {
            id: id.clone(),
            command: question.command.name,
            phase: watch::Sender::new(Phase::Queued),
            done: AtomicUsize::new(0),
            total: AtomicUsize::new(0),
            listeners: AtomicUsize::new(0),
            left: AtomicUsize::new(0),
            work: OnceLock::new(),
        });
        self.kept().jobs.insert(id.clone(), Arc::clone(&job));
        let reported = Arc::clone(&job);
        let report = move |done, total| {
            reported.done.store(done, Ordering::Relaxed);
            reported.total.store(total, Ordering::Relaxed);
            reported.phase.send_if_modified(|phase| {
                let waited = matches!(phase, Phase::Queued);
                if waited {
                    *phase = Phase::Running;
                }
                waited
            });
        };
        let work = worked(place, stopping, report, move |progress| {
            let bytes = threads().within(|| answer(question, false, progress))?;
            String::from_utf8(bytes)
                .map_err(|e| Problem::new(ProblemKind::Internal, e.to_string(), "").into())
        });
        let (jobs, own) = (self.clone(), Arc::clone(&job));
        let work = tokio::spawn(async move {
            own.end(match work.await {
                Ok(answer) => Phase::Done(answer.into()),
                Err(why) => Phase::Failed(Arc::new(why)),
            });
            jobs.keep(&own);
        });
        let _ = job.work.set(work.abort_handle());
        Ok(id)
    }

    /// Keeps one that has ended for a while.
    fn keep(&self, job: &Job) {
        let bytes = match &*job.phase.borrow() {
            Phase::Done(answer) => answer.len(),
            _ => 0,
        };
        let mut kept = self.kept();
        if kept.jobs.contains_key(&job.id) {
            kept.ended.push_back((job.id.clone(), bytes, Instant::now() + self.config.kept_for));
            kept.prune(&self.config);
        }
    }

    fn drop(&self, id: &str) -> Option<Arc<Job>> {
        let mut kept = self.kept();
        kept.ended.retain(|(ended, ..)| ended != id);
        kept.jobs.remove(id)
    }

    pub fn find(&self, id: &str) -> Result<Arc<Job>, Refusal> {
        self.kept().jobs.get(id).cloned().ok_or_else(|| {
            let hint = "it may have expired: answers are kept for a limited time";
            Refusal::new(StatusCode::NOT_FOUND, "there is no such job", hint)
        })
    }

    /// Ends one and forgets it.
    pub fn forget(&self, id: &str) -> Result<(), Refusal> {
        self.find(id)?;
        if let Some(job) = self.drop(id) {
            job.cancel();
        }
        Ok(())
    }

    /// One more client listens to a job.
    pub fn listen(&self, job: &Arc<Job>) -> Listener {
        job.listeners.fetch_add(1, Ordering::Relaxed);
        Listener { jobs: self.clone(), job: Arc::clone(job) }
    }
}

/// A client that listens; when the last one has left for a while, the work is for nobody.
pub struct Listener {
    jobs: Jobs,
    pub job: Arc<Job>,
}

impl Drop for Listener {
    fn drop(&mut self) {
        let left = self.job.left.fetch_add(1, Ordering::Relaxed) + 1;
        let last = self.job.listeners.fetch_sub(1, Ordering::Relaxed) == 1;
        // Outside of a runtime everything ends anyway.
        let (true, Ok(runtime)) =
            (last && !self.job.phase.borrow().ended(), tokio::runtime::Handle::try_current())
        else {
            return;
        };
        let (jobs, job) = (self.jobs.clone(), Arc::clone(&self.job));
        runtime.spawn(async move {
            sleep(jobs.config.unwatched).await;
            let nobody = job.listeners.load(Ordering::Relaxed) == 0;
            // Who came and left meanwhile has a watch of its own.
            if nobody && job.left.load(Ordering::Relaxed) == left && !job.phase.borrow().ended() {
                job.cancel();
                jobs.keep(&job);
            }
        });
    }
}
