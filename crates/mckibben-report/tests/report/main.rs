//! Tests of the public interface.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail like tests")]

mod figures;

mod drawing;
mod files;
mod pdf;
mod scales;
mod smooth;
