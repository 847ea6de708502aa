//! The server as its clients meet it: through its router, and on a socket.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod answers;
mod common;
mod door;
mod jobs;
mod limits;
mod mutated;
mod openapi;
mod page;
mod socket;
