//! How far a folder of parts is, shard by shard: from names, locks and times of files alone, at any
//! time and from any machine.

use super::{folder::Folder, shard::Shard};
use crate::campaign::error::Result;
use schemars::JsonSchema;
use serde::Serialize;
use std::{collections::BTreeSet, path::Path, time::SystemTime};

/// How a shard is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ShardState {
    /// All its parts are there.
    Done,
    /// A process computes it.
    Running,
    /// Nothing computes it, and parts are missing.
    Missing,
}

mckibben_core::units::display_as_serde_word!(ShardState);

/// One shard.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ShardStatus {
    /// The share, i/n.
    pub shard: String,
    /// How it is.
    pub state: ShardState,
    /// Parts that are there.
    pub parts: u64,
    /// Parts of the share.
    pub parts_wanted: u64,
}

/// All shards of a folder, of which these parts are whole.
pub fn shards(folder: &Path, whole: &BTreeSet<u64>, parts_wanted: u64) -> Result<Vec<ShardStatus>> {
    let count = Folder::shards(folder)?;
    let shards = (1..=count).filter_map(|index| Shard::new(index, count));
    Ok(shards
        .map(|shard| shard_status(folder, shard, whole, parts_wanted))
        .collect())
}

/// The rate at which the newest parts were written; nothing where these are fewer than two.
pub fn parts_per_s(mut written: Vec<SystemTime>) -> Option<f64> {
    /// Older ones may be of an earlier run.
    const NEWEST: usize = 50;
    written.sort_unstable();
    let newest = &written[written.len().saturating_sub(NEWEST)..];
    let seconds = newest
        .last()?
        .duration_since(*newest.first()?)
        .ok()?
        .as_secs_f64();
    (seconds > 0.0).then(|| (newest.len() - 1) as f64 / seconds)
}

fn shard_status(folder: &Path, shard: Shard, whole: &BTreeSet<u64>, all: u64) -> ShardStatus {
    let parts_wanted = shard.size(all);
    let parts = whole.iter().filter(|part| shard.holds(**part)).count() as u64;
    let state = if parts == parts_wanted {
        ShardState::Done
    } else if Folder::is_locked(folder, shard) {
        ShardState::Running
    } else {
        ShardState::Missing
    };
    ShardStatus {
        shard: shard.to_string(),
        state,
        parts,
        parts_wanted,
    }
}
