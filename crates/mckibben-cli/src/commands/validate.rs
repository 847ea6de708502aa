//! `validate`: verification and validation, each with its table.

pub mod measured;

use crate::{Asked, Bar, Failure, NO_ANSWER, output::width, shown, tabled};
use mckibben::verification::{CaseKind, Measure, VerificationRow};
use mckibben_app::{ProblemKind, SweepAnswer, SweepRequest};

pub const TEXT: &str = "validate: Verification against exact values and validation against measured muscles
all | Also compute the finest meshes (some seconds more)
sweep<N:1..1000000>^all | Robustness sweep over N random muscles: the share of random points with an answer
seed<N>&sweep | Seed of the random muscles [1]
measured<DIR?>^sweep,all | Validation report of measured muscles and rubbers: known data, fitted constants, errors at fitted points and at predicted points. Cases of DIR, one folder each [the built-in cases]
only<NAME,…>&measured | Only these cases, by folder name
model<NAME>&measured | Model of the measured muscles [fe]
@plot @output
Examples:
  mckibben validate
  mckibben validate --sweep 50
  mckibben validate --measured --only dmsp-20-300
  mckibben validate --measured --only dmsp-10-hose --model thick-wall
  mckibben validate --measured --only rubber-treloar";

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let number = |flag: &str| asked.text(flag).and_then(|text| text.trim().parse::<u64>().ok());
    if let Some(count) = number("sweep") {
        let request = SweepRequest { muscles: count as usize, seed: number("seed").unwrap_or(1) };
        let answer = mckibben_app::sweep(&request, &Bar::new("muscles"))?;
        asked.show(&answer, "", || sweep_text(&answer))?;
        return Ok(if answer.ok() { 0 } else { NO_ANSWER });
    }
    if asked.text("measured").is_some() {
        return measured::run(asked);
    }
    if asked.path("plot").is_some() {
        let message = "--plot draws the measured muscles: it requires --measured";
        return Err(Failure::input(
            ProblemKind::Usage,
            message,
            "mckibben validate --measured --plot FILE.svg",
        ));
    }
    let answer = mckibben_app::validate(&asked.request()?, &Bar::new("groups of cases"))?;
    asked.show(&answer, "cases", || as_text(&answer.cases))?;
    Ok(if answer.ok() { 0 } else { NO_ANSWER })
}

/// Times are for people only: JSON and CSV hold nothing that depends on the machine.
fn sweep_text(a: &SweepAnswer) -> String {
    format!(
        "{} random muscles, one point each (seed {})\n\n  {} of {} answered where the infinitely long muscle pulls and its strands stretch by less than 5 %\n  {} of {} answered elsewhere; the others ended with a reason\n  at most {} factorisations; median {:.2} ms, longest {:.2} ms\n",
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

/// The cases of one kind, and what they are.
const KINDS: [(&str, CaseKind, Measure, &str); 4] = [
    ("verification", CaseKind::Verification, Measure::Value, "Verification: are the equations solved right?"),
    (
        "measured pulls",
        CaseKind::Validation,
        Measure::Rms,
        "Validation: are they the right equations? Root mean square of the differences from measured pulls in N, over the largest or blocked one",
    ),
    (
        "other measured quantities",
        CaseKind::Validation,
        Measure::Value,
        "Validation: other measured quantities",
    ),
    (
        "± of fe",
        CaseKind::Validation,
        Measure::Share,
        "Validation: which share of measured points does the ± cover?",
    ),
];

fn as_text(cases: &[VerificationRow]) -> String {
    // Their sources only where the tables are wide enough.
    let source = if width::of_tables() >= 160 { " source" } else { "" };
    let (mut out, mut summary) = (String::new(), "Summary\n".to_owned());
    for (name, kind, measure, title) in KINDS {
        let is_one =
            |c: &&VerificationRow| c.kind == kind && (kind == CaseKind::Verification || c.measure == measure);
        let list: Vec<&VerificationRow> = cases.iter().filter(is_one).collect();
        let keys = "ok name=case reference:9~ ours:9~ error:2~ tolerance=allowed:2~";
        out += &format!("{title}\n\n{}\n", tabled(&list, &format!("{keys}{source}"), &shown::units()));
        let held = list.iter().filter(|c| c.ok).count();
        summary += &format!("  {name}: {held} of {} cases hold\n", list.len());
    }
    let failed = cases.iter().filter(|c| !c.ok).map(|c| format!("  FAILS: {}\n", c.name));
    summary.extend(failed);
    if source.is_empty() {
        summary += "\nSources of the cases: mckibben validate --format csv\n";
    }
    out + &summary
}
