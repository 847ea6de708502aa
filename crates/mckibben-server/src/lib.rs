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
};
use hyper::server::conn::http1;
use hyper_util::{
    rt::{TokioIo, TokioTimer},
    server::graceful::GracefulShutdown,
    service::TowerToHyperService,
};
use std::{io, sync::Arc, time::Duration};
use tokio::{net::TcpListener, sync::Semaphore, time::sleep};
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
    /// What the head of a request may take to come, and a connection to say something again.
    pub head: Duration,
    /// Connections at once; more of them wait for one to end.
    pub connections: usize,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            time: Duration::from_secs(1800),
            body_bytes: 8 << 20,
            at_once: 32,
            head: Duration::from_secs(5),
            // Below the 256 files that some systems allow a process.
            connections: 200,
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
    stopped: impl Fn() -> bool,
) -> io::Result<()> {
    listener.set_nonblocking(true)?;
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .max_blocking_threads(config.at_once)
        .thread_stack_size(STACK)
        .build()?;
    let done = runtime.block_on(serve(listener, config, stopped));
    runtime.shutdown_timeout(Duration::from_millis(300));
    done
}

async fn serve(
    listener: std::net::TcpListener,
    config: Config,
    stopped: impl Fn() -> bool,
) -> io::Result<()> {
    let listener = TcpListener::from_std(listener)?;
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new())
        .header_read_timeout(config.head);
    let places = Arc::new(Semaphore::new(config.connections));
    let service = TowerToHyperService::new(router(config));
    let open = GracefulShutdown::new();
    let accept = async {
        while let Ok(place) = Arc::clone(&places).acquire_owned().await {
            let Ok((stream, _)) = listener.accept().await else {
                sleep(TICK).await;
                continue;
            };
            // Small answers go at once.
            let _ = stream.set_nodelay(true);
            let connection = http.serve_connection(TokioIo::new(stream), service.clone());
            let connection = open.watch(connection);
            tokio::spawn(async move {
                let _ = connection.await;
                drop(place);
            });
        }
    };
    tokio::select! { () = accept => {}, () = until(stopped) => {} }
    drop(listener);
    tokio::select! { () = open.shutdown() => {}, () = sleep(GRACE) => {} }
    Ok(())
}

async fn until(stopped: impl Fn() -> bool) {
    while !stopped() {
        sleep(TICK).await;
    }
}
