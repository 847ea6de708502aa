//! The server: routes, connections, and its end.

use crate::api;
use crate::config::Config;
use crate::door;
use crate::jobs::Jobs;
use crate::page::page;
use crate::refusal::Refusal;
use crate::work::Gate;
use axum::extract::Request;
use axum::http::StatusCode;
use axum::middleware::{Next, from_fn};
use axum::routing::{Router, get, post};
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::future::Future;
use std::io;
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;
use thiserror::Error;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, watch};
use tokio::task::JoinSet;
use tokio::time::{sleep, timeout};
use tokio_io_timeout::TimeoutStream;
use tower_http::compression::predicate::{DefaultPredicate, NotForContentType, Predicate};
use tower_http::compression::{CompressionLayer, CompressionLevel};

/// After the wish to end, connections have this long to be told.
pub const GRACE: Duration = Duration::from_millis(1200);
/// The wish is looked for this often.
const TICK: Duration = Duration::from_millis(50);
/// Work starts with the stack that a process starts with.
const STACK: usize = 8 << 20;
/// Headers of a request, in bytes.
const HEADERS: usize = 64 << 10;

/// Why the server cannot run.
#[derive(Debug, Error)]
pub enum ServeError {
    /// The system gives no threads or no connections.
    #[error("the server cannot run: {0}")]
    System(#[from] io::Error),
}

/// What all requests share.
pub struct State {
    pub config: Arc<Config>,
    pub gate: Gate,
    pub jobs: Jobs,
    /// Bytes of bodies that may be held.
    pub room: Arc<Semaphore>,
    pub stopping: watch::Receiver<bool>,
}

/// All routes: the page, and the commands.
///
/// It needs a runtime of tokio with time around it.
pub fn router(config: Config) -> Router {
    // Without a sender nobody ever wishes an end.
    routes(config, watch::channel(false).1)
}

fn routes(config: Config, stopping: watch::Receiver<bool>) -> Router {
    let config = Arc::new(config);
    let state = Arc::new(State {
        gate: Gate::new(config.workers, config.waiting),
        jobs: Jobs::new(&config.jobs),
        room: Arc::new(Semaphore::new(config.bodies_bytes.min(Semaphore::MAX_PERMITS))),
        config: Arc::clone(&config),
        stopping,
    });
    let small = DefaultPredicate::new().and(NotForContentType::const_new("application/octet-stream"));
    Router::new()
        .route("/api/v1", get(api::list))
        .route("/api/v1/health", get(api::health))
        .route("/api/v1/openapi.json", get(api::openapi))
        .route("/api/v1/schema/{command}", get(api::schema))
        .route("/api/v1/jobs/{name}", post(api::start).get(api::state).delete(api::forget))
        .route("/api/v1/jobs/{name}/events", get(api::events))
        .route("/api/v1/{command}", post(api::ask))
        .method_not_allowed_fallback(|| async {
            let hint = "`GET /api/v1/openapi.json` says which there are";
            Refusal::new(StatusCode::METHOD_NOT_ALLOWED, "there is no such method at this address", hint)
        })
        .fallback(page)
        .with_state(state)
        .layer(CompressionLayer::new().quality(CompressionLevel::Fastest).compress_when(small))
        .layer(from_fn(move |request: Request, next: Next| door::guarded(Arc::clone(&config), request, next)))
}

/// Serves on a listener until `stop` is ready; then nothing is accepted any more, work is ended, and clients are told so.
///
/// # Errors
/// [`ServeError`].
pub async fn serve(
    listener: TcpListener,
    config: Config,
    stop: impl Future<Output = ()>,
) -> Result<(), ServeError> {
    let (stopper, stopping) = watch::channel(false);
    let seats = Arc::new(Semaphore::new(config.connections.clamp(1, Semaphore::MAX_PERMITS)));
    let (silence, unread) = (config.silence, config.unread);
    let router = routes(config, stopping.clone());
    let mut connections = JoinSet::new();
    let mut stop = pin!(stop);
    loop {
        let next = async {
            let seat = Arc::clone(&seats).acquire_owned().await;
            (seat, listener.accept().await)
        };
        let (seat, stream) = tokio::select! {
            () = &mut stop => break,
            next = next => next,
        };
        match stream {
            Ok((stream, _)) => {
                let work = connection(stream, router.clone(), silence, unread, stopping.clone());
                connections.spawn(async move {
                    let _seat = seat;
                    work.await;
                });
            }
            // No file descriptors are left, or the client is gone already.
            Err(_) => sleep(TICK).await,
        }
        while connections.try_join_next().is_some() {}
    }
    drop(listener);
    stopper.send_replace(true);
    // Who has not been told by then is left.
    let _ = timeout(GRACE, async { while connections.join_next().await.is_some() {} }).await;
    Ok(())
}

async fn connection(
    stream: TcpStream,
    router: Router,
    silence: Duration,
    unread: Duration,
    mut stopping: watch::Receiver<bool>,
) {
    // Small answers go at once; where that cannot be had they go a little later.
    let _ = stream.set_nodelay(true);
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(unread));
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(silence)
        .max_buf_size(HEADERS)
        .serve_connection(TokioIo::new(Box::pin(stream)), TowerToHyperService::new(router));
    let mut connection = pin!(connection);
    // What goes wrong on a connection is its client's affair.
    tokio::select! {
        _ = connection.as_mut() => return,
        Ok(_) = stopping.wait_for(|s| *s) => connection.as_mut().graceful_shutdown(),
    }
    let _ = connection.await;
}

/// The same on threads of its own, for a front end without a runtime: returns within two seconds of `stopped` saying so, whatever the
/// work; what has not ended by then ends with the process.
///
/// # Errors
/// [`ServeError`].
pub fn run(
    listener: std::net::TcpListener,
    config: Config,
    stopped: impl Fn() -> bool,
) -> Result<(), ServeError> {
    listener.set_nonblocking(true)?;
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .max_blocking_threads(config.workers.max(1) + config.jobs.workers.max(1))
        .thread_stack_size(STACK)
        .enable_io()
        .enable_time()
        .build()?;
    let done = runtime.block_on(async {
        let stop = async {
            while !stopped() {
                sleep(TICK).await;
            }
        };
        serve(TcpListener::from_std(listener)?, config, stop).await
    });
    runtime.shutdown_timeout(Duration::from_millis(300));
    done
}
