//! The store: tables in Parquet files, one file or a folder of parts with a manifest. Plans are run
//! into it, shards of it are merged, and it is read.

pub mod file;
pub mod folder;
mod forecast;
pub mod layout;
mod manifest;
mod merge;
pub mod provenance;
mod read;
mod resume;
mod run;
mod seal;
mod shard;
mod status;
mod summary;
pub mod table;

pub use forecast::{Forecast, forecast};
pub use merge::{Merged, merge};
pub use provenance::Provenance;
pub use read::{Rows, rows};
pub use resume::Recomputed;
pub use run::{CampaignOutcome, Counts, RunOptions, run};
pub use shard::Shard;
pub use status::{ShardState, ShardStatus};
pub use summary::{Extent, Failed, Summary, summary};
