//! Campaigns: many finite-element tests from a plan, resumable, into Parquet.
//!
//! plan → blocks of muscles (each alone, on any thread) → part files → one table in the order of the plan.
//!
//! A row depends on its muscle alone and no time or host stands in the data, so that the bytes of a table are the same
//! whatever the number of threads, shards and interruptions.

mod error;
mod merge;
mod plan;
mod read;
mod resume;
mod run;
mod shard;
mod solve;
mod store;
mod summary;

#[cfg(test)]
mod tests;

pub use error::CampaignError;
pub use merge::{Merged, merge};
pub use plan::{Axis, Inputs, Measure, Plan, Sampling, Testing};
pub use read::{Rows, read, rows};
pub use run::{Outcome, Progress, RunOptions, run};
pub use shard::Shard;
pub use store::Provenance;
pub use summary::{Failed, Summary, summary};
