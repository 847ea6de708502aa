//! `campaign`, `campaign run|show|merge|status`.

mod show;
mod status;

use crate::clean;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::files;
use crate::format::Format;
use crate::output::text::{number, place};
use crate::output::{emit, json, overwrite, show as print, warn};
use crate::progress::{Bar, INTERRUPTED};
use clap::{Args, Subcommand};
use mckibben::progress::Progress;
use mckibben_app::{CampaignMergeRequest, CampaignRequest, ProblemKind, campaign_merge};
use mckibben_campaign::campaign::{Outcome, Shard};
use show::CampaignShowArgs;
use status::StatusArgs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

pub const EXAMPLES: &str = "Examples:
  mckibben campaign plans/paper.toml -o campaign.parquet
  mckibben campaign plans/paper.toml -o parts/ --shard 1/2
  mckibben campaign plans/paper.toml -o parts/ --shard 2/2 --threads 1";

const RUN_EXAMPLES: &str = "Example:
  mckibben campaign run plans/paper.toml -o campaign.parquet";

const SHOW_EXAMPLES: &str = "Example:
  mckibben campaign plans/paper.toml -o campaign.parquet
  mckibben campaign show campaign.parquet";

const MERGE_EXAMPLES: &str = "Example:
  mckibben campaign plans/paper.toml -o one/ --shard 1/2
  mckibben campaign plans/paper.toml -o other/ --shard 2/2
  mckibben campaign merge one/ other/ -o merged.parquet";

/// `campaign`.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct CampaignArgs {
    #[command(subcommand)]
    pub command: Option<CampaignCommand>,
    #[command(flatten)]
    pub run: CampaignRunArgs,
}

/// `campaign PLAN`.
#[derive(Debug, Args)]
pub struct CampaignRunArgs {
    /// Plan file (TOML)
    #[arg(value_name = "PLAN.toml", required = true)]
    pub plan: Option<PathBuf>,
    /// Output table: one file, FILE.parquet, or a folder of parts, DIR/. The same command continues an interrupted run
    #[arg(short, long, value_name = "FILE.parquet or DIR", required = true)]
    pub output: Option<PathBuf>,
    /// Compute only share i of n of the plan, as parts in a folder; `campaign merge` joins them
    #[arg(long, value_name = "i/n")]
    pub shard: Option<Shard>,
    /// Number of threads [one per core]; the table does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Print neither progress nor summary
    #[arg(short, long)]
    pub quiet: bool,
}

/// `campaign …`.
#[derive(Debug, Subcommand)]
pub enum CampaignCommand {
    /// The same as `campaign` without a word: run a plan, or what is missing of it
    #[command(after_help = RUN_EXAMPLES)]
    Run(CampaignRunArgs),
    /// Summary of a campaign: muscles, points, failures by cause, ranges, origin
    #[command(after_help = SHOW_EXAMPLES)]
    Show(CampaignShowArgs),
    /// Join folders of parts into one file, identical to that of a single run
    #[command(after_help = MERGE_EXAMPLES)]
    Merge(CampaignMergeArgs),
    /// How far a folder of parts is, shard by shard: done, running, missing; exit code 1 where a shard is missing
    #[command(after_help = status::EXAMPLES)]
    Status(StatusArgs),
}

/// `campaign merge`.
#[derive(Debug, Args)]
pub struct CampaignMergeArgs {
    /// Folders of parts
    #[arg(value_name = "DIR", required = true)]
    pub folders: Vec<PathBuf>,
    /// The file
    #[arg(short, long, value_name = "FILE.parquet")]
    pub output: PathBuf,
}

pub fn run(args: &CampaignArgs, format: Format) -> Result<u8, Failure> {
    match &args.command {
        None => plan(&args.run, format),
        Some(CampaignCommand::Run(args)) => plan(args, format),
        Some(CampaignCommand::Status(args)) => status::run(args, format),
        Some(CampaignCommand::Show(args)) => show::run(args, format),
        Some(CampaignCommand::Merge(args)) => merge(args, format),
    }
}

fn no_csv(format: Format) -> Result<(), Failure> {
    if format != Format::Csv {
        return Ok(());
    }
    let message = "--format csv: the table is the Parquet file itself";
    Err(Failure::input(ProblemKind::Usage, message, "take text or json"))
}

fn plan(args: &CampaignRunArgs, format: Format) -> Result<u8, Failure> {
    no_csv(format)?;
    let bar = if args.quiet { Bar::hidden() } else { Bar::new("muscles") };
    let from = Instant::now();
    let request = CampaignRequest {
        plan: args.plan.as_deref().map(files::text).transpose()?,
        output: args.output.clone(),
        shard: args.shard.map(|shard| shard.to_string()),
        threads: args.threads.map(usize::from),
        overwrite: overwrite(),
    };
    let outcome = mckibben_app::campaign(&request, &bar)?;
    let interrupted = bar.cancelled() && !outcome.complete;
    drop(bar);
    for file in &outcome.recomputed {
        warn(format!("{} was damaged and is recomputed: {}", file.file.display(), file.cause));
    }
    if !args.quiet {
        // What is on the disk is valid, whatever ended the run.
        let out = match format {
            Format::Json => format!("{:#}\n", json(&outcome)?),
            Format::Text | Format::Csv => as_text(&outcome, from.elapsed()),
        };
        emit(clean::lines(&out).as_bytes(), None)?;
    }
    let c = outcome.counts;
    Ok(if interrupted {
        INTERRUPTED
    } else if c.points > 0 && c.failed == c.points {
        NOT_CONVERGED
    } else {
        0
    })
}

fn as_text(outcome: &Outcome, time: Duration) -> String {
    let p = outcome.counts;
    let seconds = time.as_secs_f64();
    let mut text = format!("{} of {} muscles are in {}", p.muscles, p.of, place(&outcome.store));
    if outcome.complete {
        text = format!("{} muscles are in {}", p.muscles, place(&outcome.output));
    }
    if p.resumed > 0 {
        text.push_str(&format!(", {} of them from before", p.resumed));
    }
    text.push('\n');
    if p.points > 0 {
        let rate = number(p.points as f64 / seconds, 3);
        text.push_str(&format!("{} points in {} s ({rate} a second)", p.points, number(seconds, 3)));
        if p.failed > 0 {
            text.push_str(&format!(
                ", {} without an answer: `mckibben campaign show` gives the reasons",
                p.failed
            ));
        }
        text.push('\n');
    }
    if !outcome.complete {
        text.push_str("Interrupted: the same command continues from here.\n");
    }
    text
}

fn merge(args: &CampaignMergeArgs, format: Format) -> Result<u8, Failure> {
    no_csv(format)?;
    let request = CampaignMergeRequest {
        folders: args.folders.clone(),
        output: args.output.clone(),
        overwrite: overwrite(),
    };
    let merged = campaign_merge(&request)?;
    let text = || {
        let out = place(&merged.output);
        format!("{} points of {} muscles are in {out}\n", merged.points, merged.muscles)
    };
    print(&merged, format, "", text, None)?;
    Ok(0)
}
