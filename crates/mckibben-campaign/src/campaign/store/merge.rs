//! Parts → one file.

use super::resume::belongs;
use super::{
    Folder, Opened, PartSource, Parts, Provenance, Which, flat, is_file_name, part_name, write,
};
use crate::campaign::{CampaignError, Result};
use mckibben_io::files::{Unfinished, sync};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

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

/// Writes all parts as one file, which appears whole or not at all; with `clobber` instead of an
/// existing file.
pub(super) fn write_whole(
    provenance: &Provenance,
    parts: Parts,
    out: &Path,
    clobber: bool,
) -> Result<()> {
    Unfinished::sweep(out);
    let mut file = Unfinished::beside(out).map_err(CampaignError::write(out))?;
    // Each is checked against the plan it must belong to; one group of rows is held at a time.
    let opened = parts
        .into_iter()
        .map(|(number, part)| part.open(number, provenance));
    write(
        provenance,
        Which::Whole,
        flat(opened, Opened::tables),
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

/// All parts of some folders; none may be missing.
pub(super) fn gather(folders: &[PathBuf]) -> Result<(Provenance, BTreeMap<u64, PathBuf>)> {
    let mut parts: BTreeMap<u64, PathBuf> = BTreeMap::new();
    for folder in folders {
        for (number, path) in Folder::parts(folder)? {
            match parts.get(&number) {
                None => drop(parts.insert(number, path)),
                Some(one) => {
                    // Both are checked.
                    let (a, b) = (Opened::file(one)?, Opened::file(&path)?);
                    belongs(&b.provenance, &a.provenance, &path)?;
                    let bytes = |p: &Path| std::fs::read(p).map_err(CampaignError::read(p));
                    if bytes(one)? != bytes(&path)? {
                        return Err(CampaignError::Conflict(one.clone(), path));
                    }
                }
            }
        }
    }
    let path = folders.first().cloned().unwrap_or_default();
    let Some(first) = parts.values().next() else {
        return Err(CampaignError::NoCampaign(
            path,
            "there is no part in it".into(),
        ));
    };
    let provenance = Opened::file(first)?.provenance;
    let count = provenance.parts();
    // Not one after another: the count is read from the file.
    let missing = count - parts.range(..count).count() as u64;
    if let Some(first) = (0..count).find(|p| !parts.contains_key(p)) {
        let (path, first) = (path.display(), part_name(first));
        return Err(CampaignError::Incomplete(format!(
            "{path} is incomplete: {missing} of {count} parts are missing, the first is {first}"
        )));
    }
    if let Some((_, path)) = parts.range(count..).next() {
        return Err(CampaignError::damaged(
            path,
            format!("the plan has only {count} parts"),
        ));
    }
    Ok((provenance, parts))
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
    let (provenance, parts) = gather(folders)?;
    let parts = parts
        .into_iter()
        .map(|(n, path)| (n, PartSource::File(path)))
        .collect();
    write_whole(&provenance, parts, out, overwrite)?;
    Ok(Merged {
        output: out.into(),
        muscles: provenance.muscles,
        points: provenance.points(),
        parts: provenance.parts(),
        plan_sha256: provenance.plan_sha256,
    })
}
