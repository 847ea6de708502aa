//! `campaign`, `campaign run|show|merge|status`.

use crate::{
    Bar, Format, NO_ANSWER, NOT_CONVERGED, Problem, Units, clean, emit, listed, output::Output,
    output::json, output::print_text, overwrite, pairs, place, progress::INTERRUPTED, said, shown,
    tabled, value, warn,
};
use clap::Subcommand;
use mckibben::progress::{Progress, Silent};
use mckibben_app::{
    CampaignMergeRequest, CampaignRequest, CampaignShowRequest, CampaignStatusRequest, ProblemKind,
    campaign_merge, campaign_show, campaign_status,
};
use mckibben_campaign::campaign::{CampaignStatus, Outcome, ShardState, ShardStatus, Summary};
use std::time::{Duration, Instant};

fn no_csv(format: Format) -> Result<(), Problem> {
    if format != Format::Csv {
        return Ok(());
    }
    let message = "--format csv: the table is the Parquet file itself";
    Err(Problem::new(
        ProblemKind::Usage,
        message,
        "take text or json",
    ))
}

/// A campaign, or what is asked of one.
#[derive(Debug, clap::Args)]
#[command(
    args_conflicts_with_subcommands = true,
    subcommand_negates_reqs = true,
    after_long_help = "Examples:
  mckibben campaign plans/paper.toml -o campaign.parquet
  mckibben campaign plans/paper.toml -o parts/ --shard 1/2
  mckibben campaign plans/paper.toml -o parts/ --shard 2/2 --threads 1"
)]
pub struct Campaign {
    #[command(subcommand)]
    about: Option<About>,
    #[command(flatten)]
    request: CampaignRequest,
    /// Print neither progress nor summary
    #[arg(short, long)]
    quiet: bool,
}

/// What is asked of a campaign.
#[derive(Debug, Subcommand)]
enum About {
    /// Summary of a campaign: muscles, points, failures by cause, ranges, origin
    #[command(after_long_help = "Example:
  mckibben campaign plans/paper.toml -o campaign.parquet
  mckibben campaign show campaign.parquet")]
    Show {
        #[command(flatten)]
        request: CampaignShowRequest,
        #[command(flatten)]
        output: Output,
    },
    /// Join folders of parts into one file, identical to that of a single run
    #[command(after_long_help = "Example:
  mckibben campaign plans/paper.toml -o one/ --shard 1/2
  mckibben campaign plans/paper.toml -o other/ --shard 2/2
  mckibben campaign merge one/ other/ -o merged.parquet")]
    Merge {
        #[command(flatten)]
        request: CampaignMergeRequest,
    },
    /// How far a folder of parts is, shard by shard: done, running, missing; exit code 1 where a
    /// shard is missing
    #[command(after_long_help = "Example:
  mckibben campaign plans/paper.toml -o parts/ --shard 1/1
  mckibben campaign status parts/")]
    Status {
        #[command(flatten)]
        request: CampaignStatusRequest,
        #[command(flatten)]
        output: Output,
    },
}

impl Campaign {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        match self.about {
            Some(About::Show { request, output }) => {
                output.show(format, &campaign_show(&request)?, "ranges", summary_text)
            }
            Some(About::Merge { request }) => merge(request, format),
            Some(About::Status { request, output }) => {
                let status = campaign_status(&request)?;
                output.show(format, &status, "shards", status_text)?;
                Ok(if status.shards_missing > 0 {
                    NO_ANSWER
                } else {
                    0
                })
            }
            None => run(self.request, self.quiet, format),
        }
    }
}

fn run(mut request: CampaignRequest, quiet: bool, format: Format) -> Result<u8, Problem> {
    no_csv(format)?;
    let bar = Bar::new("muscles");
    let progress: &dyn Progress = if quiet { &Silent } else { &bar };
    let from = Instant::now();
    request.overwrite = overwrite();
    let outcome = mckibben_app::campaign(&request, progress)?;
    let interrupted = bar.cancelled() && !outcome.complete;
    drop(bar);
    for file in &outcome.recomputed {
        warn(format!(
            "{} was damaged and is recomputed: {}",
            file.file.display(),
            file.cause
        ));
    }
    if !quiet {
        // What is on the disk is valid, whatever ended the run.
        let out = match format {
            Format::Json => format!("{:#}\n", json(&outcome)?),
            _ => as_text(&outcome, from.elapsed()),
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
    let (p, seconds, mut row) = (outcome.counts, time.as_secs_f64(), value(outcome));
    row["of"] = (!outcome.complete).then_some(p.of).into();
    row["place"] = place(if outcome.complete {
        &outcome.output
    } else {
        &outcome.store
    })
    .into();
    row["resumed"] = Some(p.resumed).filter(|n| *n > 0).into();
    row["points"] = Some(p.points).filter(|n| *n > 0).into();
    (row["seconds"], row["rate"]) = (seconds.into(), (p.points as f64 / seconds).into());
    row["failed"] = Some(p.failed).filter(|n| *n > 0).into();
    let text = "{muscles}[ of {of}] muscles are in {place}[, {resumed} of them from before]\n\
        [{points} points in {seconds:3} s ({rate:3} a second)][, {failed} without an answer: \
        `mckibben campaign show` gives the reasons]";
    let out = said(&row, text, &shown::units()) + if p.points > 0 { "\n" } else { "" };
    out + if outcome.complete {
        ""
    } else {
        "Interrupted: the same command continues from here.\n"
    }
}

fn merge(mut request: CampaignMergeRequest, format: Format) -> Result<u8, Problem> {
    no_csv(format)?;
    request.overwrite = overwrite();
    let merged = campaign_merge(&request)?;
    print_text(format, &merged, "", |merged, _| {
        let out = place(&merged.output);
        format!(
            "{} points of {} muscles are in {out}\n",
            merged.points, merged.muscles
        )
    })
}

fn summary_text(s: &Summary, u: &Units) -> String {
    let keys = "muscles points points_wanted points_per_muscle answered failed model sampling seed \
        version=mckibben plan_sha256";
    let mut out = pairs(&listed(&value(s), keys, u)) + "\n";
    out += &tabled(&s.ranges, "name=_ smallest:6~ largest:6~", u);
    for (status, f) in &s.failed {
        out += &format!(
            "\nThe first {status} is of muscle {}: {}\n",
            f.first_muscle, f.first_cause
        );
    }
    if s.missing_parts > 0 {
        let (all, missing) = (s.provenance.parts(), s.missing_parts);
        let present = all - missing;
        out += &format!(
            "\nIncomplete: {present} of {all} parts are present; run the campaign again to \
             continue.\n"
        );
    }
    out.extend(
        s.damaged
            .iter()
            .map(|damaged| format!("Damaged: {damaged}\n")),
    );
    out
}

fn status_text(s: &CampaignStatus, u: &Units) -> String {
    let mut out = format!(
        "{} of {} parts are in {}\n",
        s.parts,
        s.parts_wanted,
        place(&s.output)
    );
    let shards =
        "shards_wanted=shards shards_done=done shards_running=running shards_missing=missing";
    out += &pairs(&listed(&value(s), shards, u));
    let open: Vec<&ShardStatus> = s
        .shards
        .iter()
        .filter(|s| s.state != ShardState::Done)
        .collect();
    if !open.is_empty() {
        out += &format!("\n{}", tabled(open, "shard state parts parts_wanted=of", u));
    }
    out.extend(
        s.damaged
            .iter()
            .map(|part| format!("Cut off: {}\n", place(part))),
    );
    if s.shards_missing > 0 {
        out += "\nSomething is missing that nothing computes: run the shards again.\n";
    }
    out
}
