//! Of which plan a folder of parts is. It is no data: a folder without it is the same campaign.

use super::CampaignError;
use super::resume::belongs;
use super::store::{Folder, MARKER, Opened, Provenance};
use mckibben_io::files::{Unfinished, read};
use serde::{Deserialize, Serialize};
use std::io::ErrorKind;
use std::path::Path;

/// Its longest file in bytes.
const LONGEST: u64 = 1 << 16;

/// Of which plan and version a folder is: the first process writes it, every other one must agree.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Marker {
    pub(super) version: String,
    pub(super) plan_sha256: String,
    pub(super) parts: u64,
}

impl Marker {
    pub(super) fn of(provenance: &Provenance) -> Self {
        Self {
            version: provenance.version.clone(),
            plan_sha256: provenance.plan_sha256.clone(),
            parts: provenance.parts(),
        }
    }

    pub(super) fn read(folder: &Path) -> Option<Self> {
        serde_json::from_slice(&read(&folder.join(MARKER), LONGEST).ok()?).ok()
    }

    /// Claims a folder for a plan; one of another plan or version is refused.
    pub(super) fn claim(
        folder: &Path,
        provenance: &Provenance,
        overwrite: bool,
    ) -> Result<(), CampaignError> {
        let path = folder.join(MARKER);
        let ours = Self::of(provenance);
        // Written by another process between the look and the write, it is looked at again.
        for _ in 0..2 {
            match Self::read(folder) {
                Some(theirs) if theirs == ours => return Ok(()),
                Some(theirs) if !overwrite => {
                    let Self { version, plan_sha256, .. } = theirs;
                    let theirs = Provenance { version, plan_sha256, ..provenance.clone() };
                    return belongs(&theirs, provenance, folder);
                }
                there => {
                    // Parts that were copied may be there alone.
                    if let (None, false, Some(part)) =
                        (&there, overwrite, Folder::parts(folder)?.into_values().next())
                        && let Ok(opened) = Opened::file(&part)
                    {
                        belongs(&opened.provenance, provenance, &part)?;
                    }
                    let text =
                        serde_json::to_string(&ours).map_err(|e| CampaignError::Encode(e.to_string()))?;
                    let put = || {
                        let there = there.is_some() || path.exists();
                        Unfinished::inside(&path, there)?.with(text.as_bytes())?.put(there)
                    };
                    match put() {
                        Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                        put => return put.map_err(CampaignError::write(&path)),
                    }
                }
            }
        }
        Ok(())
    }
}
