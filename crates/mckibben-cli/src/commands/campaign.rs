//! `campaign`, `campaign run|show|merge|status`.

use crate::{
    Asked, Bar, Failure, Format, NO_ANSWER, NOT_CONVERGED, clean, emit, listed, number, output::json,
    overwrite, pairs, place, progress::INTERRUPTED, shown, tabled, value, warn,
};
use mckibben::progress::Progress;
use mckibben_app::{
    CampaignMergeRequest, CampaignRequest, CampaignStatusRequest, ProblemKind, campaign_merge, campaign_show,
    campaign_status,
};
use mckibben_campaign::campaign::{CampaignStatus, Outcome, ShardState, ShardStatus, Summary};
use std::time::{Duration, Instant};

fn no_csv(format: Format) -> Result<(), Failure> {
    if format != Format::Csv {
        return Ok(());
    }
    let message = "--format csv: the table is the Parquet file itself";
    Err(Failure::input(ProblemKind::Usage, message, "take text or json"))
}

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    no_csv(asked.format)?;
    let quiet = asked.is("quiet");
    let bar = if quiet { Bar::hidden() } else { Bar::new("muscles") };
    let from = Instant::now();
    let mut request: CampaignRequest = asked.request()?;
    request.overwrite = overwrite();
    let outcome = mckibben_app::campaign(&request, &bar)?;
    let interrupted = bar.cancelled() && !outcome.complete;
    drop(bar);
    for file in &outcome.recomputed {
        warn(format!("{} was damaged and is recomputed: {}", file.file.display(), file.cause));
    }
    if !quiet {
        // What is on the disk is valid, whatever ended the run.
        let out = match asked.format {
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

pub fn merge(asked: &Asked) -> Result<u8, Failure> {
    no_csv(asked.format)?;
    let request = CampaignMergeRequest { overwrite: overwrite(), ..asked.request()? };
    let merged = campaign_merge(&request)?;
    asked.print(&merged, "", || {
        let out = place(&merged.output);
        format!("{} points of {} muscles are in {out}\n", merged.points, merged.muscles)
    })
}

pub fn show(asked: &Asked) -> Result<u8, Failure> {
    let summary = campaign_show(&asked.request()?)?;
    asked.show(&summary, "ranges", || summary_text(&summary))
}

fn summary_text(s: &Summary) -> String {
    let u = shown::units();
    let keys = "muscles points points_wanted points_per_muscle answered failed model sampling seed version=mckibben plan_sha256";
    let mut out = pairs(&listed(&value(s), keys, &u)) + "\n";
    out += &tabled(&s.ranges, "name=_ smallest:6~ largest:6~", &u);
    for (status, f) in &s.failed {
        out.push_str(&format!("\nThe first {status} is of muscle {}: {}\n", f.first_muscle, f.first_cause));
    }
    if s.missing_parts > 0 {
        let all = s.provenance.parts();
        out.push_str(&format!(
            "\nIncomplete: {} of {all} parts are present; run the campaign again to continue.\n",
            all - s.missing_parts
        ));
    }
    for damaged in &s.damaged {
        out.push_str(&format!("Damaged: {damaged}\n"));
    }
    out
}

pub fn status(asked: &Asked) -> Result<u8, Failure> {
    let request = CampaignStatusRequest { output: asked.path("folder").unwrap_or_default() };
    let status = campaign_status(&request)?;
    asked.show(&status, "shards", || status_text(&status))?;
    Ok(if status.shards_missing > 0 { NO_ANSWER } else { 0 })
}

fn status_text(s: &CampaignStatus) -> String {
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
