//! Existing files, and whether they belong to a plan.

use super::run::{Counts, Outcome, Recomputed, Run};
use super::{Folder, MARKER, Opened, PartSource, Parts, Provenance, Which};
use crate::campaign::{CampaignError, Result};
use mckibben::threads::Threads;
use mckibben_io::files::{Unfinished, read};
use serde::{Deserialize, Serialize};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// The outcome of a run whose file exists, if that is of this plan.
pub(super) fn finished(provenance: &Provenance, out: &Path, parts: &Path) -> Result<Outcome> {
    of_this_plan(provenance, out, Which::Whole)?;
    if parts.is_dir() {
        // A run was killed between writing the file and removing its parts.
        match Folder::for_writing(parts, None) {
            Ok(folder) => {
                let mine = |part: &PathBuf| match Opened::file(part) {
                    Ok(opened) => belongs(&opened.provenance, provenance, part).is_ok(),
                    Err(error) => matches!(error, CampaignError::Damaged { .. }),
                };
                let all = Folder::parts(parts)?;
                folder.remove(
                    all.into_iter()
                        .filter(|(_, part)| mine(part))
                        .map(|(number, _)| number),
                )?;
            }
            Err(CampaignError::Locked { .. }) => {}
            Err(error) => return Err(error),
        }
    }
    let of = provenance.muscles;
    let counts = Counts {
        muscles: of,
        of,
        resumed: of,
        ..Counts::default()
    };
    Ok(Outcome::new(provenance, out, out, counts))
}

/// An existing file, if it is this share of this plan; a file of something else is not replaced.
fn of_this_plan(provenance: &Provenance, path: &Path, which: Which) -> Result<Opened> {
    let opened = Opened::file(path).map_err(|error| match error {
        CampaignError::NoCampaign(path, why) => CampaignError::Foreign(path, why),
        error => error,
    });
    opened?.expect(which, provenance)
}

impl Run<'_> {
    /// The existing parts of the share of a run, and the damaged ones. Of the other shares one part
    /// is checked: a thousand shards that read one another's parts would read the table a thousand
    /// times. With `overwrite` those that are not of this plan are taken for damaged.
    pub fn existing(&self, folder: &Folder, threads: &Threads) -> Result<(Parts, Vec<Recomputed>)> {
        let (provenance, overwrite) = (self.provenance, self.options.overwrite);
        let mut others = 0;
        let mut is_checked = |part: &(u64, PathBuf)| {
            others += u64::from(!self.holds(part.0));
            self.holds(part.0) || others == 1
        };
        let parts: Vec<(u64, PathBuf)> = Folder::parts(&folder.path)?
            .into_iter()
            .filter(&mut is_checked)
            .collect();
        let cause = |(number, path): &(u64, PathBuf)| {
            let opened = of_this_plan(provenance, path, Which::Part(*number));
            match opened.and_then(Opened::checked) {
                Ok(_) => Ok(None),
                Err(CampaignError::Damaged(_, why)) => Ok(Some(why)),
                Err(error @ CampaignError::Read { .. }) => Err(error),
                Err(error) if overwrite => Ok(Some(error.to_string())),
                Err(error) => Err(error),
            }
        };
        let checked = threads.map(&parts, cause);
        let (mut whole, mut damaged) = (Parts::new(), vec![]);
        for ((number, path), checked) in parts.into_iter().zip(checked) {
            match checked? {
                None if self.holds(number) => drop(whole.insert(number, PartSource::File(path))),
                Some(_) if self.holds(number) && overwrite && number >= provenance.parts() => {
                    folder.discard(&path)?
                }
                Some(cause) if self.holds(number) => damaged.push(Recomputed { file: path, cause }),
                _ => {}
            }
        }
        Ok((whole, damaged))
    }
}

/// Whether a file is of this plan and this program.
pub(super) fn belongs(theirs: &Provenance, ours: &Provenance, path: &Path) -> Result<()> {
    let name = path.display();
    if theirs.plan_sha256 != ours.plan_sha256 {
        let (theirs, ours) = (&theirs.plan_sha256, &ours.plan_sha256);
        return Err(CampaignError::OtherPlan(format!(
            "{name} contains a campaign of another plan (sha256 {theirs:.12}, this plan has \
             {ours:.12})"
        )));
    }
    if theirs.version != ours.version {
        let (theirs, ours) = (&theirs.version, &ours.version);
        let message =
            format!("{name} was written by mckibben {theirs}, and this is version {ours}");
        return Err(CampaignError::OtherPlan(message));
    }
    let why = "its metadata are not those of this plan";
    if theirs == ours {
        Ok(())
    } else {
        Err(CampaignError::damaged(path, why))
    }
}

/// Its longest file in bytes.
const LONGEST: u64 = 1 << 16;

/// The plan and version of a folder: the first process writes it, every other one must agree.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Marker {
    pub(super) version: String,
    pub(super) plan_sha256: String,
    pub(super) parts: u64,
}

impl Marker {
    pub(super) fn new(provenance: &Provenance) -> Self {
        let Provenance {
            version,
            plan_sha256,
            ..
        } = provenance.clone();
        Self {
            version,
            plan_sha256,
            parts: provenance.parts(),
        }
    }

    pub(super) fn read(folder: &Path) -> Option<Self> {
        serde_json::from_slice(&read(&folder.join(MARKER), LONGEST).ok()?).ok()
    }

    /// Claims a folder for a plan; one of another plan or version is refused.
    pub(super) fn claim(folder: &Path, provenance: &Provenance, overwrite: bool) -> Result<()> {
        let path = folder.join(MARKER);
        let ours = Self::new(provenance);
        // Another process may write it between the two steps: it is read again.
        for _ in 0..2 {
            match Self::read(folder) {
                Some(theirs) if theirs == ours => return Ok(()),
                Some(theirs) if !overwrite => {
                    let Self {
                        version,
                        plan_sha256,
                        ..
                    } = theirs;
                    let theirs = Provenance {
                        version,
                        plan_sha256,
                        ..provenance.clone()
                    };
                    return belongs(&theirs, provenance, folder);
                }
                known => {
                    // Parts that were copied have no such file.
                    if let (None, false, Some(part)) = (
                        &known,
                        overwrite,
                        Folder::parts(folder)?.into_values().next(),
                    ) && let Ok(opened) = Opened::file(&part)
                    {
                        belongs(&opened.provenance, provenance, &part)?;
                    }
                    let put = || {
                        let exists = known.is_some() || path.exists();
                        let text = serde_json::to_string(&ours)?;
                        Unfinished::inside(&path, exists)?
                            .with(text.as_bytes())?
                            .put(exists)
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
