//! `validate`: verification and validation, each with its table.

use crate::cli::ValidateArgs;
use crate::failure::{Failure, NO_ANSWER};
use crate::flags::Format;
use crate::output::text::{number, table};
use crate::output::{csv, emit, json};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use mckibben::progress::Silent;
use mckibben_campaign::fit::held_out;
use mckibben_fem::axisymmetric::sweep::{Sweep, SweepRow, question};
use mckibben_fem::verification::{Kind, Row};
use mckibben_fem::{validation, verification};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::io::IsTerminal;

/// Runs the command.
pub fn run(args: &ValidateArgs) -> Result<u8, Failure> {
    if let Some(count) = args.sweep {
        return sweep(args, count as usize);
    }
    let fine = if args.all { verification::bricks::cook_fine() } else { vec![] };
    let cancelled = |e: mckibben_fem::FemError| Failure::new(NO_ANSWER, "cancelled", e.to_string(), "");
    let exact = verification::cases(&Silent).map_err(cancelled)?;
    let measured = validation::cases(&Silent).map_err(cancelled)?;
    let rows = [exact, fine, held_out::cases(), measured].concat();
    let list: Vec<Value> = rows.iter().map(as_json).collect();
    let text = match args.output.format {
        Format::Json => json::print(&json!({ "cases": list })),
        Format::Csv => csv::rows(&list)?,
        Format::Text => as_text(&rows),
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(if rows.iter().all(|r| r.ok) { 0 } else { NO_ANSWER })
}

/// Random muscles, one question each, on all cores. Times are for people only: JSON and CSV hold nothing that depends on the
/// machine.
fn sweep(args: &ValidateArgs, count: usize) -> Result<u8, Failure> {
    let bar = ProgressBar::new(count as u64);
    if !std::io::stderr().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} muscles, {per_sec}, {eta} left") {
        bar.set_style(style);
    }
    let one = |i: usize| {
        let row = question(args.seed, i);
        bar.inc(1);
        row
    };
    let rows: Vec<SweepRow> = (0..count).into_par_iter().filter_map(one).collect();
    bar.finish_and_clear();
    let sweep = Sweep { rows };
    let ((answered, asked), (answered_else, asked_else)) = (sweep.required(), sweep.others());
    let value = json!({
        "muscles": sweep.rows.len(), "seed": args.seed,
        "required": asked, "required_answered": answered,
        "others": asked_else, "others_answered": answered_else,
        "most_factorisations": sweep.most_factorisations(),
        "unanswered": sweep.rows.iter().filter(|r| r.required).filter_map(|r| r.answer.as_ref().err()).collect::<Vec<_>>(),
    });
    let text = match args.output.format {
        Format::Json => json::print(&value),
        Format::Csv => csv::rows(&[value])?,
        Format::Text => format!(
            "{} random muscles, one question each (seed {})\n\n  {answered} of {asked} answered where the endless muscle pulls and its strands stretch by less than 5 %\n  {answered_else} of {asked_else} answered elsewhere; the others ended in a reason\n  at most {} factorisations; median {:.2} ms, longest {:.2} ms\n",
            sweep.rows.len(),
            args.seed,
            sweep.most_factorisations(),
            1e3 * sweep.median_seconds(),
            1e3 * sweep.longest_seconds()
        ),
    };
    emit(&text, args.output.output.as_deref())?;
    // At least 99.9 % of what must have an answer.
    Ok(if 1000 * answered >= 999 * asked { 0 } else { NO_ANSWER })
}

fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Verification => "verification",
        Kind::Validation => "validation",
    }
}

fn as_json(r: &Row) -> Value {
    json!({
        "name": r.name, "kind": word(r.kind), "source": r.source, "reference": r.reference, "ours": r.ours,
        "error": r.error, "tolerance": r.tolerance, "ok": r.ok,
    })
}

fn as_text(rows: &[Row]) -> String {
    let mut out = String::new();
    for (kind, title) in [
        (Kind::Verification, "Verification: are the equations solved right?"),
        (Kind::Validation, "Validation: are they the right equations?"),
    ] {
        let of: Vec<&Row> = rows.iter().filter(|r| r.kind == kind).collect();
        if of.is_empty() {
            continue;
        }
        out.push_str(&format!("{title}\n\n"));
        let lines = of.iter().map(|r| {
            vec![
                if r.ok { "ok" } else { "FAILS" }.to_owned(),
                number(r.reference, 9),
                r.ours.map_or_else(|| "–".into(), |v| number(v, 9)),
                r.error.map_or_else(|| "–".into(), |v| format!("{v:.1e}")),
                format!("{:.0e}", r.tolerance),
                r.name.clone(),
                r.source.to_owned(),
            ]
        });
        let header = ["", "reference", "ours", "error", "allowed", "case", "source"];
        out.push_str(&table(&header, lines.collect()));
        let good = of.iter().filter(|r| r.ok).count();
        out.push_str(&format!("\n{good} of {} hold\n\n", of.len()));
    }
    out
}
