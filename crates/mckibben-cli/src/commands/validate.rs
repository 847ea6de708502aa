//! `validate`: verification and validation, each with its table.

use crate::cli::ValidateArgs;
use crate::failure::{Failure, NO_ANSWER};
use crate::flags::Format;
use crate::output::text::{number, table};
use crate::output::{csv, emit, json};
use mckibben_fem::verification::{Kind, Row};
use mckibben_fem::{validation, verification};
use serde_json::{Value, json};

/// Runs the command.
pub fn run(args: &ValidateArgs) -> Result<u8, Failure> {
    let rows = [verification::cases(), validation::cases()].concat();
    let list: Vec<Value> = rows.iter().map(as_json).collect();
    let text = match args.output.format {
        Format::Json => json::print(&json!({ "cases": list })),
        Format::Csv => csv::rows(&list)?,
        Format::Text => as_text(&rows),
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(if rows.iter().all(|r| r.ok) { 0 } else { NO_ANSWER })
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
