//! All integration tests of the command in one executable: one link in place of many.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod campaign;
mod common;
mod ends;
mod examples;
mod files;
mod fuzz_cli;
mod help;
mod output;
mod pages;
mod rows;
mod serve;
