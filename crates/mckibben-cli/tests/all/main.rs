//! All integration tests of the command in one executable: one link in place of many.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bad_input;
mod build;
mod burst;
mod campaign;
mod cancelled;
mod check;
mod common;
mod contract;
mod design;
mod examples;
mod export;
mod files;
mod formulas;
mod frictions;
mod fuzz_cli;
mod help;
mod identify;
mod joint;
mod library;
mod measured;
mod motion;
mod parts;
mod report;
mod rubber;
mod security;
mod serve;
mod tables;
mod threads;
mod trust;
mod widths;
