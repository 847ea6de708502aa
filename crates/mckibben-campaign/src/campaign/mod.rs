//! Campaigns: many finite-element tests from a plan, resumable, into Parquet.
//!
//! plan → blocks of muscles (each alone, on any thread) → part files → one table in the order of the plan.
//!
//! A row depends on its muscle alone and no time or host is in the data, so that the bytes of a table are the same
//! whatever the number of threads, shards and interruptions. Without the feature `store` there are no files:
//! [`compute`] gives the rows of a plan in memory.

mod error;
#[cfg(feature = "store")]
mod merge;
mod plan;
#[cfg(feature = "store")]
mod read;
#[cfg(feature = "store")]
mod resume;
#[cfg(feature = "store")]
mod run;
#[cfg(feature = "store")]
mod shard;
mod solve;
#[cfg(feature = "store")]
mod status;
#[cfg(feature = "store")]
mod store;
#[cfg(feature = "store")]
mod summary;

#[cfg(all(test, feature = "store"))]
mod tests;

pub use error::CampaignError;
use error::Result;
#[cfg(feature = "store")]
pub use merge::{Merged, merge};
pub use plan::{Inputs, Plan, Testing};
#[cfg(feature = "store")]
pub use read::{Rows, read, rows};
#[cfg(feature = "store")]
pub use run::{Counts, Outcome, Recomputed, RunOptions, run};
#[cfg(feature = "store")]
pub use shard::Shard;
pub use solve::compute;
#[cfg(feature = "store")]
pub use status::{CampaignStatus, ShardState, ShardStatus, status};
#[cfg(feature = "store")]
pub use store::Provenance;
#[cfg(feature = "store")]
pub use summary::{Extent, Failed, Summary, summary};
