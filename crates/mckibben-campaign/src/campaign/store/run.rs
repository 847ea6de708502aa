//! Runs a plan into a store.

use super::merge::write_whole;
use super::resume::{Marker, finished};
use super::{Folder, PartSource, Provenance, Table, check_name, is_file_name, part};
use crate::campaign::{CampaignError, Plan, Result, Shard, solve};
use mckibben::progress::Progress;
use mckibben::threads::Threads;
use mckibben_io::files::check_writable;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

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

/// A damaged file that was computed again.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Recomputed {
    /// The file.
    pub file: PathBuf,
    /// Its damage.
    pub cause: String,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
pub struct Outcome {
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

impl Outcome {
    pub(super) fn new(
        provenance: &Provenance,
        output: &Path,
        store: &Path,
        counts: Counts,
    ) -> Self {
        Self {
            output: output.into(),
            complete: counts.muscles == counts.of,
            counts,
            points: counts.muscles * provenance.points_per_muscle,
            plan_sha256: provenance.plan_sha256.clone(),
            store: store.into(),
            ..Self::default()
        }
    }
}

/// Parts are brought to the disk this often.
const FLUSH: Duration = Duration::from_millis(500);

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

/// A part from a thread.
struct Done {
    part: u64,
    bytes: Vec<u8>,
    points: u64,
    failed: u64,
}

/// The folder of parts of a campaign that becomes one file.
pub(super) fn parts_of(file: &Path) -> PathBuf {
    let mut name = file.file_name().unwrap_or_default().to_owned();
    name.push(".parts");
    file.with_file_name(name)
}

/// Runs a plan into `out`: one file if it ends in `.parquet`, else a folder of parts. Existing
/// parts are not computed again. It reports muscles; where the caller ends it, the store is valid
/// and not complete.
pub fn run(
    plan: &Plan,
    out: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<Outcome> {
    check_name(out)?;
    let provenance = Provenance::for_plan(plan);
    let one_file = is_file_name(out);
    if one_file && options.shard.is_some() {
        let message = format!(
            "a shard writes parts, and {} would be one file",
            out.display()
        );
        let hint = "give a folder, and merge the parts into a file when all shards are there";
        return Err(CampaignError::Refused(message, hint));
    }
    if !one_file && out.is_file() {
        let why =
            "it is a file, and parts go into a folder; a campaign in one file ends in .parquet"
                .into();
        return Err(CampaignError::NoCampaign(out.into(), why));
    }
    let store = if one_file {
        parts_of(out)
    } else {
        out.to_path_buf()
    };
    let replaced = one_file && out.exists();
    if replaced {
        check_writable(out).map_err(CampaignError::write(out))?;
        match finished(&provenance, out, &store) {
            Err(error) if options.overwrite && !matches!(error, CampaignError::Read { .. }) => {}
            done => return done,
        }
    }
    let folder = Folder::for_writing(&store, options.shard)?;
    if one_file && out.exists() && !replaced {
        // Another process finished it since.
        drop(folder);
        return finished(&provenance, out, &store);
    }
    if !one_file {
        Marker::claim(&store, &provenance, options.overwrite)?;
    }
    Run {
        plan,
        provenance: &provenance,
        out,
        options,
        progress,
    }
    .into_folder(folder)
}

/// A run of a plan.
pub(super) struct Run<'a> {
    plan: &'a Plan,
    pub provenance: &'a Provenance,
    out: &'a Path,
    pub options: &'a RunOptions,
    progress: &'a dyn Progress,
}

impl Run<'_> {
    /// Whether a part is of its share.
    pub fn holds(&self, part: u64) -> bool {
        self.options.shard.is_none_or(|shard| shard.holds(part))
    }

    /// Computes the missing parts of a folder; of a campaign in one file it writes the file at the
    /// end.
    fn into_folder(self, folder: Folder) -> Result<Outcome> {
        let &Self {
            provenance,
            out,
            options,
            progress,
            ..
        } = &self;
        let one_file = is_file_name(out);
        let store = folder.path.clone();
        let limited = options.threads.map(Threads::new).transpose()?;
        let threads = limited.as_ref().unwrap_or_else(|| Threads::shared());

        let (mut parts, recomputed) = self.existing(&folder, threads)?;
        let muscles = |part: u64| provenance.muscles_of(part).count() as u64;
        let share: Vec<u64> = (0..provenance.parts())
            .filter(|part| self.holds(*part))
            .collect();
        let missing: Vec<u64> = share
            .iter()
            .copied()
            .filter(|p| !parts.contains_key(p))
            .collect();
        let resumed = parts.keys().map(|&p| muscles(p)).sum();
        let of = share.iter().map(|&p| muscles(p)).sum();
        let mut counts = Counts {
            muscles: resumed,
            of,
            resumed,
            ..Counts::default()
        };
        let report = |c: &Counts| progress.report(c.muscles as usize, c.of as usize);
        report(&counts);

        let (mut pending, mut ended, mut flushed) = (vec![], Ok(()), Instant::now());
        // A separate flag: an error here is not the user's wish to end.
        let failed = AtomicBool::new(false);
        let halted = || progress.cancelled() || failed.load(Ordering::Relaxed);
        let work = |&number: &u64| self.compute(number, &halted);
        threads.for_each(&missing, work, |done| {
            let take_over = || -> Result<()> {
                if let Some(done) = done.flatten().transpose()? {
                    counts.muscles += muscles(done.part);
                    counts.points += done.points;
                    counts.failed += done.failed;
                    pending.push((done.part, done.bytes));
                }
                report(&counts);
                if flushed.elapsed() > FLUSH {
                    let written = folder.write(&mut pending)?.into_iter();
                    parts.extend(written.map(|(number, path)| (number, PartSource::File(path))));
                    flushed = Instant::now();
                }
                Ok(())
            };
            if ended.is_ok() {
                ended = take_over();
                failed.store(ended.is_err(), Ordering::Relaxed);
            }
        });
        ended?;
        let shard = options.shard.map(|shard| shard.to_string());
        let outcome = Outcome {
            recomputed,
            shard,
            ..Outcome::new(provenance, out, &store, counts)
        };
        if one_file && outcome.complete {
            if out.exists() && !options.overwrite {
                folder.write(&mut pending)?;
                return Err(CampaignError::Appeared(out.into()));
            }
            parts.extend(
                pending
                    .into_iter()
                    .map(|(n, bytes)| (n, PartSource::Memory(bytes))),
            );
            write_whole(provenance, parts, out, options.overwrite)?;
            folder.remove(0..provenance.parts())?;
        } else {
            folder.write(&mut pending)?;
        }
        Ok(outcome)
    }

    /// One part; `None` where the run is to end.
    fn compute(&self, number: u64, halted: &impl Fn() -> bool) -> Option<Result<Done>> {
        let provenance = self.provenance;
        let mut table = Table::new(provenance.layout.fields());
        let (mut points, mut failed) = (0, 0);
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
                points += 1;
                failed += u64::from(!row.status.is_ok());
                table.push(row);
            }
        }
        Some(part(provenance, number, table).map(|bytes| Done {
            part: number,
            bytes,
            points,
            failed,
        }))
    }
}
