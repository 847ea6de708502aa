//! Flags of `campaign`.

use crate::flags::{Format, OutputFlags};
use clap::{Args, Subcommand};
use mckibben_campaign::campaign::Shard;
use std::path::PathBuf;

pub const CAMPAIGN_EXAMPLES: &str = "Examples:
  mckibben campaign plans/paper.toml -o campaign.parquet
  mckibben campaign plans/paper.toml -o parts/ --shard 1/2
  mckibben campaign plans/paper.toml -o parts/ --shard 2/2 --threads 1";

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
    /// Where the table goes: one file, FILE.parquet, or a folder of parts, DIR/. The same command resumes it
    #[arg(short, long, value_name = "FILE.parquet or DIR", required = true)]
    pub output: Option<PathBuf>,
    /// Only share i of n of the plan, as parts in a folder; `campaign merge` joins them
    #[arg(long, value_name = "i/n")]
    pub shard: Option<Shard>,
    /// Threads [as many as cores]; the table does not depend on them
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Neither progress nor summary
    #[arg(short, long)]
    pub quiet: bool,
    /// What is printed at the end: text for people, json for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// `campaign …`.
#[derive(Debug, Subcommand)]
pub enum CampaignCommand {
    /// What a campaign holds: muscles, points, failures by cause, ranges, where it comes from
    #[command(after_help = SHOW_EXAMPLES)]
    Show(CampaignShowArgs),
    /// Join folders of parts into one file, the same bytes as those of a single run
    #[command(after_help = MERGE_EXAMPLES)]
    Merge(CampaignMergeArgs),
}

/// `campaign show`.
#[derive(Debug, Args)]
pub struct CampaignShowArgs {
    /// A campaign: one file, or a folder of parts
    #[arg(value_name = "FILE.parquet or DIR")]
    pub campaign: PathBuf,
    #[command(flatten)]
    pub output: OutputFlags,
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
    /// What is printed at the end: text for people, json for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}
