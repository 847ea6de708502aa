//! `validate`: verification and validation, each with its table.

pub mod measured;

use crate::asked::Asked;
use crate::failure::{Failure, NO_ANSWER};
use crate::output::text::{aligned, number, or_dash, table};
use crate::output::width;
use crate::progress::Bar;
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

fn as_text(cases: &[VerificationRow]) -> String {
    let [mut values, mut rms, mut measured, mut shares] = [vec![], vec![], vec![], vec![]];
    for case in cases {
        let table = match (case.kind, case.measure) {
            (CaseKind::Verification, _) => &mut values,
            (CaseKind::Validation, Measure::Rms) => &mut rms,
            (CaseKind::Validation, Measure::Value) => &mut measured,
            (CaseKind::Validation, Measure::Share) => &mut shares,
        };
        table.push(case);
    }
    let newton = |c: &VerificationRow| {
        c.ours.map(|v| vec![Some(v)]).map_or_else(|| "–".into(), |v| aligned(&v, 3).concat())
    };
    let percent = |v: f64| format!("{:.2} %", 100.0 * v);
    let value = |c: &VerificationRow| {
        let error = or_dash(c.error, |v| format!("{v:.1e}"));
        let ours = or_dash(c.ours, |v| number(v, 9));
        vec![number(c.reference, 9), ours, error, format!("{:.0e}", c.tolerance)]
    };
    let quantity = |c: &VerificationRow| {
        let ours = or_dash(c.ours, |v| number(v, 4));
        vec![number(c.reference, 4), ours, or_dash(c.error, percent), percent(c.tolerance)]
    };
    let of_blocked = |c: &VerificationRow| {
        let error = or_dash(c.error, percent);
        vec![newton(c), number(c.reference, 4), error, percent(c.tolerance)]
    };
    let covered = |c: &VerificationRow| vec![or_dash(c.ours, percent), percent(c.reference)];
    [
        "Verification: are the equations solved right?\n\n".to_owned(),
        section(&values, &["reference", "ours", "error", "allowed"], &value),
        "\nValidation: are they the right equations? Root mean square of the differences from measured pulls\n\n"
            .into(),
        section(&rms, &["rms [N]", "largest or blocked [N]", "rms of it", "allowed"], &of_blocked),
        "\nValidation: other measured quantities\n\n".into(),
        section(&measured, &["measured", "computed", "error", "allowed"], &quantity),
        "\nValidation: does the ± cover the measured points?\n\n".into(),
        section(&shares, &["held", "at least"], &covered),
        summary(&values, &rms, &measured, &shares),
    ]
    .concat()
}

/// The cases of a kind: whether each holds, its numbers, its name and source.
fn section(
    cases: &[&VerificationRow],
    columns: &[&str],
    numbers: &dyn Fn(&VerificationRow) -> Vec<String>,
) -> String {
    let source = has_sources().then_some("source");
    let header: Vec<&str> = ["", "case"].iter().chain(columns).copied().chain(source).collect();
    let row = |c: &&VerificationRow| {
        let mut row = vec![if c.ok { "ok" } else { "FAILS" }.to_owned(), c.name.clone()];
        row.extend(numbers(c));
        row.extend(source.map(|_| c.source.to_owned()));
        row
    };
    table(&header, cases.iter().map(row).collect())
}

/// Whether the tables are wide enough for the sources of the cases.
fn has_sources() -> bool {
    width::of_tables() >= 160
}

fn summary(
    values: &[&VerificationRow],
    rms: &[&VerificationRow],
    measured: &[&VerificationRow],
    shares: &[&VerificationRow],
) -> String {
    let held =
        |list: &[&VerificationRow]| format!("{} of {}", list.iter().filter(|c| c.ok).count(), list.len());
    let least = shares.iter().filter_map(|c| c.ours).reduce(f64::min);
    let least =
        least.map_or_else(String::new, |v| format!("; the least share of points is {:.1} %", 100.0 * v));
    let failed = [values, rms, measured, shares].concat().into_iter().filter(|c| !c.ok);
    let failed: String = failed.map(|c| format!("  FAILS: {}\n", c.name)).collect();
    format!(
        "\nSummary\n  verification: {} cases hold\n  measured pulls: {} cases hold\n  other measured quantities: {} cases hold\n  ± of fe: {} cases hold{least}\n{failed}{}",
        held(values),
        held(rms),
        held(measured),
        held(shares),
        if has_sources() { "" } else { "\nSources of the cases: mckibben validate --format csv\n" }
    )
}
