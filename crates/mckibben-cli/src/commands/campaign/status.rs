//! `campaign status`.

use crate::asked::Asked;
use crate::failure::{Failure, NO_ANSWER};
use crate::output::text::{place, table};
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
    let states = [
        (s.shards_done, ShardState::Done),
        (s.shards_running, ShardState::Running),
        (s.shards_missing, ShardState::Missing),
    ];
    let counted =
        states.iter().filter(|state| state.0 > 0).map(|(count, state)| format!("{count} {}", state.name()));
    out.push_str(&format!("{} shards: {}\n", s.shards_wanted, counted.collect::<Vec<_>>().join(", ")));
    let row = |shard: &ShardStatus| {
        let parts = format!("{} of {}", shard.parts, shard.parts_wanted);
        vec![shard.shard.clone(), shard.state.name().into(), parts]
    };
    let open: Vec<Vec<String>> = s.shards.iter().filter(|s| s.state != ShardState::Done).map(row).collect();
    if !open.is_empty() {
        out.push_str(&format!("\n{}", table(&["shard", "state", "parts"], open)));
    }
    for part in &s.damaged {
        out.push_str(&format!("Cut off: {}\n", place(part)));
    }
    if s.shards_missing > 0 {
        out.push_str("\nSomething is missing that nothing computes: run the shards again.\n");
    }
    out
}
