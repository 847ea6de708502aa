//! What comes in and goes out: quantities with [`units`], people's [`table`]s, [`files`],
//! [`template`]s, tables in Parquet files (feature `parquet`); and the wish to end work,
//! [`cancel`].

#![warn(clippy::print_stdout, clippy::print_stderr)]
#![cfg_attr(test, allow(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod cancel;
pub mod clean;
pub mod files;
#[cfg(feature = "parquet")]
pub mod parquet;
pub mod table;
pub mod template;
pub mod units;
mod word;

pub use word::{joined, named};
