//! How a run ended.

use super::store::Provenance;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// How far a run came.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
pub struct Counts {
    /// Muscles that are done, those of earlier runs among them.
    pub muscles: u64,
    /// Muscles of the plan, or of the share of it.
    #[serde(rename = "muscles_wanted")]
    pub of: u64,
    /// Muscles that were there already.
    #[serde(rename = "muscles_resumed")]
    pub resumed: u64,
    /// Points of this run.
    #[serde(rename = "points_computed")]
    pub points: u64,
    /// Points of this run without an answer.
    #[serde(rename = "points_failed")]
    pub failed: u64,
}

/// A file that was damaged and has been computed anew.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Recomputed {
    /// The file.
    pub file: PathBuf,
    /// What was wrong with it.
    pub cause: String,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
pub struct Outcome {
    /// What was to be written.
    pub output: PathBuf,
    /// The share of the plan, i/n; nothing where it was all of it.
    pub shard: Option<String>,
    /// Whether all of the plan, or of the share of it, is there.
    pub complete: bool,
    /// How far it came.
    #[serde(flatten)]
    pub counts: Counts,
    /// Points that are there.
    pub points: u64,
    /// SHA-256 of the plan's text.
    pub plan_sha256: String,
    /// Files that were damaged and have been computed anew.
    pub recomputed: Vec<Recomputed>,
    /// Where unfinished work lies.
    #[serde(skip)]
    pub store: PathBuf,
}

impl Outcome {
    pub(super) fn new(provenance: &Provenance, output: &Path, store: &Path, counts: Counts) -> Self {
        Self {
            output: output.into(),
            shard: None,
            complete: counts.muscles == counts.of,
            counts,
            points: counts.muscles * provenance.points_per_muscle,
            plan_sha256: provenance.plan_sha256.clone(),
            recomputed: vec![],
            store: store.into(),
        }
    }
}
