//! How far a folder of parts is, shard by shard: from names, locks and ends of files alone, at any
//! time and from any machine.

use super::{file::Opened, folder::Folder, manifest::noted, shard::Shard};
use crate::campaign::error::{CampaignError, Result};
use mckibben_io::files::ReadError;
use schemars::JsonSchema;
use serde::Serialize;
use std::{
    collections::BTreeSet,
    io::ErrorKind,
    path::{Path, PathBuf},
    time::SystemTime,
};

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

/// A campaign in a folder.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CampaignStatus {
    /// The folder.
    pub output: PathBuf,
    /// Whether all parts are there.
    pub complete: bool,
    /// Parts that are there.
    pub parts: u64,
    /// Parts of the plan.
    pub parts_wanted: u64,
    /// Number of shards.
    pub shards_wanted: u64,
    /// Shards that are done.
    pub shards_done: u64,
    /// Shards that a process computes.
    pub shards_running: u64,
    /// Shards that nothing computes.
    pub shards_missing: u64,
    /// Points a second, by the times of the newest parts, of all shards together; nothing where these
    /// are fewer than two.
    pub points_per_s: Option<f64>,
    /// What is left at this rate in s, where a process computes.
    pub left_s: Option<f64>,
    /// Every shard.
    pub shards: Vec<ShardStatus>,
    /// Parts that are damaged, or of another plan or version; they count as missing.
    pub damaged: Vec<PathBuf>,
    /// SHA-256 of the plan's text.
    pub plan_sha256: String,
    /// Version of the program.
    pub version: String,
}

/// Looks at a folder of parts.
pub fn status(folder: &Path) -> Result<CampaignStatus> {
    let mut parts = Folder::parts(folder)?;
    let provenance = match (noted(folder), parts.values().next()) {
        (Some(provenance), _) => provenance,
        // The parts of one file, or copies.
        (None, Some(part)) => Opened::file(part)?.provenance,
        (None, None) => {
            let why = "there is neither a part nor a note of a plan in it".into();
            return Err(CampaignError::NoCampaign(folder.into(), why));
        }
    };
    let parts_wanted = provenance.parts();
    parts.retain(|&number, _| number < parts_wanted);
    let mut whole = BTreeSet::new();
    let mut written = vec![];
    let mut damaged = vec![];
    for (number, path) in parts {
        let opened = Opened::file(&path);
        match opened.and_then(|part| part.expect(Some(number), &provenance)) {
            Ok(_) => {
                whole.insert(number);
                written.extend(path.metadata().and_then(|m| m.modified()).ok());
            }
            // Another process has just replaced or removed it.
            Err(CampaignError::Read(_, ReadError::System(e)))
                if e.kind() == ErrorKind::NotFound => {}
            Err(error @ CampaignError::Read { .. }) => return Err(error),
            Err(_) => damaged.push(path),
        }
    }
    let shards_wanted = Folder::shards(folder)?;
    let shards: Vec<ShardStatus> = (1..=shards_wanted)
        .filter_map(|index| Shard::new(index, shards_wanted))
        .map(|shard| shard_status(folder, shard, &whole, parts_wanted))
        .collect();
    let count_of = |state| shards.iter().filter(|s| s.state == state).count() as u64;
    let parts = whole.len() as u64;
    let points_per_part = provenance.rows_of(Some(0)) as f64;
    let points_per_s = parts_per_s(written).map(|rate| rate * points_per_part);
    let running = count_of(ShardState::Running) > 0;
    let missing = (parts_wanted - parts) as f64 * points_per_part;
    Ok(CampaignStatus {
        points_per_s,
        left_s: points_per_s.filter(|_| running).map(|rate| missing / rate),
        output: folder.into(),
        complete: parts == parts_wanted,
        parts,
        parts_wanted,
        shards_wanted,
        shards_done: count_of(ShardState::Done),
        shards_running: count_of(ShardState::Running),
        shards_missing: count_of(ShardState::Missing),
        shards,
        damaged,
        plan_sha256: provenance.plan_sha256,
        version: provenance.version,
    })
}

/// The rate at which the newest parts were written.
fn parts_per_s(mut written: Vec<SystemTime>) -> Option<f64> {
    /// Older ones may be of an earlier run.
    const NEWEST: usize = 50;
    written.sort_unstable();
    let newest = &written[written.len().saturating_sub(NEWEST)..];
    let time = newest.last()?.duration_since(*newest.first()?).ok()?;
    let seconds = time.as_secs_f64();
    (seconds > 0.0).then(|| (newest.len() - 1) as f64 / seconds)
}

fn shard_status(folder: &Path, shard: Shard, whole: &BTreeSet<u64>, all: u64) -> ShardStatus {
    let parts_wanted = shard.blocks(all).count() as u64;
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
