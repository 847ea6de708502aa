//! The record of what was submitted for a folder.

use super::engine::SubmitEngine;
use super::slurm;
use crate::campaign::CampaignError;
use mckibben_files::{read, replace};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Longest template and record in bytes.
pub(super) const LONGEST: u64 = 1 << 20;

/// What was submitted for a folder.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(in crate::campaign) struct Record {
    pub(super) engine: SubmitEngine,
    pub(in crate::campaign) shards: u64,
    pub(super) arrays: Vec<String>,
    pub(super) merges: Vec<String>,
}

/// Where the record, the plan and the script of a folder are.
pub(super) fn place(folder: &Path) -> PathBuf {
    folder.join(".submitted")
}

impl Record {
    pub(in crate::campaign) fn read(folder: &Path) -> Option<Self> {
        serde_json::from_slice(&read(&place(folder).join("jobs.json"), LONGEST).ok()?).ok()
    }

    /// Shards that wait in the queue; none where the engine cannot be asked from here.
    pub(in crate::campaign) fn waiting(&self) -> BTreeSet<u64> {
        match self.engine {
            SubmitEngine::Slurm => slurm::waiting(&self.arrays),
        }
    }

    /// Writes it beside the parts.
    pub(super) fn write(&self, folder: &Path, dry_run: bool) -> Result<(), CampaignError> {
        if dry_run {
            return Ok(());
        }
        let path = place(folder).join("jobs.json");
        let text = serde_json::to_vec(self).map_err(|e| CampaignError::Encode(e.to_string()))?;
        replace(&path, &text).map_err(CampaignError::write(&path))
    }
}
