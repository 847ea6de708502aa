//! Hands a campaign to a cluster's engine, and takes it back.
//!
//! One script computes a share where it runs with an index, and merges where it runs without: an array of all shares that are missing, and
//! after it, however its elements ended, the merge. What was submitted is in `.submitted` in the folder.

mod engine;
pub(super) mod record;
mod slurm;

pub use engine::SubmitEngine;

use super::state::Marker;
use super::status::{ShardState, status};
use super::store::{Provenance, check_name, is_file_name};
use super::{CampaignError, Plan, Shard};
use engine::{ask, command, quoted};
use mckibben::progress::Progress;
use mckibben_files::{read, replace};
use record::{LONGEST, Record, place};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What a shard shall take: long against its start, and short against what is lost with a machine.
const SECONDS_OF_A_SHARD: f64 = 900.0;
/// The most shards: each has a few files beside its parts.
const MOST_SHARDS: u64 = 1000;
/// A few muscles are timed for so long.
const TIMED: Duration = Duration::from_secs(5);
/// Time limit of a job over the estimate: other processors, and shards that are longer than the mean.
const RESERVE: f64 = 4.0;
/// The shortest time limit in minutes.
const LEAST_MINUTES: f64 = 15.0;

#[derive(Debug, Clone, Default)]
pub struct SubmitOptions {
    pub engine: SubmitEngine,
    /// Number of shards, where it is not to follow from the time.
    pub shards: Option<u64>,
    /// The merged file; the folder's name with `.parquet` where nothing is said.
    pub merged: Option<PathBuf>,
    /// Text of the script, where it is not the built-in one.
    pub template: Option<String>,
    /// Further arguments of the engine's command.
    pub arguments: Vec<String>,
    /// The program that the jobs run.
    pub program: PathBuf,
    /// Only show what would be submitted.
    pub dry_run: bool,
}

/// What was submitted, or would be.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Submitted {
    /// The folder of parts.
    pub output: PathBuf,
    pub merged: PathBuf,
    pub shards_wanted: u64,
    /// Shards that were submitted: 1 to 4, 7.
    pub shards_submitted: String,
    /// Estimated time of all missing shards on one processor in seconds.
    pub estimate_s: f64,
    /// Muscles that were timed for the estimate.
    pub muscles_timed: u64,
    /// Jobs of the engine; none of a dry run.
    pub jobs: Vec<String>,
    pub commands: Vec<String>,
    pub script: String,
}

#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CancelledJobs {
    /// The folder of parts.
    pub output: PathBuf,
    /// Jobs of the engine.
    pub jobs: Vec<String>,
}

/// As many shards as the time asks for and the engine takes, so that each has about the same number of parts.
fn shards(seconds: f64, most: u64, parts: u64) -> u64 {
    let wanted = (seconds / SECONDS_OF_A_SHARD).ceil().clamp(1.0, MOST_SHARDS.min(most).max(1) as f64) as u64;
    let parts = parts.max(1);
    parts.div_ceil(parts.div_ceil(wanted.min(parts)))
}

/// Numbers as ranges, as arrays are written: `1-4,7`.
fn ranges(numbers: &[u64]) -> String {
    let runs = numbers.chunk_by(|a, b| a + 1 == *b);
    let texts = runs.map(|run| match run {
        [first, .., last] => format!("{first}-{last}"),
        _ => run.iter().map(u64::to_string).collect(),
    });
    texts.collect::<Vec<_>>().join(",")
}

