//! `campaign status|submit|cancel`.

use crate::failure::{Failure, NO_ANSWER};
use crate::files;
use crate::flags::OutputFlags;
use crate::format::Format;
use crate::output::show;
use crate::output::text::{number, place, table};
use crate::progress::{Bar, INTERRUPTED};
use clap::Args;
use mckibben::progress::Progress;
use mckibben_app::{
    CampaignCancelRequest, CampaignStatusRequest, CampaignSubmitRequest, campaign_cancel, campaign_status,
    campaign_submit,
};
use mckibben_campaign::campaign::{CampaignStatus, ShardState, SubmitEngine, Submitted};
use std::path::PathBuf;
use std::time::{Duration, Instant};

pub const STATUS_EXAMPLES: &str = "Example:
  mckibben campaign plans/paper.toml -o parts/ --shard 1/1
  mckibben campaign status parts/";

pub const SUBMIT_EXAMPLES: &str = "Example:
  mckibben campaign submit plans/paper.toml -o parts/ --dry-run";

pub const CANCEL_EXAMPLES: &str = "Example:
  mckibben campaign plans/paper.toml -o parts/ --shard 1/1
  mckibben campaign cancel parts/";

/// The wish to stop is looked for this often.
const TICK: Duration = Duration::from_millis(100);

/// `campaign status`.
#[derive(Debug, Args)]
pub struct StatusArgs {
    /// The folder of parts
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Look again every so many seconds until nothing runs or waits
    #[arg(long, value_name = "SECONDS", num_args = 0..=1, default_missing_value = "10", require_equals = true, value_parser = clap::value_parser!(u32).range(1..=86_400))]
    pub watch: Option<u32>,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `campaign submit`.
#[derive(Debug, Args)]
pub struct SubmitArgs {
    /// Plan file (TOML)
    #[arg(value_name = "PLAN.toml")]
    pub plan: PathBuf,
    /// The folder of parts, on a file system that all machines share
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// The engine
    #[arg(long, value_name = "slurm", default_value = "slurm")]
    pub engine: SubmitEngine,
    /// Number of shards [from the time of a few muscles: 15 minutes each, at most 1000 and what the engine takes]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=100_000))]
    pub shards: Option<u64>,
    /// The merged file [DIR.parquet]
    #[arg(long, value_name = "FILE.parquet")]
    pub merged: Option<PathBuf>,
    /// A script of your own; `--dry-run` prints the built-in one
    #[arg(long, value_name = "FILE")]
    pub template: Option<PathBuf>,
    /// Further arguments of sbatch, such as "--partition=long --account=group"
    #[arg(long, value_name = "ARGUMENTS", allow_hyphen_values = true)]
    pub sbatch_args: Vec<String>,
    /// Only print the commands and the script
    #[arg(long)]
    pub dry_run: bool,
}

/// `campaign cancel`.
#[derive(Debug, Args)]
pub struct CancelArgs {
    /// The folder of parts
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

pub fn status(args: &StatusArgs, format: Format) -> Result<u8, Failure> {
    let bar = Bar::hidden();
    let mut before = None;
    loop {
        let status = campaign_status(&CampaignStatusRequest { output: args.folder.clone() })?;
        let last = args.watch.is_none() || status.complete || !status.is_under_way();
        let counts = (status.parts, status.shards_running, status.shards_waiting, status.shards_failed);
        // While it is watched, text is printed when something has changed, and the rest at the end.
        if last || (format == Format::Text && before.replace(counts) != Some(counts)) {
            show(&status, format, "shards", || as_text(&status), args.output.target())?;
        }
        if last {
            return Ok(if status.has_gap() { NO_ANSWER } else { 0 });
        }
        let from = Instant::now();
        while from.elapsed() < Duration::from_secs(args.watch.unwrap_or_default().into()) {
            if bar.cancelled() {
                return Ok(INTERRUPTED);
            }
            std::thread::sleep(TICK);
        }
    }
}

fn as_text(s: &CampaignStatus) -> String {
    let mut out = format!("{} of {} parts are in {}\n", s.parts, s.parts_wanted, place(&s.output));
    let states = [
        (s.shards_done, ShardState::Done),
        (s.shards_running, ShardState::Running),
        (s.shards_waiting, ShardState::Waiting),
        (s.shards_failed, ShardState::Failed),
        (s.shards_missing, ShardState::Missing),
    ];
    let counted =
        states.iter().filter(|state| state.0 > 0).map(|(count, state)| format!("{count} {}", state.name()));
    out.push_str(&format!("{} shards: {}\n", s.shards_wanted, counted.collect::<Vec<_>>().join(", ")));
    let row = |shard: &mckibben_campaign::campaign::ShardStatus| {
        vec![
            shard.shard.clone(),
            shard.state.name().into(),
            format!("{} of {}", shard.parts, shard.parts_wanted),
            shard.host.clone(),
            shard.silent_s.map_or_else(String::new, |s| format!("{} s ago", number(s, 3))),
            shard.cause.clone(),
        ]
    };
    let open: Vec<Vec<String>> = s.shards.iter().filter(|s| s.state != ShardState::Done).map(row).collect();
    if !open.is_empty() {
        let head = ["shard", "state", "parts", "machine", "last sign", "cause"];
        out.push_str(&format!("\n{}", table(&head, open)));
    }
    for part in &s.damaged {
        out.push_str(&format!("Cut off: {}\n", place(part)));
    }
    if s.has_gap() {
        out.push_str(
            "\nSomething is missing that nothing computes: run the shards again, or submit the plan again.\n",
        );
    }
    out
}

pub fn submit(args: &SubmitArgs, format: Format) -> Result<u8, Failure> {
    let bar = Bar::hidden();
    let request = CampaignSubmitRequest {
        plan: Some(files::text(&args.plan)?),
        output: Some(args.output.clone()),
        engine: args.engine,
        shards: args.shards,
        merged: args.merged.clone(),
        template: args.template.as_deref().map(files::text).transpose()?,
        arguments: args.sbatch_args.iter().flat_map(|a| a.split_whitespace()).map(str::to_owned).collect(),
        program: None,
        dry_run: args.dry_run,
    };
    let submitted = campaign_submit(&request, &bar)?;
    show(&submitted, format, "", || submitted_as_text(&submitted, args.dry_run), None)?;
    Ok(0)
}

fn submitted_as_text(s: &Submitted, dry_run: bool) -> String {
    if s.commands.is_empty() {
        return format!("Nothing is missing, and {} is there\n", place(&s.merged));
    }
    let hours = number(s.estimate_s / 3600.0, 3);
    let timed = format!("about {hours} hours of one processor, from {} muscles", s.muscles_timed);
    if dry_run {
        return format!("# {timed}\n{}\n\n# {}\n{}", s.commands.join("\n"), "The script", s.script);
    }
    let shards = if s.shards_submitted.is_empty() { "no shard" } else { &s.shards_submitted };
    format!(
        "Submitted of {} shards: {shards} ({timed}), as jobs {}\nThe merged table will be {}\n",
        s.shards_wanted,
        s.jobs.join(", "),
        place(&s.merged)
    )
}

pub fn cancel(args: &CancelArgs, format: Format) -> Result<u8, Failure> {
    let cancelled = campaign_cancel(&CampaignCancelRequest { output: args.folder.clone() })?;
    let text = || match cancelled.jobs.as_slice() {
        [] => "No job is left\n".to_owned(),
        jobs => format!("Cancelled: {}\n", jobs.join(", ")),
    };
    show(&cancelled, format, "", text, None)?;
    Ok(0)
}
