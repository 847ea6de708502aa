//! How far a campaign in a folder is, shard by shard: from names and states alone, at any time and from any machine.

use super::state::{Marker, Phase, State, host};
use super::store::{Folder, Opened};
use super::submit::record::Record;
use super::{CampaignError, Shard};
use mckibben_files::ReadError;
use serde::Serialize;
use std::collections::BTreeSet;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Without a sign of life for so long a shard of another machine is taken for dead: eight signs, and twice the longest time for which a client
/// of NFS believes what it has read.
const SILENT: Duration = Duration::from_secs(120);

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum ShardState {
    /// All its parts are there.
    Done,
    /// A process computes it.
    Running,
    /// Its engine will start it.
    Waiting,
    /// Its process died or ended with an error.
    Failed,
    /// Nothing computes it, and parts are missing.
    Missing,
}

impl ShardState {
    pub fn name(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Running => "running",
            Self::Waiting => "waiting",
            Self::Failed => "failed",
            Self::Missing => "missing",
        }
    }
}

#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ShardStatus {
    /// The share, i/n.
    pub shard: String,
    pub state: ShardState,
    /// Parts that are there.
    pub parts: u64,
    /// Parts of the share.
    pub parts_wanted: u64,
    /// The machine that computes or computed it; empty where none did.
    pub host: String,
    /// Time since its last sign of life in seconds, where it gave one.
    pub silent_s: Option<f64>,
    /// Why it failed; empty where it did not.
    pub cause: String,
}

/// A campaign in a folder.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CampaignStatus {
    pub output: PathBuf,
    /// Whether all parts are there.
    pub complete: bool,
    /// Parts that are there.
    pub parts: u64,
    /// Parts of the plan.
    pub parts_wanted: u64,
    /// Muscles of the plan.
    pub muscles_wanted: u64,
    pub shards_wanted: u64,
    pub shards_done: u64,
    /// Shards that a process computes.
    pub shards_running: u64,
    /// Shards that wait in the queue of an engine.
    pub shards_waiting: u64,
    /// Shards whose process died or ended with an error.
    pub shards_failed: u64,
    /// Shards that nothing computes.
    pub shards_missing: u64,
    pub shards: Vec<ShardStatus>,
    /// Parts that are damaged; they count as missing.
    pub damaged: Vec<PathBuf>,
    /// SHA-256 of the plan's text.
    pub plan_sha256: String,
    /// Version of the program.
    pub version: String,
}

impl CampaignStatus {
    /// Whether something is missing that nothing computes and no engine will start.
    pub fn has_gap(&self) -> bool {
        self.shards_failed + self.shards_missing > 0
    }

    /// Whether something is under way.
    pub fn is_under_way(&self) -> bool {
        self.shards_running + self.shards_waiting > 0
    }
}

/// Looks at a folder of parts.
pub fn status(folder: &Path) -> Result<CampaignStatus, CampaignError> {
    let parts = Folder::parts(folder)?;
    let record = Record::read(folder);
    let marker = match (Marker::read(folder), parts.values().next()) {
        (Some(marker), _) => marker,
        // A folder of an earlier version.
        (None, Some(part)) => Marker::of(&Opened::file(part)?.provenance),
        (None, None) => {
            let why = "there is neither a part nor a note of a plan in it".into();
            return Err(CampaignError::NoCampaign { path: folder.into(), why });
        }
    };
    let mut there = BTreeSet::new();
    let mut damaged = vec![];
    for (number, path) in parts.into_iter().filter(|part| part.0 < marker.parts) {
        match Opened::file(&path) {
            Ok(_) => drop(there.insert(number)),
            // Another process has just replaced or removed it.
            Err(CampaignError::Read { source: ReadError::System(e), .. })
                if e.kind() == ErrorKind::NotFound => {}
            Err(error @ CampaignError::Read { .. }) => return Err(error),
            Err(_) => damaged.push(path),
        }
    }
    let states = State::all(folder);
    let newest = states.iter().max_by_key(|(_, path)| path.metadata().and_then(|m| m.modified()).ok());
    let count =
        record.as_ref().map(|r| r.shards).or_else(|| newest.map(|(shard, _)| shard.count())).unwrap_or(1);
    let waiting = record.map(|record| record.waiting()).unwrap_or_default();
    let here = host();
    let one = |index| {
        let shard = Shard::new(index, count)?;
        let (mut wanted, mut have) = (0, 0);
        for part in shard.blocks(marker.parts) {
            wanted += 1;
            have += u64::from(there.contains(&part));
        }
        let path = states.iter().find(|s| s.0 == shard).map(|s| &s.1);
        let state = path.and_then(|path| State::read(path));
        let age = path.and_then(|path| path.metadata().ok()?.modified().ok()?.elapsed().ok());
        let silent = age.is_some_and(|age| age > SILENT);
        let locked = state.as_ref().filter(|s| s.host == here).and_then(|_| Folder::is_locked(folder, shard));
        let (mut word, mut cause) = (ShardState::Missing, String::new());
        match &state {
            _ if have == wanted => word = ShardState::Done,
            Some(s) if s.phase == Phase::Running && locked.unwrap_or(!silent) => word = ShardState::Running,
            _ if waiting.contains(&index) => word = ShardState::Waiting,
            Some(s) if s.phase == Phase::Running => {
                word = ShardState::Failed;
                cause = format!("process {} ended without a word", s.process);
            }
            Some(s) if s.phase == Phase::Failed => (word, cause) = (ShardState::Failed, s.cause.clone()),
            Some(s) if s.phase == Phase::Stopped => cause = "it was stopped".into(),
            _ => {}
        }
        Some(ShardStatus {
            shard: shard.to_string(),
            state: word,
            parts: have,
            parts_wanted: wanted,
            host: state.map(|s| s.host).unwrap_or_default(),
            silent_s: age.map(|age| age.as_secs_f64()),
            cause,
        })
    };
    let shards: Vec<ShardStatus> = (1..=count).filter_map(one).collect();
    let of = |state| shards.iter().filter(|s| s.state == state).count() as u64;
    Ok(CampaignStatus {
        output: folder.into(),
        complete: there.len() as u64 == marker.parts,
        parts: there.len() as u64,
        parts_wanted: marker.parts,
        muscles_wanted: marker.muscles,
        shards_wanted: count,
        shards_done: of(ShardState::Done),
        shards_running: of(ShardState::Running),
        shards_waiting: of(ShardState::Waiting),
        shards_failed: of(ShardState::Failed),
        shards_missing: of(ShardState::Missing),
        shards,
        damaged,
        plan_sha256: marker.plan_sha256,
        version: marker.version,
    })
}
