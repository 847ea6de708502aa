//! What the crate gives to its users, in one program.

#![allow(clippy::unwrap_used, clippy::panic)]

mod constants;
mod formulas;
mod held_out;
mod signs;
mod universal;
mod verification;