/// Submits what is missing of a plan, and the merge after it. Parts that are there, and shards that run or wait, are left alone.
pub fn submit(
    plan: &Plan,
    folder: &Path,
    options: &SubmitOptions,
    progress: &dyn Progress,
) -> Result<Submitted, CampaignError> {
    check_name(folder)?;
    if is_file_name(folder) {
        return Err(CampaignError::ShardOfFile { path: folder.into() });
    }
    let provenance = Provenance::of(plan);
    if !options.dry_run {
        std::fs::create_dir_all(place(folder)).map_err(CampaignError::write(folder))?;
        Marker::claim(folder, &provenance, false)?;
    }
    let folder = &std::path::absolute(folder).map_err(CampaignError::write(folder))?;
    let merged = match &options.merged {
        Some(path) => std::path::absolute(path).map_err(CampaignError::write(path))?,
        None => folder.with_added_extension("parquet"),
    };
    let before = Record::read(folder);
    let there = status(folder).ok();
    let parts_left = provenance.parts() - there.as_ref().map_or(0, |s| s.parts);
    let timing = plan.timed(TIMED, progress)?;
    let left = (parts_left * provenance.block).min(provenance.muscles);
    let seconds = timing.seconds_per_muscle * left as f64;
    let wanted = match (options.shards, &before) {
        (Some(stated), _) => stated.clamp(1, provenance.parts()),
        (None, Some(record)) => record.shards,
        (None, None) => shards(seconds, slurm::largest_index(), provenance.parts()),
    };
    let busy = |index: u64| {
        let found = there
            .iter()
            .flat_map(|s| &s.shards)
            .find(|s| Some(s.shard.parse()) == Shard::new(index, wanted).map(Ok));
        found.is_some_and(|s| matches!(s.state, ShardState::Done | ShardState::Running | ShardState::Waiting))
    };
    let numbers: Vec<u64> = (1..=wanted).filter(|&index| !busy(index)).collect();

    let saved = place(folder).join("template.sh");
    let template = match &options.template {
        Some(text) => text.clone(),
        None => read(&saved, LONGEST)
            .ok()
            .and_then(|t| String::from_utf8(t).ok())
            .unwrap_or_else(|| slurm::TEMPLATE.into()),
    };
    let of_a_shard = timing.seconds_per_muscle * provenance.muscles.div_ceil(wanted) as f64;
    let minutes = (RESERVE * of_a_shard / 60.0).ceil().max(LEAST_MINUTES);
    let name = plan.name().unwrap_or("campaign").replace(|c: char| !c.is_ascii_alphanumeric(), "-");
    let path = |p: &Path| quoted(&p.to_string_lossy());
    let (plan_file, script_file) = (place(folder).join("plan.toml"), place(folder).join("job.sh"));
    let script = [
        ("@NAME@", name),
        ("@MINUTES@", minutes.to_string()),
        ("@PROGRAM@", path(&options.program)),
        ("@PLAN@", path(&plan_file)),
        ("@FOLDER@", path(folder)),
        ("@SHARDS@", wanted.to_string()),
        ("@MERGED@", path(&merged)),
    ]
    .iter()
    .fold(template, |text, (word, value)| text.replace(word, value));
    let mut out = Submitted {
        output: folder.clone(),
        merged,
        shards_wanted: wanted,
        shards_submitted: ranges(&numbers),
        estimate_s: seconds,
        muscles_timed: timing.muscles,
        jobs: vec![],
        commands: vec![],
        script,
    };
    if numbers.is_empty() && out.merged.exists() {
        return Ok(out);
    }
    let mut record =
        before.unwrap_or(Record { engine: options.engine, shards: wanted, arrays: vec![], merges: vec![] });
    record.shards = wanted;
    if !options.dry_run {
        let write =
            |path: &Path, text: &str| replace(path, text.as_bytes()).map_err(CampaignError::write(path));
        write(&plan_file, plan.text())?;
        write(&script_file, &out.script)?;
        if let Some(text) = &options.template {
            write(&saved, text)?;
        }
    }
    let mut send = |arguments: Vec<String>| -> Result<String, CampaignError> {
        out.commands.push(command("sbatch", &arguments));
        if options.dry_run {
            return Ok("JOB".into());
        }
        let job = slurm::job(&ask("sbatch", &arguments)?);
        out.jobs.push(job.clone());
        Ok(job)
    };
    let mut after: Vec<String> = if options.dry_run { vec![] } else { slurm::alive(&record.arrays) };
    if !numbers.is_empty() {
        let job = send(slurm::array(&place(folder), &ranges(&numbers), &options.arguments, &script_file))?;
        record.arrays.push(job.clone());
        after.push(job);
        record.write(folder, options.dry_run)?;
    }
    let job = send(slurm::merge(&place(folder), &after, &options.arguments, &script_file))?;
    record.merges.push(job);
    record.write(folder, options.dry_run)?;
    Ok(out)
}

/// Cancels all jobs that were submitted for a folder and have not ended. What was computed stays.
pub fn cancel(folder: &Path) -> Result<CancelledJobs, CampaignError> {
    let Some(record) = Record::read(folder) else {
        status(folder)?;
        return Ok(CancelledJobs { output: folder.into(), jobs: vec![] });
    };
    let all: Vec<String> = record.arrays.iter().chain(&record.merges).cloned().collect();
    let jobs = slurm::alive(&all);
    if !jobs.is_empty() {
        ask("scancel", &jobs)?;
    }
    Ok(CancelledJobs { output: folder.into(), jobs })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_follow_from_time_engine_and_parts() {
        // min(1000, largest index, ⌈time/15 min⌉), then as many as share the parts evenly.
        assert_eq!(shards(10.0, 1000, 100), 1);
        assert_eq!(shards(901.0, 1000, 100), 2);
        assert_eq!(shards(3600.0 * 100.0, 1000, 6000), 400);
        assert_eq!(shards(1e9, 1000, 6000), 1000);
        assert_eq!(shards(1e9, 300, 6000), 300);
        // 100 parts on 64 processes take two rounds whatever is done: 50 processes do the same.
        assert_eq!(shards(64.0 * 900.0, 1000, 100), 50);
    }

    #[test]
    fn numbers_are_written_as_ranges_and_words_for_a_shell() {
        assert_eq!(ranges(&[1, 2, 3, 4, 7, 9, 10]), "1-4,7,9-10");
        assert_eq!((quoted("/a/b-1.toml"), quoted("a b'c")), ("/a/b-1.toml".into(), r"'a b'\''c'".into()));
    }
}
