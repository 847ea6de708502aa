//! The plan and version of a folder: the first process writes it, every other one must agree.

use super::{
    file::Opened,
    folder::{Folder, MANIFEST},
    provenance::Provenance,
};
use crate::campaign::error::{CampaignError, Result};
use mckibben_io::files::{Unfinished, read};
use std::{io::ErrorKind, path::Path};

/// Its longest file in bytes.
const LONGEST: u64 = 1 << 24;

/// What a folder is of, where that is noted.
pub fn noted(folder: &Path) -> Option<Provenance> {
    let text = read(&folder.join(MANIFEST), LONGEST).ok()?;
    Some(Provenance::from_json(&text).ok()?.0)
}

/// Claims a folder for a plan; one of another plan or version is refused.
pub fn claim(folder: &Path, provenance: &Provenance) -> Result<()> {
    let path = folder.join(MANIFEST);
    // Another process may write it between the two steps: it is read again.
    for _ in 0..2 {
        let theirs = noted(folder);
        if theirs.as_ref() == Some(provenance) {
            return Ok(());
        }
        if let Some(theirs) = theirs {
            return provenance.check_same(&theirs, folder);
        }
        // Parts that were copied have no such file.
        if let Some(part) = Folder::parts(folder)?.into_values().next()
            && let Ok(opened) = Opened::file(&part)
        {
            provenance.check_same(&opened.provenance, &part)?;
        }
        let put = || {
            let exists = path.exists();
            let text = provenance.to_json(None)?;
            Unfinished::inside(&path, exists)?
                .with_content(text.as_bytes())?
                .put(exists)
        };
        match put() {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            put => return put.map_err(CampaignError::write(&path)),
        }
    }
    Ok(())
}
