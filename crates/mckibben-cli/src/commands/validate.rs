//! `validate`: verification and validation, each with its table.

use crate::failure::{Failure, NO_ANSWER};
use crate::flags::{Format, OutputFlags};
use crate::output::show;
use crate::output::text::{number, or_dash, table};
use crate::progress::Bar;
use clap::Args;
use mckibben_app::{Case, CaseKind, SweepAnswer, SweepRequest, ValidateRequest};

pub const EXAMPLES: &str = "Examples:
  mckibben validate
  mckibben validate --sweep 50";

/// `validate`.
#[derive(Debug, Args)]
pub struct ValidateArgs {
    /// The finest meshes as well (some seconds more)
    #[arg(long, conflicts_with = "sweep")]
    pub all: bool,
    /// Instead: ask so many random muscles one question each, and say which share is answered
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub sweep: Option<u32>,
    /// Seed of the random muscles
    #[arg(long, default_value_t = 1, requires = "sweep")]
    pub seed: u64,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// Runs the command.
pub fn run(args: &ValidateArgs, format: Format) -> Result<u8, Failure> {
    let path = args.output.output.as_deref();
    if let Some(count) = args.sweep {
        let request = SweepRequest { muscles: count as usize, seed: args.seed };
        let answer = mckibben_app::sweep(&request, &Bar::new("muscles"))?;
        show(&answer, format, "", || sweep_text(&answer), path)?;
        return Ok(if answer.ok() { 0 } else { NO_ANSWER });
    }
    let answer = mckibben_app::validate(&ValidateRequest { all: args.all }, &Bar::new("groups of cases"))?;
    show(&answer, format, "cases", || as_text(&answer.cases), path)?;
    Ok(if answer.ok() { 0 } else { NO_ANSWER })
}

/// Times are for people only: JSON and CSV hold nothing that depends on the machine.
fn sweep_text(a: &SweepAnswer) -> String {
    format!(
        "{} random muscles, one question each (seed {})\n\n  {} of {} answered where the infinitely long muscle pulls and its strands stretch by less than 5 %\n  {} of {} answered elsewhere; the others ended in a reason\n  at most {} factorisations; median {:.2} ms, longest {:.2} ms\n",
        a.muscles,
        a.seed,
        a.required_answered,
        a.required,
        a.others_answered,
        a.others,
        a.most_factorisations,
        1e3 * a.sweep.median_seconds(),
        1e3 * a.sweep.longest_seconds()
    )
}

fn as_text(cases: &[Case]) -> String {
    let mut out = String::new();
    for (kind, title) in [
        (CaseKind::Verification, "Verification: are the equations solved right?"),
        (CaseKind::Validation, "Validation: are they the right equations?"),
    ] {
        let of: Vec<&Case> = cases.iter().filter(|c| c.kind == kind).collect();
        if of.is_empty() {
            continue;
        }
        out.push_str(&format!("{title}\n\n"));
        let lines = of.iter().map(|c| {
            vec![
                if c.ok { "ok" } else { "FAILS" }.to_owned(),
                number(c.reference, 9),
                or_dash(c.ours, |v| number(v, 9)),
                or_dash(c.error, |v| format!("{v:.1e}")),
                format!("{:.0e}", c.tolerance),
                c.name.clone(),
                c.source.clone(),
            ]
        });
        let header = ["", "reference", "ours", "error", "allowed", "case", "source"];
        out.push_str(&table(&header, lines.collect()));
        let good = of.iter().filter(|c| c.ok).count();
        out.push_str(&format!("\n{good} of {} hold\n\n", of.len()));
    }
    out
}
