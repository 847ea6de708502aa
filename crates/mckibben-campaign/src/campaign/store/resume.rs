//! Existing files, and whether they belong to a plan.

use super::{file::Opened, folder::Folder, provenance::Provenance};
use crate::campaign::error::{CampaignError, Result};
use mckibben_core::threads::Threads;
use serde::Serialize;
use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

/// A damaged file that was computed again.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Recomputed {
    /// The file.
    pub file: PathBuf,
    /// Its damage.
    pub cause: String,
}

/// An existing file, if it is this share of this plan; a file of something else is not replaced.
fn of_this_plan(provenance: &Provenance, path: &Path, part: Option<u64>) -> Result<Opened> {
    Opened::file(path)
        .map_err(|error| match error {
            CampaignError::NoCampaign(path, why) => CampaignError::Foreign(path, why),
            error => error,
        })?
        .expect(part, provenance)
}

/// Checks that an existing file is the whole table of this plan, and removes the parts that a run
/// left which was killed behind writing it.
pub fn finished(provenance: &Provenance, out: &Path, parts: &Path) -> Result<()> {
    of_this_plan(provenance, out, None)?;
    if !parts.is_dir() {
        return Ok(());
    }
    let folder = match Folder::for_writing(parts, None) {
        Err(CampaignError::Locked { .. }) => return Ok(()),
        folder => folder?,
    };
    let mut left = Folder::parts(parts)?;
    left.retain(|_, part| match Opened::file(part) {
        Ok(opened) => provenance.check_same(&opened.provenance, part).is_ok(),
        Err(error) => matches!(error, CampaignError::Damaged { .. }),
    });
    folder.remove(left.into_keys())
}

/// The existing parts that a process `holds`, and the damaged ones. Of the other shares one part is
/// checked: a thousand shards that read one another's parts would read the table a thousand times.
/// With `overwrite` those that are not of this plan are taken for damaged.
pub fn existing(
    folder: &Folder,
    provenance: &Provenance,
    holds: impl Fn(u64) -> bool,
    overwrite: bool,
    threads: &Threads,
) -> Result<(BTreeSet<u64>, Vec<Recomputed>)> {
    let mut has_other = false;
    let mut is_checked = |number| holds(number) || !std::mem::replace(&mut has_other, true);
    let mut parts = Folder::parts(&folder.path)?;
    parts.retain(|&number, _| is_checked(number));
    let parts: Vec<(u64, PathBuf)> = parts.into_iter().collect();
    let damage =
        |(number, path): &(u64, PathBuf)| match of_this_plan(provenance, path, Some(*number)) {
            Ok(_) => Ok(None),
            Err(CampaignError::Damaged(_, why)) => Ok(Some(why)),
            Err(error) if overwrite && !matches!(error, CampaignError::Read { .. }) => {
                Ok(Some(error.to_string()))
            }
            Err(error) => Err(error),
        };
    let mut whole = BTreeSet::new();
    let mut damaged = vec![];
    for ((number, file), damage) in parts.iter().zip(threads.map(&parts, damage)) {
        match damage? {
            _ if !holds(*number) => {}
            None => drop(whole.insert(*number)),
            Some(_) if overwrite && *number >= provenance.parts() => folder.discard(file)?,
            Some(cause) => damaged.push(Recomputed {
                file: file.clone(),
                cause,
            }),
        }
    }
    Ok((whole, damaged))
}
