//! The workbench in a browser: the page, and `POST /api/COMMAND` with the request's JSON.
//!
//! The server is for the computer that it runs on: it answers to names of this computer alone,
//! reads no file, keeps nothing on disk and has no users. `docs/server.md` lists routes and limits.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod ask;
mod page;
mod refusal;
mod request_guard;

use axum::{
    extract::DefaultBodyLimit,
    middleware::from_fn_with_state,
    routing::{Router, get, post},
    serve::ListenerExt,
};
use std::{future::IntoFuture, io, sync::Arc, time::Duration};
use tokio::{sync::Semaphore, time::sleep};
use tower_http::compression::{CompressionLayer, CompressionLevel};

/// After the wish to end, requests have this time to end by themselves.
const GRACE: Duration = Duration::from_millis(1200);
/// The wish is looked for this often.
const TICK: Duration = Duration::from_millis(50);
/// Work starts with the stack that a process starts with.
const STACK: usize = 8 << 20;

/// What the server allows; the default suits one person on one computer.
pub struct Config {
    /// What a request may take.
    pub time: Duration,
    /// Length of a request's body.
    pub body_bytes: usize,
    /// Requests that are worked on at once.
    pub at_once: usize,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            time: Duration::from_secs(1800),
            body_bytes: 8 << 20,
            at_once: 32,
        }
    }
}

/// All routes; it needs a runtime of tokio with time around it.
pub fn router(config: Config) -> Router {
    Router::new()
        .route("/api/{command}", post(ask::ask))
        .fallback(get(page::page))
        .with_state(Arc::new(Semaphore::new(config.at_once)))
        .layer(DefaultBodyLimit::max(config.body_bytes))
        .layer(CompressionLayer::new().quality(CompressionLevel::Fastest))
        .layer(from_fn_with_state(config.time, request_guard::guarded))
}

/// Serves on a listener, and returns within two seconds of `stopped` saying so: what has not ended
/// by then is cancelled.
pub fn run(
    listener: std::net::TcpListener,
    config: Config,
    stopped: impl Fn() -> bool + Clone + Send + 'static,
) -> io::Result<()> {
    listener.set_nonblocking(true)?;
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .max_blocking_threads(config.at_once)
        .thread_stack_size(STACK)
        .build()?;
    let end = stopped.clone();
    let done = runtime.block_on(async {
        // Small answers go at once.
        let listener = tokio::net::TcpListener::from_std(listener)?.tap_io(|stream| {
            let _ = stream.set_nodelay(true);
        });
        let serve = axum::serve(listener, router(config)).with_graceful_shutdown(until(stopped));
        tokio::select! {
            done = serve.into_future() => done,
            () = async { until(end).await; sleep(GRACE).await } => Ok(()),
        }
    });
    runtime.shutdown_timeout(Duration::from_millis(300));
    done
}

async fn until(stopped: impl Fn() -> bool) {
    while !stopped() {
        sleep(TICK).await;
    }
}
