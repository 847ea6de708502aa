//! Campaigns of finite-element muscles, and formulas fitted to them.
//!
//! plan → rows (one a point, in Parquet) → fit → formula → design.

#![warn(clippy::print_stdout, clippy::print_stderr)]

pub mod campaign;
pub mod columns;
pub mod fit;
mod hash;

pub use columns::PointRow;
pub use mckibben_core::hash::hex as sha256;
