//! Parts → one file.

use super::{
    file::{Opened, chained, write},
    folder::{Folder, is_file_name, part_name},
    provenance::Provenance,
};
use crate::campaign::error::{CampaignError, Result};
use mckibben_io::files::{Unfinished, sync};
use serde::Serialize;
use std::{
    collections::BTreeMap,
    io::ErrorKind,
    path::{Path, PathBuf},
};

/// A merged campaign.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Merged {
    /// The file.
    pub output: PathBuf,
    /// Muscles in it.
    pub muscles: u64,
    /// Points in it.
    pub points: u64,
    /// Parts that it was made of.
    pub parts: u64,
    /// SHA-256 of the plan's text.
    pub plan_sha256: String,
}

/// A campaign of which all parts are there, each in its file.
pub struct Parts {
    pub provenance: Provenance,
    /// In their order.
    pub files: Vec<PathBuf>,
}

impl Parts {
    /// All parts of some folders; none may be missing.
    pub fn gather(folders: &[PathBuf]) -> Result<Self> {
        let mut parts: BTreeMap<u64, PathBuf> = BTreeMap::new();
        for folder in folders {
            for (number, path) in Folder::parts(folder)? {
                if let Some(first) = parts.get(&number) {
                    check_equal(first, &path)?;
                } else {
                    parts.insert(number, path);
                }
            }
        }
        let folder = folders.first().cloned().unwrap_or_default();
        let Some(first) = parts.values().next() else {
            return Err(CampaignError::NoCampaign(
                folder,
                "there is no part in it".into(),
            ));
        };
        let provenance = Opened::file(first)?.provenance;
        let count = provenance.parts();
        // Not one after another: the count is read from the file.
        let missing = count - parts.range(..count).count() as u64;
        if let Some(first) = (0..count).find(|p| !parts.contains_key(p)) {
            let folder = folder.display();
            let first = part_name(first);
            return Err(CampaignError::Incomplete(format!(
                "{folder} is incomplete: {missing} of {count} parts are missing, the first is \
                 {first}"
            )));
        }
        if let Some((_, path)) = parts.range(count..).next() {
            return Err(CampaignError::damaged(
                path,
                format!("the plan has only {count} parts"),
            ));
        }
        Ok(Self {
            provenance,
            files: parts.into_values().collect(),
        })
    }

    /// Each is opened when its turn comes, and checked against the plan it must belong to.
    pub fn opened(self) -> impl Iterator<Item = Result<Opened>> {
        (0..)
            .zip(self.files)
            .map(move |(number, file)| Opened::file(&file)?.expect(Some(number), &self.provenance))
    }

    /// Writes them as one file, which appears whole or not at all; with `clobber` instead of an
    /// existing file. One group of rows is held at a time.
    pub fn write(self, out: &Path, clobber: bool) -> Result<()> {
        Unfinished::sweep(out);
        let mut file = Unfinished::beside(out).map_err(CampaignError::write(out))?;
        let provenance = self.provenance.clone();
        write(
            &provenance,
            None,
            chained(self.opened(), Opened::tables),
            file.file(),
            out,
        )?;
        file.put(clobber).map_err(|error| match error.kind() {
            ErrorKind::AlreadyExists => CampaignError::Appeared(out.into()),
            _ => CampaignError::write(out)(error),
        })?;
        sync(out.parent().unwrap_or(Path::new("")));
        Ok(())
    }
}

/// Refuses two files for the same part that differ.
fn check_equal(first: &Path, second: &Path) -> Result<()> {
    let a = Opened::file(first)?;
    let b = Opened::file(second)?;
    a.provenance.check_same(&b.provenance, second)?;
    if a.checksum == b.checksum {
        Ok(())
    } else {
        Err(CampaignError::Conflict(first.into(), second.into()))
    }
}

/// Merges the parts in some folders into one file, the same bytes as those of a single run. An
/// existing file is replaced only with `overwrite`.
pub fn merge(folders: &[PathBuf], out: &Path, overwrite: bool) -> Result<Merged> {
    if !is_file_name(out) {
        return Err(CampaignError::other_format(out));
    }
    if out.exists() && !overwrite {
        return Err(CampaignError::Appeared(out.into()));
    }
    let parts = Parts::gather(folders)?;
    let of = &parts.provenance;
    let merged = Merged {
        output: out.into(),
        muscles: of.muscles,
        points: of.points(),
        parts: of.parts(),
        plan_sha256: of.plan_sha256.clone(),
    };
    parts.write(out, overwrite)?;
    Ok(merged)
}
