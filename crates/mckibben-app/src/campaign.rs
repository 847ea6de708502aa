//! `campaign`, `campaign show` and `campaign merge`: many finite-element tests from a plan, on disk.

use crate::{
    Count, Problem, ProblemKind, Result, TextFile, Units,
    flags::{self, Args},
    plan::plan_of,
    print::{Csv, Page, Show},
};
use mckibben_campaign::campaign::{
    self, CampaignOutcome, Forecast, Merged, RunOptions, Shard, Summary,
};
use mckibben_core::progress::Progress;
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::PathBuf;

/// A plan, and where its table goes.
#[derive(Debug, Default, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct CampaignRequest {
    /// Plan file (TOML)
    #[arg(value_name = "PLAN.toml", value_parser = flags::file, required = true)]
    pub plan: Option<TextFile>,
    /// Table of muscles, a line each, in place of `[sampling]` and `[vary]`
    ///
    /// Headings are keys of a plan with a unit (`tube.outer_diameter [mm]`, `tube.rubber`), or columns of
    /// a campaign's table (wall_mm). The plan states the rest of the muscle and the points.
    #[arg(long, value_name = "FILE.csv", value_parser = flags::table)]
    pub samples: Option<TextFile>,
    /// Output table: one file, FILE.parquet, or a folder of parts, DIR/
    ///
    /// The same command continues an interrupted run.
    #[arg(
        short,
        long,
        value_name = "FILE.parquet or DIR",
        required_unless_present = "dry_run"
    )]
    pub output: Option<PathBuf>,
    /// Compute only share i of n of the plan, as parts in a folder; `campaign merge` joins them
    #[arg(long, value_name = "i/n")]
    pub shard: Option<String>,
    /// Number of threads [one per core]; the table does not depend on it
    #[arg(long, value_name = "N")]
    pub threads: Option<Count<1, 1024>>,
    /// Overwrite a file at `output` that is not of this plan.
    #[arg(skip)]
    pub overwrite: bool,
}

/// Runs a plan, or what is missing of it. A cancelled run ends well, with a valid store that is not
/// complete.
pub fn campaign(request: &CampaignRequest, progress: &dyn Progress) -> Result<CampaignOutcome> {
    let plan = plan_of(&request.plan, &request.samples)?.0;
    let out = request
        .output
        .as_ref()
        .ok_or_else(|| Problem::missing("output", "a file or a folder"))?;
    plan.admit()?;
    Ok(campaign::run(&plan, out, &request.options()?, progress)?)
}

/// What a plan will be, before it is run: nothing is written. All mistakes of the plan at once.
pub fn campaign_forecast(request: &CampaignRequest, progress: &dyn Progress) -> Result<Forecast> {
    let plan = plan_of(&request.plan, &request.samples)?.0;
    plan.admit()?;
    Ok(campaign::forecast(&plan, &request.options()?, progress)?)
}

impl CampaignRequest {
    fn options(&self) -> Result<RunOptions> {
        let wrong = |e| ProblemKind::Usage.problem(e).in_field("shard");
        let shard = self.shard.as_deref().map(str::parse::<Shard>);
        Ok(RunOptions {
            shard: shard.transpose().map_err(wrong)?,
            threads: self.threads.map(|threads| threads.0),
            overwrite: self.overwrite,
        })
    }
}

/// A campaign to be summarised.
#[derive(Debug, Default, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct CampaignShowRequest {
    /// A campaign: one file, or a folder of parts
    #[arg(value_name = "FILE.parquet or DIR")]
    pub campaign: PathBuf,
}

/// Contents of a campaign.
pub fn campaign_show(request: &CampaignShowRequest) -> Result<Summary> {
    Ok(campaign::summary(&request.campaign)?)
}

/// Folders of parts to be joined.
#[derive(Debug, Default, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct CampaignMergeRequest {
    /// Folders of parts
    #[arg(value_name = "DIR", required = true)]
    pub folders: Vec<PathBuf>,
    /// The file
    #[arg(short, long, value_name = "FILE.parquet")]
    pub output: PathBuf,
    /// Overwrite a file at `output` that is not of the same plan.
    #[arg(skip)]
    pub overwrite: bool,
}

/// Joins folders of parts into one file, the same bytes as those of a single run.
pub fn campaign_merge(request: &CampaignMergeRequest) -> Result<Merged> {
    Ok(campaign::merge(
        &request.folders,
        &request.output,
        request.overwrite,
    )?)
}

impl Show for Forecast {}

impl Show for Merged {}

impl Show for Summary {
    fn page(&self, u: &Units) -> Page {
        let mut page = Page::of(self, u, &[]);
        if self.is_stopped() {
            page.paragraph("Incomplete, and no process computes the rest: run it again.");
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.ranges)
    }
}
