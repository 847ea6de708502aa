//! `campaign`, `campaign show|merge`.

mod progress;
mod show;

use crate::cli::{CampaignArgs, CampaignCommand, CampaignMergeArgs, CampaignRunArgs};
use crate::failure::{Failure, NOT_CONVERGED};
use crate::flags::Format;
use crate::output::text::number;
use crate::output::{emit, json, warn};
use mckibben::progress::Progress;
use mckibben_campaign::campaign::{self, Outcome, Plan, Recomputed, RunOptions};
use progress::Watch;
use serde_json::json;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Exit code of a run that was ended from outside, as shells have it.
const INTERRUPTED: u8 = 130;

/// Runs the command.
pub fn run(args: &CampaignArgs) -> Result<u8, Failure> {
    match &args.command {
        None => plan(&args.run),
        Some(CampaignCommand::Show(args)) => show::run(args),
        Some(CampaignCommand::Merge(args)) => merge(args),
    }
}

fn missing(what: &str) -> Failure {
    Failure::input("usage", format!("{what} is missing"), "see `mckibben campaign --help`")
}

fn no_csv(format: Format) -> Result<(), Failure> {
    if format != Format::Csv {
        return Ok(());
    }
    Err(Failure::input("usage", "--format csv: the table is the Parquet file itself", "take text or json"))
}

fn plan(args: &CampaignRunArgs) -> Result<u8, Failure> {
    no_csv(args.format)?;
    let path = args.plan.as_deref().ok_or_else(|| missing("the plan"))?;
    let out = args.output.as_deref().ok_or_else(|| missing("--output"))?;
    let plan = Plan::read(path)?;
    let options = RunOptions { shard: args.shard, threads: args.threads.map(usize::from) };
    let watch = Watch::new(args.quiet, stopped_by_signals());
    let from = Instant::now();
    let outcome = campaign::run(&plan, out, &options, &watch);
    watch.clear();
    let outcome = outcome?;
    for Recomputed { file, cause } in &outcome.recomputed {
        warn(format!("{} was damaged and is recomputed: {cause}", file.display()));
    }
    if !args.quiet {
        let text = match args.format {
            Format::Json => json::print(&json!(outcome)),
            _ => as_text(&outcome, from.elapsed()),
        };
        emit(&text, None)?;
    }
    let p = outcome.counts;
    Ok(if watch.cancelled() && !outcome.complete {
        INTERRUPTED
    } else if p.points > 0 && p.failed == p.points {
        NOT_CONVERGED
    } else {
        0
    })
}

/// A flag that Ctrl-C (and a scheduler's SIGTERM) sets; the second time they end the program.
fn stopped_by_signals() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = stop.clone();
    let handler = move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(INTERRUPTED));
        }
    };
    // Without a handler the signal ends the program, and the store is valid all the same.
    let _ = ctrlc::set_handler(handler);
    stop
}

fn as_text(outcome: &Outcome, time: Duration) -> String {
    let p = outcome.counts;
    let seconds = time.as_secs_f64();
    let mut text = format!("{} of {} muscles are in {}", p.muscles, p.of, outcome.store.display());
    if outcome.complete {
        text = format!("{} muscles are in {}", p.muscles, outcome.output.display());
    }
    if p.resumed > 0 {
        text.push_str(&format!(", {} of them from before", p.resumed));
    }
    text.push('\n');
    if p.points > 0 {
        let rate = number(p.points as f64 / seconds, 3);
        text.push_str(&format!("{} points in {} s ({rate} a second)", p.points, number(seconds, 3)));
        if p.failed > 0 {
            text.push_str(&format!(", {} without an answer: `mckibben campaign show` says why", p.failed));
        }
        text.push('\n');
    }
    if !outcome.complete {
        text.push_str("Interrupted: the same command goes on from here.\n");
    }
    text
}

fn merge(args: &CampaignMergeArgs) -> Result<u8, Failure> {
    no_csv(args.format)?;
    let folders: Vec<PathBuf> = args.folders.clone();
    let merged = campaign::merge(&folders, &args.output)?;
    let text = match args.format {
        Format::Json => json::print(&json!(merged)),
        _ => format!(
            "{} points of {} muscles are in {}\n",
            merged.points,
            merged.muscles,
            args.output.display()
        ),
    };
    emit(&text, None)?;
    Ok(0)
}
