//! `campaign status`.

use crate::{Asked, Failure, NO_ANSWER, listed, pairs, place, shown, tabled, value};
use mckibben_app::{CampaignStatusRequest, campaign_status};
use mckibben_campaign::campaign::{CampaignStatus, ShardState, ShardStatus};

pub const STATUS: &str = "campaign status: How far a folder of parts is, shard by shard: done, running, missing; exit code 1 where a shard is missing
:folder<DIR>! | The folder of parts
@output
Example:
  mckibben campaign plans/paper.toml -o parts/ --shard 1/1
  mckibben campaign status parts/";

pub fn status(asked: &Asked) -> Result<u8, Failure> {
    let request = CampaignStatusRequest { output: asked.path("folder").unwrap_or_default() };
    let status = campaign_status(&request)?;
    asked.show(&status, "shards", || as_text(&status))?;
    Ok(if status.shards_missing > 0 { NO_ANSWER } else { 0 })
}

fn as_text(s: &CampaignStatus) -> String {
    let mut out = format!("{} of {} parts are in {}\n", s.parts, s.parts_wanted, place(&s.output));
    let shards = "shards_wanted=shards shards_done=done shards_running=running shards_missing=missing";
    out += &pairs(&listed(&value(s), shards, &shown::units()));
    let open: Vec<&ShardStatus> = s.shards.iter().filter(|s| s.state != ShardState::Done).collect();
    if !open.is_empty() {
        out += &format!("\n{}", tabled(&open, "shard state parts parts_wanted=of", &shown::units()));
    }
    for part in &s.damaged {
        out.push_str(&format!("Cut off: {}\n", place(part)));
    }
    if s.shards_missing > 0 {
        out.push_str("\nSomething is missing that nothing computes: run the shards again.\n");
    }
    out
}
