//! `campaign`, `campaign show` and `campaign merge`: many finite-element tests from a plan, on disk.

mod cluster;

pub use cluster::*;

use crate::fields::TextFile;
use crate::problem::{Problem, ProblemKind};
use mckibben::progress::Progress;
use mckibben::threads::Threads;
use mckibben_campaign::campaign::{
    self, CampaignError, Cost, Merged, Outcome, Plan, RunOptions, Shard, ShardChoice, Summary,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Above this many seconds a few muscles are timed before the cost is stated, for so small a share of it.
const TIMED_FROM: f64 = 60.0;
const SHARE: f64 = 0.01;
/// They are timed for so long at most, in seconds; muscles that take longer each are not.
const TIMED_FOR: f64 = 5.0;

/// A plan, and where its table goes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CampaignRequest {
    /// The plan (TOML).
    pub plan: Option<TextFile>,
    /// Output table: one file that ends in .parquet, or a folder of parts. The same request continues an interrupted run.
    pub output: Option<PathBuf>,
    /// Compute only share i of n of the plan, as i/n, as parts in a folder; auto takes the share from the environment variables of a cluster's engine, auto/N where it gives no count.
    pub shard: Option<String>,
    /// Number of threads; default: one per core. The table does not depend on it.
    pub threads: Option<usize>,
    /// Overwrite a file at `output` that is not of this plan.
    pub overwrite: bool,
    /// Start even if the plan needs more than 10 GB or one day.
    pub yes: bool,
}

/// Runs a plan, or what is missing of it. A cancelled run ends well, with a valid store that is not complete.
pub fn campaign(request: &CampaignRequest, progress: &dyn Progress) -> Result<Outcome, Problem> {
    let plan = request.read()?;
    let out = request.output.as_ref().ok_or_else(|| Problem::missing("output", "a file or a folder"))?;
    plan.admit()?;
    let shard = request.shard()?;
    let options =
        RunOptions { shard, threads: request.threads, overwrite: request.overwrite, yes: request.yes };
    Ok(campaign::run(&plan, out, &options, progress)?)
}

/// About what a plan costs, before it is begun.
pub fn campaign_cost(request: &CampaignRequest, progress: &dyn Progress) -> Result<Cost, Problem> {
    let plan = request.read()?;
    let threads = request.threads.unwrap_or_else(|| Threads::shared().count());
    let muscles = match request.shard()? {
        Some(shard) => plan.muscles().div_ceil(shard.count()),
        None => plan.muscles(),
    };
    let rough = plan.cost(muscles, threads);
    let of_a_muscle = rough.seconds * threads.max(1) as f64 / muscles.max(1) as f64;
    if rough.seconds < TIMED_FROM || of_a_muscle > TIMED_FOR {
        return Ok(rough);
    }
    let timing = plan.timed(Duration::from_secs_f64((SHARE * rough.seconds).min(TIMED_FOR)), progress)?;
    Ok(Cost {
        bytes: timing.bytes_per_muscle * muscles as f64,
        seconds: timing.seconds_per_muscle * muscles as f64 / threads.max(1) as f64,
        ..rough
    })
}

impl CampaignRequest {
    fn read(&self) -> Result<Plan, Problem> {
        let file = self.plan.as_ref().ok_or_else(|| Problem::missing("plan", "a plan file (TOML)"))?;
        Ok(Plan::parse(&file.text).map_err(|e| e.of(Path::new(&file.name)))?)
    }

    fn shard(&self) -> Result<Option<Shard>, Problem> {
        let wrong = |e| Problem::new(ProblemKind::Usage, e, "").in_field("shard");
        let Some(text) = &self.shard else { return Ok(None) };
        let choice: ShardChoice = text.parse().map_err(wrong)?;
        Ok(Some(choice.shard(|name| std::env::var(name).ok()).map_err(CampaignError::from)?))
    }
}

/// A campaign to be summarised.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CampaignShowRequest {
    /// One file, or a folder of parts.
    pub campaign: PathBuf,
}

/// Contents of a campaign.
pub fn campaign_show(request: &CampaignShowRequest) -> Result<Summary, Problem> {
    Ok(campaign::summary(&request.campaign)?)
}

/// Folders of parts to be joined.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CampaignMergeRequest {
    /// Folders of parts.
    pub folders: Vec<PathBuf>,
    /// The file.
    pub output: PathBuf,
    /// Overwrite a file at `output` that is not of the same plan.
    pub overwrite: bool,
}

/// Joins folders of parts into one file, the same bytes as those of a single run.
pub fn campaign_merge(request: &CampaignMergeRequest) -> Result<Merged, Problem> {
    Ok(campaign::merge(&request.folders, &request.output, request.overwrite)?)
}
