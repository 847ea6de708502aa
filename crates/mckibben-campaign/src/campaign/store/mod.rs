//! The store: tables in Parquet files, one file or a folder of parts. Plans are run into it, shards
//! of it are merged, and it is read.

mod decode;
mod encode;
mod folder;
mod layout;
mod merge;
mod provenance;
mod read;
mod resume;
mod run;
mod shard;
mod status;
mod summary;
mod table;

pub use merge::{Merged, merge};
pub use provenance::Provenance;
pub use read::{Rows, read, rows};
pub use run::{Counts, Outcome, Recomputed, RunOptions, run};
pub use shard::Shard;
pub use status::{CampaignStatus, ShardState, ShardStatus, status};
pub use summary::{Extent, Failed, Summary, summary};

pub(super) use decode::{Opened, PartSource, flat};
pub(super) use encode::{part, write};
pub(super) use folder::{Folder, MARKER, check_name, is_file_name, part_name};
pub(super) use layout::Field;
#[cfg(test)]
pub(super) use layout::Layout;
pub(super) use provenance::Which;
pub(super) use table::Table;

/// Parts of a campaign by their number.
type Parts = std::collections::BTreeMap<u64, PartSource>;
