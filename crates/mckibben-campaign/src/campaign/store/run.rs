//! Runs a plan into a store.

use super::{
    file::part,
    folder::{Folder, check_name, is_file_name},
    manifest,
    merge::Parts,
    provenance::Provenance,
    resume::{Recomputed, existing, finished},
    shard::Shard,
    table::Table,
};
use crate::campaign::{
    error::{CampaignError, Result},
    plan::Plan,
    solve,
};
use mckibben_core::{progress::Progress, threads::Threads};
use mckibben_io::files::check_writable;
use serde::Serialize;
use std::{
    path::{Path, PathBuf},
    sync::atomic::{AtomicBool, Ordering},
};

/// How far a run came.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
pub struct Counts {
    /// Muscles that are done, those of earlier runs among them.
    pub muscles: u64,
    /// Muscles of the plan, or of the share of it.
    #[serde(rename = "muscles_wanted")]
    pub of: u64,
    /// Muscles of earlier runs.
    #[serde(rename = "muscles_resumed")]
    pub resumed: u64,
    /// Points of this run.
    #[serde(rename = "points_computed")]
    pub points: u64,
    /// Points of this run without an answer.
    #[serde(rename = "points_failed")]
    pub failed: u64,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
pub struct CampaignOutcome {
    /// The file or folder.
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
    /// Damaged files that were computed again.
    pub recomputed: Vec<Recomputed>,
    /// Where unfinished work lies.
    #[serde(skip)]
    pub store: PathBuf,
}

/// How a plan is run.
#[derive(Debug, Clone, Default)]
pub struct RunOptions {
    /// Only this share of the plan.
    pub shard: Option<Shard>,
    /// Threads; as many as there are cores where nothing is said.
    pub threads: Option<usize>,
    /// Replace existing files of other plans.
    pub overwrite: bool,
}

impl RunOptions {
    /// Whether a part is of its share.
    fn holds(&self, part: u64) -> bool {
        self.shard.is_none_or(|shard| shard.holds(part))
    }

    /// The parts of its share.
    pub(super) fn share(&self, provenance: &Provenance) -> impl Iterator<Item = u64> {
        (0..provenance.parts()).filter(|&part| self.holds(part))
    }
}

/// A part from a thread.
struct Done {
    part: u64,
    bytes: Vec<u8>,
    points: u64,
    failed: u64,
}

/// Runs a plan into `out`: one file if it ends in `.parquet`, else a folder of parts. Existing
/// parts are not computed again. It reports muscles; where the caller ends it, the store is valid
/// and not complete.
pub fn run(
    plan: &Plan,
    out: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<CampaignOutcome> {
    check_name(out)?;
    let one_file = is_file_name(out);
    let run = Run {
        plan,
        provenance: Provenance::for_plan(plan),
        out,
        store: if one_file { parts_of(out) } else { out.into() },
        options,
        progress,
    };
    if one_file {
        run.into_file()
    } else {
        run.into_folder()
    }
}

/// The folder of parts of a campaign that becomes one file.
fn parts_of(file: &Path) -> PathBuf {
    let mut name = file.file_name().unwrap_or_default().to_owned();
    name.push(".parts");
    file.with_file_name(name)
}

/// A run of a plan.
struct Run<'a> {
    plan: &'a Plan,
    provenance: Provenance,
    out: &'a Path,
    /// The folder of parts.
    store: PathBuf,
    options: &'a RunOptions,
    progress: &'a dyn Progress,
}

impl Run<'_> {
    fn outcome(
        &self,
        store: &Path,
        counts: Counts,
        recomputed: Vec<Recomputed>,
    ) -> CampaignOutcome {
        CampaignOutcome {
            output: self.out.into(),
            shard: self.options.shard.map(|shard| shard.to_string()),
            complete: counts.muscles == counts.of,
            counts,
            points: counts.muscles * self.provenance.points_per_muscle,
            plan_sha256: self.provenance.plan_sha256.clone(),
            recomputed,
            store: store.into(),
        }
    }

    /// The outcome where the file exists, if that is of this plan.
    fn finished(&self) -> Result<CampaignOutcome> {
        finished(&self.provenance, self.out, &self.store)?;
        let of = self.provenance.muscles;
        let counts = Counts {
            muscles: of,
            of,
            resumed: of,
            ..Counts::default()
        };
        Ok(self.outcome(self.out, counts, vec![]))
    }

    /// Runs into a folder of parts.
    fn into_folder(self) -> Result<CampaignOutcome> {
        if self.out.is_file() {
            let why =
                "it is a file, and parts go into a folder; a campaign in one file ends in .parquet";
            return Err(CampaignError::NoCampaign(self.out.into(), why.into()));
        }
        self.complete(&self.claimed()?)
    }

