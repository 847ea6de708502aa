//! All integration tests of the crate in one executable: one link in place of many.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod burst;
mod fuzz_parsers;
mod inverses;
mod literature;
mod models;
mod temperature;
mod verification;
