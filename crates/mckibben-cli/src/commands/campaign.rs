//! `campaign`, `campaign show|merge`.

use crate::{
    Bar, Context, Format, NO_ANSWER, NOT_CONVERGED, Problem, Result, clean,
    examples::examples,
    output::{Output, json},
    path_on_one_line,
    progress::INTERRUPTED,
};
use clap::Subcommand;
use mckibben_app::{
    CampaignMergeRequest, CampaignRequest, CampaignShowRequest, campaign_forecast, campaign_merge,
    campaign_show, words::number,
};
use mckibben_campaign::campaign::CampaignOutcome;
use mckibben_core::progress::{Progress, Silent};
use std::time::{Duration, Instant};

fn no_csv(context: &Context) -> Result<()> {
    if context.format != Format::Csv {
        return Ok(());
    }
    Err(Problem::usage(
        "--format csv: the table is the Parquet file itself",
        "take text or json",
    ))
}

/// A campaign, or what is asked of one.
#[derive(clap::Args)]
#[command(
    args_conflicts_with_subcommands = true,
    subcommand_negates_reqs = true,
    after_long_help = examples(&[
    "campaign plans/paper.toml --dry-run",
    "campaign plans/paper.toml -o campaign.parquet",
    "campaign plans/paper.toml -o parts/ --shard 1/2",
    "campaign plans/paper.toml -o parts/ --shard 2/2 --threads 1"
])
)]
pub struct Campaign {
    #[command(subcommand)]
    about: Option<About>,
    #[command(flatten)]
    request: CampaignRequest,
    /// Write nothing: check the whole plan, and print muscles, rows, time, size and warnings
    ///
    /// Time and size are those of ten muscles, spread over the plan and solved here.
    #[arg(long)]
    dry_run: bool,
    /// Print neither progress nor summary
    #[arg(short, long)]
    quiet: bool,
}

/// What is asked of a campaign.
#[derive(Subcommand)]
enum About {
    /// Progress and summary of a campaign: shards, muscles, points, failures by cause, ranges, origin
    ///
    /// Exit code 1 where a part is missing that no process computes.
    #[command(after_long_help = examples(&[
    "campaign plans/paper.toml -o campaign.parquet",
    "campaign show campaign.parquet"
]))]
    Show {
        #[command(flatten)]
        request: CampaignShowRequest,
        #[command(flatten)]
        output: Box<Output>,
    },
    /// Join folders of parts into one file, identical to that of a single run
    #[command(after_long_help = examples(&[
    "campaign plans/paper.toml -o one/ --shard 1/2",
    "campaign plans/paper.toml -o other/ --shard 2/2",
    "campaign merge one/ other/ -o merged.parquet"
]))]
    Merge {
        #[command(flatten)]
        request: CampaignMergeRequest,
    },
}

impl Campaign {
    pub fn run(self, context: &Context) -> Result<u8> {
        match self.about {
            Some(About::Show { request, output }) => {
                let summary = campaign_show(&request)?;
                output.print(context, &summary)?;
                Ok(if summary.is_stopped() { NO_ANSWER } else { 0 })
            }
            Some(About::Merge { request }) => merge(request, context),
            None if self.dry_run => {
                no_csv(context)?;
                let bar = Bar::new("muscles");
                let forecast = campaign_forecast(&self.request, &bar)?;
                drop(bar);
                context.print(&forecast, |_| (), None)?;
                let tried = forecast.muscles_tried * forecast.points_per_muscle;
                let all_failed = tried > 0 && forecast.points_failed == tried;
                Ok(if all_failed { NOT_CONVERGED } else { 0 })
            }
            None => run_campaign(self.request, self.quiet, context),
        }
    }
}

fn run_campaign(mut request: CampaignRequest, quiet: bool, context: &Context) -> Result<u8> {
    no_csv(context)?;
    let bar = Bar::new("muscles");
    let progress: &dyn Progress = if quiet { &Silent } else { &bar };
    let from = Instant::now();
    request.overwrite = context.overwrite;
    let outcome = mckibben_app::campaign(&request, progress)?;
    let interrupted = bar.cancelled() && !outcome.complete;
    drop(bar);
    for file in &outcome.recomputed {
        context.warn(format!(
            "{} is recomputed: {}",
            file.file.display(),
            file.cause
        ));
    }
    if !quiet {
        // What is on the disk is valid, whatever ended the run.
        let out = match context.format {
            Format::Json => format!("{:#}\n", json(&outcome)?),
            _ => as_text(&outcome, from.elapsed()),
        };
        context.emit(clean::lines(&out).as_bytes(), None)?;
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

fn as_text(outcome: &CampaignOutcome, time: Duration) -> String {
    let counts = outcome.counts;
    let seconds = time.as_secs_f64();
    let muscles = counts.muscles;
    let points = counts.points;
    let (of, path) = if outcome.complete {
        (String::new(), path_on_one_line(&outcome.output))
    } else {
        (
            format!(" of {}", counts.of),
            path_on_one_line(&outcome.store),
        )
    };
    let mut out = format!("{muscles}{of} muscles are in {path}");
    if counts.resumed > 0 {
        out += &format!(", {} of them from before", counts.resumed);
    }
    out.push('\n');
    if points > 0 {
        let time = number(seconds, 3);
        let rate = number(points as f64 / seconds, 3);
        out += &format!("{points} points in {time} s ({rate} a second)");
        if counts.failed > 0 {
            out += &format!(
                ", {} without an answer: `mckibben campaign show {path}` gives the reasons",
                counts.failed
            );
        }
        out.push('\n');
    }
    if !outcome.complete {
        out += "Interrupted: the same command continues from here.\n";
    }
    out
}

fn merge(mut request: CampaignMergeRequest, context: &Context) -> Result<u8> {
    no_csv(context)?;
    request.overwrite = context.overwrite;
    context.print(&campaign_merge(&request)?, |_| (), None)?;
    Ok(0)
}
