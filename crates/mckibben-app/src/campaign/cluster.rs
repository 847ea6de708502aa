//! `campaign status`, `campaign submit` and `campaign cancel`: campaigns on many machines.

use super::CampaignRequest;
use crate::fields::TextFile;
use crate::problem::Problem;
use mckibben::progress::Progress;
use mckibben_campaign::campaign::{
    self, CampaignStatus, CancelledJobs, SubmitEngine, SubmitOptions, Submitted,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// A campaign whose shards are looked at.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CampaignStatusRequest {
    /// The folder of parts.
    pub output: PathBuf,
}

/// How far a campaign is, shard by shard.
pub fn campaign_status(request: &CampaignStatusRequest) -> Result<CampaignStatus, Problem> {
    Ok(campaign::status(&request.output)?)
}

/// A plan that a cluster's engine is to compute.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CampaignSubmitRequest {
    /// The plan (TOML).
    pub plan: Option<TextFile>,
    /// The folder of parts, on a file system that all machines share.
    pub output: Option<PathBuf>,
    /// The engine.
    pub engine: SubmitEngine,
    /// Number of shards; default: from the time of a few muscles, 15 minutes each.
    pub shards: Option<u64>,
    /// The merged file; default: the folder's name with .parquet.
    pub merged: Option<PathBuf>,
    /// The script, with the words @PROGRAM@, @PLAN@, @FOLDER@, @SHARDS@, @MERGED@, @MINUTES@ and @NAME@; default: the built-in one.
    pub template: Option<TextFile>,
    /// Further arguments of the engine's command.
    pub arguments: Vec<String>,
    /// The program that the jobs run; default: this one.
    pub program: Option<PathBuf>,
    /// Only show what would be submitted.
    pub dry_run: bool,
}

/// Submits what is missing of a plan, and the merge after it.
pub fn campaign_submit(
    request: &CampaignSubmitRequest,
    progress: &dyn Progress,
) -> Result<Submitted, Problem> {
    let of = CampaignRequest { plan: request.plan.clone(), ..CampaignRequest::default() };
    let plan = of.read()?;
    let folder = request.output.as_ref().ok_or_else(|| Problem::missing("output", "a folder"))?;
    let options = SubmitOptions {
        engine: request.engine,
        shards: request.shards,
        merged: request.merged.clone(),
        template: request.template.as_ref().map(|file| file.text.clone()),
        arguments: request.arguments.clone(),
        program: request
            .program
            .clone()
            .or_else(|| std::env::current_exe().ok())
            .unwrap_or_else(|| "mckibben".into()),
        dry_run: request.dry_run,
    };
    Ok(campaign::submit(&plan, folder, &options, progress)?)
}

/// A campaign whose jobs are to end.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CampaignCancelRequest {
    /// The folder of parts.
    pub output: PathBuf,
}

/// Cancels the jobs of a campaign. What was computed stays.
pub fn campaign_cancel(request: &CampaignCancelRequest) -> Result<CancelledJobs, Problem> {
    Ok(campaign::cancel(&request.output)?)
}
