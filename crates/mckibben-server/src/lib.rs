//! The workbench in a browser: the page, and every command of the application layer over HTTP.
//!
//! A request is checked at the door ([`Config::host_names`], origin, content type, size), waits for its turn in a bounded queue, and
//! is answered by `mckibben_app` on a thread of its own within a budget; where the client leaves, the work ends. What takes long
//! is a job, with its progress as server-sent events. `docs/server.md` lists routes and limits.
//!
//! The server reads no file, keeps nothing on disk and has no users: it is meant for the computer that it runs on.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod api;
mod config;
mod door;
mod events;
mod jobs;
mod openapi;
mod page;
mod refusal;
mod room;
mod serve;
mod state;
mod work;

pub use config::{Config, JobConfig};
pub use serve::{GRACE, ServeError, Server, router, run, serve};
