//! Slurm's commands: `sbatch`, `squeue`, `scancel`, `scontrol` (slurm.schedmd.com).

use super::engine::ask;
use std::collections::BTreeSet;
use std::path::Path;

/// The script, which users may edit.
pub(super) const TEMPLATE: &str = include_str!("../../../data/slurm.sh");
/// `MaxArraySize` of a Slurm that does not state it.
const USUAL_ARRAY: u64 = 1001;

/// An option of a command, with its value where it has one.
fn option(name: &str, value: &str) -> String {
    if value.is_empty() { format!("--{name}") } else { format!("--{name}={value}") }
}

/// The largest index of an array: `MaxArraySize` − 1.
pub(super) fn largest_index() -> u64 {
    let shown = ask("scontrol", &["show".into(), "config".into()]).unwrap_or_default();
    let line = shown.lines().find_map(|line| line.trim().strip_prefix("MaxArraySize"));
    let size = line.and_then(|line| line.trim_start_matches([' ', '=']).trim().parse().ok());
    size.unwrap_or(USUAL_ARRAY).max(2) - 1
}

/// Job of an answer of `sbatch`: `123` or `123;cluster`.
pub(super) fn job(answer: &str) -> String {
    answer.lines().last().unwrap_or_default().split(';').next().unwrap_or_default().trim().to_owned()
}

fn submit(folder: &Path, log: &str, own: Option<String>, others: &[String], script: &Path) -> Vec<String> {
    let log = folder.join(log).display().to_string();
    let mut out = vec![option("parsable", ""), option("open-mode", "append"), option("output", &log)];
    out.extend(own.into_iter().chain(others.iter().cloned()));
    out.push(script.display().to_string());
    out
}

/// Arguments of `sbatch` for some shards.
pub(super) fn array(folder: &Path, indexes: &str, others: &[String], script: &Path) -> Vec<String> {
    submit(folder, "shard-%a.log", Some(option("array", indexes)), others, script)
}

/// Arguments of `sbatch` for the merge. After any end of the array: after success alone, one dead shard would leave it in the queue for ever.
pub(super) fn merge(folder: &Path, after: &[String], others: &[String], script: &Path) -> Vec<String> {
    let after = (!after.is_empty()).then(|| option("dependency", &format!("afterany:{}", after.join(":"))));
    submit(folder, "merge.log", after, others, script)
}

/// What `squeue` lists of a job; nothing of jobs that it no longer has, and where it cannot be asked.
fn queue(job: &str, format: &str, more: &[String]) -> String {
    let asked = [option("noheader", ""), option("format", format), option("jobs", job)];
    ask("squeue", &[&asked[..], more].concat()).unwrap_or_default()
}

/// Indexes of arrays that wait in the queue.
pub(super) fn waiting(arrays: &[String]) -> BTreeSet<u64> {
    let more = [option("array", ""), option("states", "PENDING,REQUEUED")];
    let indexes = |job: &String| {
        let list = queue(job, "%K", &more);
        list.lines().filter_map(|line| line.trim().parse().ok()).collect::<Vec<u64>>()
    };
    arrays.iter().flat_map(indexes).collect()
}

/// Jobs that have not ended.
pub(super) fn alive(jobs: &[String]) -> Vec<String> {
    jobs.iter().filter(|job| !queue(job, "%A", &[]).is_empty()).cloned().collect()
}
