//! The server as its clients meet it: through its router, and on a socket.

mod answers;
mod common;
mod door;
mod jobs;
mod limits;
mod openapi;
mod page;
mod socket;
