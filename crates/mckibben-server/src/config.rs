//! What the server allows.

use std::num::NonZero;
use std::time::Duration;

/// What the server allows; the default suits one person on one computer.
#[derive(Debug, Clone, PartialEq)]
pub struct Config {
    /// Names of this computer besides `localhost`, `127.0.0.1` and `[::1]`: requests to other names are refused, so that a foreign
    /// page whose name was made to point here gets no answer.
    pub host_names: Vec<String>,
    /// Requests that are worked on at once: as many as there are cores.
    pub workers: usize,
    /// Requests that may wait for their turn.
    pub waiting: usize,
    /// Connections at once; more wait to be accepted.
    pub connections: usize,
    /// Length of a request's body to a command that takes tables.
    pub body_bytes: usize,
    /// The same to any other command.
    pub small_body_bytes: usize,
    /// Memory for all requests and answers that are held at once, in bytes: those of bodies as they arrive, of what is made of them, and of
    /// answers until they are sent.
    pub memory_bytes: usize,
    /// A body of which less than so many bytes come in a second, after the first `silence`, is left.
    pub body_rate: usize,
    /// A connection on which nothing comes for so long, where something should, is closed.
    pub silence: Duration,
    /// A client that takes nothing of its answer for so long is left.
    pub unread: Duration,
    /// A body has to be there after so long.
    pub body_time: Duration,
    pub jobs: JobConfig,
}

/// What the server allows of long work.
#[derive(Debug, Clone, PartialEq)]
pub struct JobConfig {
    /// Jobs at once: half as many as there are cores, so that short requests find one.
    pub workers: usize,
    /// Jobs that may wait for their turn.
    pub waiting: usize,
    /// Finished jobs that are kept; the oldest goes first.
    pub kept: usize,
    /// Bytes of the answers that are kept; the newest answer is, whatever its length.
    pub kept_bytes: usize,
    pub kept_for: Duration,
    /// A job whose events were listened to, and are no longer by anybody for so long, is cancelled.
    pub unwatched: Duration,
}

impl Default for Config {
    fn default() -> Self {
        let workers = cores();
        Self {
            host_names: vec![],
            workers,
            waiting: 64,
            connections: 512,
            body_bytes: 8 << 20,
            small_body_bytes: 256 << 10,
            memory_bytes: 256 << 20,
            body_rate: 16 << 10,
            silence: Duration::from_secs(10),
            unread: Duration::from_secs(30),
            body_time: Duration::from_secs(60),
            jobs: JobConfig::default(),
        }
    }
}

impl Default for JobConfig {
    fn default() -> Self {
        Self {
            workers: cores().div_ceil(2),
            waiting: 16,
            kept: 32,
            kept_bytes: 64 << 20,
            kept_for: Duration::from_secs(600),
            unwatched: Duration::from_secs(30),
        }
    }
}

fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, NonZero::get)
}
