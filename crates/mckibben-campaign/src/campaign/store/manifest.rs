//! The plan and version of a folder: the first process writes it, every other one must agree.

use super::{
    file::Opened,
    folder::{Folder, MANIFEST},
    provenance::Provenance,
};
use crate::campaign::error::{CampaignError, Result};
use mckibben_io::files::{Unfinished, read};
use serde::{Deserialize, Serialize};
use std::{io::ErrorKind, path::Path};

/// Its longest file in bytes.
const LONGEST: u64 = 1 << 16;

/// What a folder is of.
#[derive(PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    pub version: String,
    pub plan_sha256: String,
    pub parts: u64,
}

impl Manifest {
    pub fn new(provenance: &Provenance) -> Self {
        Self {
            version: provenance.version.clone(),
            plan_sha256: provenance.plan_sha256.clone(),
            parts: provenance.parts(),
        }
    }

    pub fn read(folder: &Path) -> Option<Self> {
        serde_json::from_slice(&read(&folder.join(MANIFEST), LONGEST).ok()?).ok()
    }

    /// Claims a folder for a plan; one of another plan or version is refused.
    pub fn claim(folder: &Path, provenance: &Provenance, overwrite: bool) -> Result<()> {
        let path = folder.join(MANIFEST);
        let ours = Self::new(provenance);
        // Another process may write it between the two steps: it is read again.
        for _ in 0..2 {
            let theirs = Self::read(folder);
            if theirs.as_ref() == Some(&ours) {
                return Ok(());
            }
            if let (Some(theirs), false) = (theirs, overwrite) {
                return provenance.check_plan(&theirs.version, &theirs.plan_sha256, folder);
            }
            // Parts that were copied have no such file.
            if !overwrite
                && let Some(part) = Folder::parts(folder)?.into_values().next()
                && let Ok(opened) = Opened::file(&part)
            {
                provenance.check_same(&opened.provenance, &part)?;
            }
            let put = || {
                let text = serde_json::to_vec(&ours)?;
                let exists = path.exists();
                Unfinished::inside(&path, exists)?
                    .with_content(&text)?
                    .put(exists)
            };
            match put() {
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                put => return put.map_err(CampaignError::write(&path)),
            }
        }
        Ok(())
    }
}
