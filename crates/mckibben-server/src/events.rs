//! A job's way as server-sent events.

use crate::jobs::{Job, Jobs, Listener, Phase};
use axum::response::IntoResponse;
use axum::response::sse::{Event, KeepAlive, Sse};
use futures_util::stream;
use serde_json::json;
use std::convert::Infallible;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::watch;
use tokio::time::sleep;

/// Progress is reported this often at most.
const TICK: Duration = Duration::from_millis(100);
/// A sign of life where there is nothing to tell.
const ALIVE: Duration = Duration::from_secs(5);

struct Telling {
    listener: Listener,
    phase: watch::Receiver<Phase>,
    reported: Option<(usize, usize)>,
    over: bool,
}

/// `progress` now and then, at last `answer` or `problem`.
pub fn stream(jobs: &Jobs, job: Arc<Job>) -> impl IntoResponse + use<> {
    let telling = Telling { phase: job.phase(), listener: jobs.listen(&job), reported: None, over: false };
    let events = stream::unfold(telling, |mut telling| async {
        let event = telling.next().await?;
        Some((Ok::<_, Infallible>(event), telling))
    });
    Sse::new(events).keep_alive(KeepAlive::new().interval(ALIVE))
}

impl Telling {
    async fn next(&mut self) -> Option<Event> {
        loop {
            if self.over {
                return None;
            }
            let now = self.phase.borrow_and_update().clone();
            let progress = self.listener.job.progress();
            if self.reported != Some(progress) {
                self.reported = Some(progress);
                let (done, total) = progress;
                return Some(
                    Event::default()
                        .event("progress")
                        .data(json!({"done": done, "total": total}).to_string()),
                );
            }
            self.over = now.ended();
            match now {
                Phase::Done(answer) => return Some(Event::default().event("answer").data(&*answer)),
                Phase::Failed(why) => {
                    return Some(Event::default().event("problem").data(why.to_json().to_string()));
                }
                Phase::Queued | Phase::Running => {}
            }
            // Told once a tick, or at once when it has ended.
            tokio::select! {
                changed = self.phase.wait_for(Phase::ended) => drop(changed),
                () = sleep(TICK) => {}
            }
        }
    }
}
