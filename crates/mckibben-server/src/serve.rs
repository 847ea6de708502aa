//! The server: routes, connections, and its end.

use crate::api::{self, Ours, PACKED};
use crate::config::Config;
use crate::door;
use crate::jobs::Jobs;
use crate::page::page;
use crate::refusal::Refusal;
use crate::room::Room;
use crate::state::State;
use crate::work::Gate;
use axum::body::{Body, HttpBody};
use axum::extract::Request;
use axum::http::{HeaderMap, Response, StatusCode};
use axum::middleware::{Next, from_fn};
use axum::routing::{Router, get, post};
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use mckibben_app::COMMANDS;
use std::future::Future;
use std::io;
use std::num::NonZero;
use std::pin::pin;
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex};
use std::time::Duration;
use thiserror::Error;
use tokio::net::{TcpListener, TcpStream};
use tokio::runtime::Runtime;
use tokio::sync::{Semaphore, watch};
use tokio::task::JoinSet;
use tokio::time::{sleep, timeout};
use tokio_io_timeout::TimeoutStream;
use tower_http::compression::predicate::{DefaultPredicate, NotForContentType, Predicate, SizeAbove};
use tower_http::compression::{CompressionLayer, CompressionLevel};

/// After the wish to end, connections have this time to be notified.
pub const GRACE: Duration = Duration::from_millis(1200);
/// The wish is looked for this often.
const TICK: Duration = Duration::from_millis(50);
/// Work starts with the stack that a process starts with.
const STACK: usize = 8 << 20;
/// Memory that a server needs to begin.
const LEAST_MEMORY: usize = 64 << 20;
/// Packed answers up to this many bytes go as they are.
const SHORT: u64 = 32 << 10;
/// Headers of a request, in bytes.
const HEADERS: usize = 64 << 10;

/// Why the server cannot run.
#[derive(Debug, Error)]
pub enum ServeError {
    /// The system gives no threads or no connections.
    #[error("the server cannot run: {0}")]
    System(#[from] io::Error),
    /// The system gives no thread that could answer.
    #[error("the server cannot run: the system gives it no thread: {0}")]
    Threads(io::Error),
    /// The system gives too little memory.
    #[error("the server cannot run: the system gives it less than {} MB of memory", .bytes >> 20)]
    Memory {
        /// How much it needs to begin.
        bytes: usize,
    },
}

/// Which answers are compressed: all but those of events, and packed ones where they are short, such as shapes while the user drags.
#[derive(Debug, Clone, Copy)]
struct Worth;

impl Predicate for Worth {
    fn should_compress<B: HttpBody>(&self, response: &Response<B>) -> bool {
        let packed = !NotForContentType::const_new(PACKED).should_compress(response);
        DefaultPredicate::new().should_compress(response)
            && (!packed || SizeAbove::new(SHORT).should_compress(response))
    }
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
        room: Room::new(config.memory_bytes),
        config: Arc::clone(&config),
        stopping,
    });
    // A route a command: what is advertised of a job's address and of that of a command is then right for each.
    let jobs = COMMANDS.iter().fold(Router::<Arc<State>>::new(), |router, command| {
        let start =
            move |state: Ours, headers: HeaderMap, body: Body| api::start(state, command, headers, body);
        router.route(&format!("/api/v1/jobs/{}", command.name), post(start))
    });
    jobs.route("/api/v1", get(api::list))
        .route("/api/v1/health", get(api::health))
        .route("/api/v1/openapi.json", get(api::openapi))
        .route("/api/v1/schema/{command}", get(api::schema))
        .route("/api/v1/jobs/{name}", get(api::state).delete(api::forget))
        .route("/api/v1/jobs/{name}/events", get(api::events))
        .route("/api/v1/{command}", post(api::ask))
        .method_not_allowed_fallback(|| async {
            let hint = "`GET /api/v1/openapi.json` lists them";
            Refusal::new(StatusCode::METHOD_NOT_ALLOWED, "there is no such method at this address", hint)
        })
        .fallback(page)
        .with_state(state)
        .layer(CompressionLayer::new().quality(CompressionLevel::Fastest).compress_when(Worth))
        .layer(from_fn(move |request: Request, next: Next| door::guarded(Arc::clone(&config), request, next)))
}

/// Serves on a listener until `stop` is ready; then nothing is accepted any more, work is ended, and clients are told so.
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
    // Connections that were not notified by then are closed.
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

/// A runtime with a thread that answers, and room for what it needs.
fn started(mut builder: tokio::runtime::Builder, answering: usize) -> Result<Runtime, ServeError> {
    // A thread that was given is kept: another one might be refused.
    let kept = Duration::from_secs(365 * 86_400);
    builder.max_blocking_threads(answering).thread_keep_alive(kept).thread_stack_size(STACK);
    let runtime = builder.enable_io().enable_time().build()?;
    let begun = runtime.spawn_blocking(|| ());
    runtime.block_on(begun).map_err(|e| ServeError::Threads(io::Error::other(e)))?;
    let room = Vec::<u8>::new().try_reserve_exact(LEAST_MEMORY);
    room.map_err(|_| ServeError::Memory { bytes: LEAST_MEMORY })?;
    Ok(runtime)
}

/// A server with its threads, before anybody can ask it.
#[derive(Debug)]
pub struct Server {
    runtime: Runtime,
    config: Config,
}

impl Server {
    /// Starts the threads of a server. Where the system gives few of them, one reads and writes and one answers.
    pub fn new(config: Config) -> Result<Self, ServeError> {
        // A runtime panics where it gets no thread for its work: whether there is one is asked before.
        let spare = |count: usize| -> io::Result<()> {
            let (stop, stopped) = channel::<()>();
            let stopped = Arc::new(Mutex::new(stopped));
            let threads: Vec<_> = (0..count)
                .map(|_| {
                    let stopped = Arc::clone(&stopped);
                    let wait = move || drop(stopped.lock().map(|stopped| stopped.recv()));
                    std::thread::Builder::new().stack_size(STACK).spawn(wait)
                })
                .collect();
            drop(stop);
            threads.into_iter().try_for_each(|thread| thread.map(|thread| drop(thread.join())))
        };
        let answering = config.workers.max(1) + config.jobs.workers.max(1);
        let all = std::thread::available_parallelism().map_or(1, NonZero::get) + answering;
        let many = || {
            spare(all).map_err(ServeError::Threads)?;
            started(tokio::runtime::Builder::new_multi_thread(), answering)
        };
        let few = |_| {
            spare(1).map_err(ServeError::Threads)?;
            started(tokio::runtime::Builder::new_current_thread(), 1)
        };
        let runtime = many().or_else(few)?;
        Ok(Self { runtime, config })
    }

    /// Serves on a listener: returns within two seconds of `stopped` saying so, whatever the work; what has not ended by then ends with the
    /// process.
    pub fn run(self, listener: std::net::TcpListener, stopped: impl Fn() -> bool) -> Result<(), ServeError> {
        let Self { runtime, config } = self;
        listener.set_nonblocking(true)?;
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
}

/// Both at once, for a front end without a runtime.
pub fn run(
    listener: std::net::TcpListener,
    config: Config,
    stopped: impl Fn() -> bool,
) -> Result<(), ServeError> {
    Server::new(config)?.run(listener, stopped)
}
