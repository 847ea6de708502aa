//! Campaigns: many finite-element tests from a plan, resumable, into Parquet.
//!
//! plan → blocks of muscles (each alone, on any thread) → part files → one table in the order of
//! the plan.
//!
//! A row depends on its muscle alone and no time or host is in the data, so that the bytes of a
//! table are the same whatever the number of threads, shards and interruptions. Without the feature
//! `store` there are no files: [`compute`] gives the rows of a plan in memory.

mod error;
mod plan;
mod solve;
#[cfg(feature = "store")]
mod store;
mod warnings;

#[cfg(all(test, feature = "store"))]
mod tests;

pub use error::CampaignError;
pub use plan::{Inputs, Plan, PlanKeys, Sampling, SamplingMethod, Testing};
pub use solve::compute;
#[cfg(feature = "store")]
pub use store::{CampaignOutcome, Forecast, RunOptions, forecast, rows, run};
#[cfg(feature = "store")]
pub use store::{
    Counts, Extent, Failed, Merged, Provenance, Recomputed, Rows, Shard, ShardState, ShardStatus,
    Summary, merge, summary,
};
pub use warnings::Warned;
