//! Slurm's commands: `sbatch`, `squeue`, `scancel`, `scontrol` (slurm.schedmd.com).

use super::ask;
use std::collections::BTreeSet;
use std::path::Path;

/// The script, which users may edit.
pub(super) const TEMPLATE: &str = include_str!("../../../data/slurm.sh");
/// `MaxArraySize` of a Slurm that does not state it.
const USUAL_ARRAY: u64 = 1001;

fn words(list: &[&str]) -> Vec<String> {
    list.iter().map(|word| (*word).to_owned()).collect()
}

/// The largest index of an array: `MaxArraySize` − 1.
pub(super) fn largest_index() -> u64 {
    let shown = ask("scontrol", &words(&["show", "config"])).unwrap_or_default();
    let line = shown.lines().find_map(|line| line.trim().strip_prefix("MaxArraySize"));
    let size = line.and_then(|line| line.trim_start_matches([' ', '=']).trim().parse().ok());
    size.unwrap_or(USUAL_ARRAY).max(2) - 1
}

/// Job of an answer of `sbatch --parsable`: `123` or `123;cluster`.
pub(super) fn job(answer: &str) -> String {
    answer.lines().last().unwrap_or_default().split(';').next().unwrap_or_default().trim().to_owned()
}

fn submit(folder: &Path, log: &str, more: &[String], others: &[String], script: &Path) -> Vec<String> {
    let log = folder.join(log);
    let mut out = words(&["--parsable", "--open-mode=append"]);
    out.push(format!("--output={}", log.display()));
    out.extend(more.iter().chain(others).cloned());
    out.push(script.display().to_string());
    out
}

/// Arguments of `sbatch` for some shards.
pub(super) fn array(folder: &Path, indexes: &str, others: &[String], script: &Path) -> Vec<String> {
    submit(folder, "shard-%a.log", &[format!("--array={indexes}")], others, script)
}

/// Arguments of `sbatch` for the merge. After any end of the array: after success alone, one dead shard would leave it in the queue for ever.
pub(super) fn merge(folder: &Path, after: &[String], others: &[String], script: &Path) -> Vec<String> {
    let after = (!after.is_empty()).then(|| format!("--dependency=afterany:{}", after.join(":")));
    submit(folder, "merge.log", &after.into_iter().collect::<Vec<_>>(), others, script)
}

/// Indexes of arrays that wait in the queue.
pub(super) fn waiting(arrays: &[String]) -> BTreeSet<u64> {
    let indexes = |job: &String| {
        let list = ask(
            "squeue",
            &words(&["--noheader", "--array", "--states=PENDING,REQUEUED", "--format=%K", "--jobs", job]),
        );
        list.unwrap_or_default().lines().filter_map(|line| line.trim().parse().ok()).collect::<Vec<u64>>()
    };
    arrays.iter().flat_map(indexes).collect()
}

/// Jobs that have not ended; those that Slurm no longer lists have.
pub(super) fn alive(jobs: &[String]) -> Vec<String> {
    let lives = |job: &&String| {
        ask("squeue", &words(&["--noheader", "--format=%A", "--jobs", job]))
            .is_ok_and(|list| !list.is_empty())
    };
    jobs.iter().filter(lives).cloned().collect()
}
