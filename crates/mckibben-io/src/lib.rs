//! What comes in and goes out: people's [`table`]s, [`files`], [`template`]s, tables in Parquet
//! files (feature `parquet`).

#![warn(clippy::print_stdout, clippy::print_stderr)]

pub mod files;
#[cfg(feature = "parquet")]
pub mod parquet;
pub mod table;
pub mod template;
