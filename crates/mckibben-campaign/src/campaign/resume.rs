//! What is there already, and whether it belongs to a plan.

use super::CampaignError;
use super::outcome::{Counts, Outcome, Recomputed};
use super::store::{Folder, Opened, PartSource, Provenance, Which};
use mckibben::threads::Threads;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// There is the file already: nothing is to be done, if it is that of this plan.
pub(super) fn finished(provenance: &Provenance, out: &Path, parts: &Path) -> Result<Outcome, CampaignError> {
    let opened = of_this_plan(provenance, out)?;
    if opened.which != Which::Whole {
        return Err(CampaignError::damaged(out, "it contains only a part of the campaign"));
    }
    if parts.is_dir() {
        // A run was killed between writing the file and removing its parts.
        match Folder::for_writing(parts, None) {
            Ok(folder) => {
                let mine = |part: &PathBuf| match Opened::file(part) {
                    Ok(opened) => belongs(&opened.provenance, provenance, part).is_ok(),
                    Err(error) => matches!(error, CampaignError::Damaged { .. }),
                };
                let all = Folder::parts(parts)?;
                folder.remove(all.into_iter().filter(|(_, part)| mine(part)).map(|(number, _)| number))?;
            }
            Err(CampaignError::Locked { .. }) => {}
            Err(error) => return Err(error),
        }
    }
    let of = provenance.muscles;
    let counts = Counts { muscles: of, of, resumed: of, ..Counts::default() };
    Ok(Outcome::new(provenance, out, out, counts))
}

/// A file that is there already, if it is of this plan.
pub(super) fn of_this_plan(provenance: &Provenance, path: &Path) -> Result<Opened, CampaignError> {
    let opened = Opened::file(path).map_err(foreign)?;
    belongs(&opened.provenance, provenance, path)?;
    Ok(opened)
}

/// What is no campaign is not replaced.
fn foreign(error: CampaignError) -> CampaignError {
    match error {
        CampaignError::NoCampaign { path, why } => CampaignError::Foreign { path, why },
        error => error,
    }
}

/// The parts that are there and whole, and those that are damaged, with what is wrong with them.
pub(super) type There = (BTreeMap<u64, PartSource>, Vec<Recomputed>);

/// Looks through the parts of a share in a folder with their bytes, and through one of the others: a thousand shards that read one another's
/// parts would read the table a thousand times. With `overwrite` those that are not of this plan are taken for damaged.
pub(super) fn there(
    folder: &Folder,
    provenance: &Provenance,
    mine: &impl Fn(&u64) -> bool,
    overwrite: bool,
    threads: &Threads,
) -> Result<There, CampaignError> {
    let mut others = 0;
    let mut looked_at = |part: &(u64, PathBuf)| {
        others += u64::from(!mine(&part.0));
        mine(&part.0) || others == 1
    };
    let parts: Vec<(u64, PathBuf)> =
        Folder::parts(&folder.path)?.into_iter().filter(&mut looked_at).collect();
    let cause =
        |(number, path): &(u64, PathBuf)| match of_this_plan(provenance, path).and_then(Opened::checked) {
            Ok(opened) => {
                let right = opened.which == Which::Part(*number);
                Ok((!right).then(|| "it contains a different part from its name".to_owned()))
            }
            Err(CampaignError::Damaged { why, .. }) => Ok(Some(why)),
            Err(error @ CampaignError::Read { .. }) => Err(error),
            Err(error) if overwrite => Ok(Some(error.to_string())),
            Err(error) => Err(error),
        };
    let checked = threads.map(&parts, cause);
    let (mut whole, mut damaged) = (BTreeMap::new(), vec![]);
    for ((number, path), checked) in parts.into_iter().zip(checked) {
        match checked? {
            None if mine(&number) => drop(whole.insert(number, PartSource::File(path))),
            None => {}
            Some(_) if mine(&number) && overwrite && number >= provenance.parts() => folder.discard(&path)?,
            Some(cause) if mine(&number) => damaged.push(Recomputed { file: path, cause }),
            Some(_) => {}
        }
    }
    Ok((whole, damaged))
}

/// Whether a file is of this plan and this program.
pub(super) fn belongs(theirs: &Provenance, ours: &Provenance, path: &Path) -> Result<(), CampaignError> {
    if theirs.plan_sha256 != ours.plan_sha256 {
        let (theirs, ours) = (theirs.plan_sha256.clone(), ours.plan_sha256.clone());
        return Err(CampaignError::OtherPlan { path: path.into(), theirs, ours });
    }
    if theirs.version != ours.version {
        let (theirs, ours) = (theirs.version.clone(), ours.version.clone());
        return Err(CampaignError::OtherVersion { path: path.into(), theirs, ours });
    }
    if theirs == ours {
        Ok(())
    } else {
        Err(CampaignError::damaged(path, "its metadata are not those of this plan"))
    }
}
