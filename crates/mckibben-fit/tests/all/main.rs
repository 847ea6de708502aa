//! All integration tests of the crate in one executable: one link in place of many.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bench_tables;
mod by_elements;
mod by_reach;
mod fake_benches;
mod friction_unknown;
mod lay;
mod measured;
mod one_axis;
mod tables;
