//! Runs a plan into a store.

use super::merge::{Place, write_whole};
use super::plan::Plan;
use super::resume::{finished, there};
use super::store::{Folder, Provenance, Table, is_file_name, part, part_name};
use super::{CampaignError, Shard, solve};
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, SyncSender, sync_channel};
use std::time::{Duration, Instant};

/// Parts are brought to the disk this often.
const FLUSH: Duration = Duration::from_millis(500);

/// How a plan is run.
#[derive(Debug, Clone, Default)]
pub struct RunOptions {
    /// Only this share of the plan.
    pub shard: Option<Shard>,
    /// Threads; as many as there are cores where nothing is said.
    pub threads: Option<usize>,
    /// Set by whoever wants the run to end early; the store is valid then.
    pub stop: Arc<AtomicBool>,
}

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Progress {
    /// Muscles that are done, those of earlier runs among them.
    pub muscles: u64,
    /// Muscles of the plan, or of the share of it.
    pub of: u64,
    /// Muscles that were there already.
    pub resumed: u64,
    /// Points of this run.
    pub points: u64,
    /// Points of this run without an answer.
    pub failed: u64,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Outcome {
    /// How far it came.
    pub progress: Progress,
    /// Whether all of the plan, or of the share of it, is there.
    pub complete: bool,
    /// Files that were damaged and have been computed anew, with what was wrong.
    pub recomputed: Vec<(PathBuf, String)>,
    /// Where unfinished work lies.
    pub store: PathBuf,
}

/// What a thread hands over.
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

/// Runs a plan into `out`: one file if it ends in `.parquet`, else a folder of parts. What is there already is not
/// computed again.
///
/// # Errors
/// [`CampaignError`]; the store is valid whatever happens.
pub fn run(
    plan: &Plan,
    out: &Path,
    options: &RunOptions,
    report: &mut dyn FnMut(Progress),
) -> Result<Outcome, CampaignError> {
    let provenance = Provenance::of(plan);
    let one_file = is_file_name(out);
    if one_file && options.shard.is_some() {
        return Err(CampaignError::ShardOfFile { path: out.into() });
    }
    if !one_file && out.is_file() {
        let why = "it is a file, and parts go into a folder; a campaign in one file ends in .parquet".into();
        return Err(CampaignError::NoCampaign { path: out.into(), why });
    }
    let store = if one_file { parts_of(out) } else { out.to_path_buf() };
    if one_file && out.exists() {
        return finished(&provenance, out, &store);
    }
    let folder = Folder::for_writing(&store, options.shard)?;
    if one_file && out.exists() {
        // Another process finished it since.
        drop(folder);
        return finished(&provenance, out, &store);
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads.unwrap_or(0)).build();
    let pool = pool.map_err(|e| CampaignError::Threads(e.to_string()))?;

    let mine = |part: &u64| options.shard.is_none_or(|s| s.holds(*part));
    let (mut places, recomputed) = pool.install(|| there(&folder, &provenance, &mine))?;
    let muscles = |part: u64| provenance.muscles_of(part).count() as u64;
    let wanted: Vec<u64> = (0..provenance.parts()).filter(mine).collect();
    let missing: Vec<u64> = wanted.iter().copied().filter(|p| !places.contains_key(p)).collect();
    let resumed = places.keys().map(|&p| muscles(p)).sum();
    let of = wanted.iter().map(|&p| muscles(p)).sum();
    let mut progress = Progress { muscles: resumed, of, resumed, ..Progress::default() };
    report(progress);

    let mut pending = vec![];
    // Its own flag, so that an error here does not look like the user's wish.
    let failed = &AtomicBool::new(false);
    let ended = std::thread::scope(|scope| {
        let (sender, receiver) = sync_channel::<Result<Done, CampaignError>>(4 * pool.current_num_threads());
        let (provenance, stop, pool, missing) = (&provenance, &*options.stop, &pool, &missing);
        scope.spawn(move || {
            let layout = Arc::new(provenance.layout.clone());
            let halted = || stop.load(Ordering::Relaxed) || failed.load(Ordering::Relaxed);
            let work = |sender: &mut SyncSender<_>, &number: &u64| {
                if let Some(done) = compute(plan, provenance, &layout, number, &halted) {
                    let _ = sender.send(done);
                }
            };
            pool.install(|| missing.par_iter().with_max_len(1).for_each_with(sender, work));
        });
        let mut error = None;
        let mut flushed = Instant::now();
        loop {
            match receiver.recv_timeout(Duration::from_millis(100)) {
                Ok(Ok(done)) if error.is_none() => {
                    progress.muscles += provenance.muscles_of(done.part).count() as u64;
                    progress.points += done.points;
                    progress.failed += done.failed;
                    pending.push((done.part, done.bytes));
                    report(progress);
                }
                Ok(Ok(_)) => {}
                Ok(Err(e)) => error = error.or(Some(e)),
                Err(RecvTimeoutError::Timeout) => report(progress),
                Err(RecvTimeoutError::Disconnected) => break,
            }
            if error.is_none() && flushed.elapsed() > FLUSH {
                let numbers: Vec<u64> = pending.iter().map(|p: &(u64, Vec<u8>)| p.0).collect();
                match folder.write(&mut pending) {
                    Ok(()) => {
                        places.extend(numbers.iter().map(|&n| (n, Place::File(store.join(part_name(n))))))
                    }
                    Err(e) => error = Some(e),
                }
                flushed = Instant::now();
            }
            if error.is_some() {
                failed.store(true, Ordering::Relaxed);
            }
        }
        error.map_or(Ok(()), Err)
    });
    ended?;
    let complete = progress.muscles == progress.of;
    if one_file && complete {
        places.extend(pending.into_iter().map(|(n, bytes)| (n, Place::Memory(bytes))));
        write_whole(&provenance, places, out)?;
        folder.remove()?;
    } else {
        folder.write(&mut pending)?;
    }
    Ok(Outcome { progress, complete, recomputed, store })
}

/// One part; `None` where the run is to end.
fn compute(
    plan: &Plan,
    provenance: &Provenance,
    layout: &Arc<super::store::Layout>,
    number: u64,
    halted: &impl Fn() -> bool,
) -> Option<Result<Done, CampaignError>> {
    let mut table = Table::new(layout);
    let (mut points, mut failed) = (0, 0);
    for muscle in provenance.muscles_of(number) {
        if halted() {
            return None;
        }
        for row in solve::rows(plan, muscle) {
            points += 1;
            failed += u64::from(row.status != solve::OK);
            table.push(&row);
        }
    }
    Some(part(provenance, number, &table).map(|bytes| Done { part: number, bytes, points, failed }))
}