    /// The folder of parts, claimed for the plan. What is there of another plan is removed by a
    /// process that has the folder for itself.
    fn claimed(&self) -> Result<Folder> {
        let open = |shard| Folder::for_writing(&self.store, shard);
        let claim = || manifest::claim(&self.store, &self.provenance);
        let is_replaced =
            || matches!(claim(), Err(CampaignError::OtherPlan(_))) && self.options.overwrite;
        let folder = open(self.options.shard)?;
        if !is_replaced() {
            return claim().map(|()| folder);
        }
        drop(folder);
        let alone = open(None)?;
        // Another process may have done it since.
        if is_replaced() {
            alone.clear()?;
        }
        claim()?;
        drop(alone);
        open(self.options.shard)
    }

    /// Runs into one file, by way of a folder of parts.
    fn into_file(self) -> Result<CampaignOutcome> {
        let out = self.out;
        let overwrite = self.options.overwrite;
        if self.options.shard.is_some() {
            return Err(CampaignError::Refused(
                format!(
                    "a shard writes parts, and {} would be one file",
                    out.display()
                ),
                "give a folder, and merge the parts into a file when all shards are there",
            ));
        }
        let is_replaced = out.exists();
        if is_replaced {
            check_writable(out).map_err(CampaignError::write(out))?;
            match self.finished() {
                Err(error) if overwrite && !matches!(error, CampaignError::Read { .. }) => {}
                done => return done,
            }
        }
        let folder = self.claimed()?;
        if out.exists() && !is_replaced {
            // Another process finished it since.
            drop(folder);
            return self.finished();
        }
        let outcome = self.complete(&folder)?;
        if !outcome.complete {
            return Ok(outcome);
        }
        if out.exists() && !overwrite {
            return Err(CampaignError::Appeared(out.into()));
        }
        let numbers = 0..self.provenance.parts();
        let mut files = Folder::parts(&self.store)?;
        files.retain(|part, _| numbers.contains(part));
        let parts = Parts {
            provenance: self.provenance,
            files: files.into_values().collect(),
        };
        parts.write(out, overwrite)?;
        folder.remove(numbers)?;
        Ok(outcome)
    }

    /// Computes the missing parts of a folder.
    fn complete(&self, folder: &Folder) -> Result<CampaignOutcome> {
        let RunOptions {
            threads, overwrite, ..
        } = *self.options;
        let limited = threads.map(Threads::new).transpose()?;
        let threads = limited.as_ref().unwrap_or_else(|| Threads::shared());
        let holds = |part| self.options.holds(part);
        let (there, recomputed) = existing(folder, &self.provenance, holds, overwrite, threads)?;
        let share = || self.options.share(&self.provenance);
        let missing: Vec<u64> = share().filter(|part| !there.contains(part)).collect();
        let resumed = self.provenance.muscles_in(there.into_iter());
        let mut counts = Counts {
            muscles: resumed,
            of: self.provenance.muscles_in(share()),
            resumed,
            ..Counts::default()
        };
        self.compute_all(&missing, threads, folder, &mut counts)?;
        Ok(self.outcome(&self.store, counts, recomputed))
    }

    /// Computes parts and writes them, as far as the caller does not end it.
    fn compute_all(
        &self,
        missing: &[u64],
        threads: &Threads,
        folder: &Folder,
        counts: &mut Counts,
    ) -> Result<()> {
        let report = |c: &Counts| self.progress.report(c.muscles as usize, c.of as usize);
        report(counts);
        let mut ended = Ok(());
        // A separate flag: an error here is not the user's wish to end.
        let failed = AtomicBool::new(false);
        let halted = || self.progress.cancelled() || failed.load(Ordering::Relaxed);
        let work = |&number: &u64| self.compute(number, &halted);
        threads.for_each(missing, work, |done| {
            let take_over = || -> Result<()> {
                if let Some(done) = done.flatten().transpose()? {
                    counts.muscles += self.provenance.muscles_in([done.part].into_iter());
                    counts.points += done.points;
                    counts.failed += done.failed;
                    folder.write(done.part, done.bytes)?;
                }
                report(counts);
                Ok(())
            };
            if ended.is_ok() {
                ended = take_over();
                failed.store(ended.is_err(), Ordering::Relaxed);
            }
        });
        ended
    }

    /// One part; `None` where the run is to end.
    fn compute(&self, number: u64, halted: &impl Fn() -> bool) -> Option<Result<Done>> {
        let provenance = &self.provenance;
        let mut table = Table::new(provenance.layout.fields());
        let mut failed = 0;
        for muscle in provenance.muscles_of(number) {
            if halted() {
                return None;
            }
            let rows = solve::rows(self.plan, muscle);
            // Rows of a run that was ended meanwhile are not complete.
            if halted() {
                return None;
            }
            for row in rows {
                failed += u64::from(!row.status.is_ok());
                table.push(row);
            }
        }
        let points = table.rows as u64;
        Some(part(provenance, number, table).map(|bytes| Done {
            part: number,
            bytes,
            points,
            failed,
        }))
    }
}
