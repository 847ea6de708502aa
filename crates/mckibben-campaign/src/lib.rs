//! Campaigns of finite-element muscles, and formulas fitted to them.
//!
//! plan → rows (one a point, in Parquet) → fit → formula → design.

#![cfg_attr(test, allow(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod campaign;
pub mod fit;
mod row;

pub use row::Row;
