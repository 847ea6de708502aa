//! `formula show`: a fitted formula.

use super::fit::{FormulaShowArgs, error_rows, errors_table, made_text, range_text, terms, universal_text};
use crate::failure::Failure;
use crate::flags::Format;
use crate::output::text::{number, pairs, table};
use crate::output::{csv, emit, json};
use mckibben::formula::{Body, Document, Formula, UniversalFormula, paper_terms};
use mckibben::model::ModelKind;
use serde_json::{Value, json};

/// Runs the command.
pub fn show(args: &FormulaShowArgs) -> Result<u8, Failure> {
    let document = document(args)?;
    let (value, latex): (Value, String) = match &document {
        Document::Section(f) => (json!(f), f.to_latex()),
        Document::Universal(f) => (json!(f), f.to_latex()),
    };
    let text = match args.output.format {
        _ if args.latex => latex,
        Format::Json => json::print(&value),
        Format::Csv => csv::rows(&terms(&value))?,
        Format::Text => match &document {
            Document::Section(f) => as_text(f),
            Document::Universal(f) => universal_text(f),
        },
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(0)
}

/// A file, or a built-in formula by its name.
fn document(args: &FormulaShowArgs) -> Result<Document, Failure> {
    let built_in = match args.file.to_str() {
        Some(name) if name == ModelKind::Universal.name() => UniversalFormula::large(),
        Some(name) if name == ModelKind::UniversalSmall.name() => UniversalFormula::small(),
        _ => None,
    };
    match built_in {
        Some(formula) => Ok(Document::Universal((*formula).clone())),
        None => Ok(Document::read(&args.file)?),
    }
}

fn as_text(f: &Formula) -> String {
    let (p, r) = (&f.provenance, &f.range);
    let known = |v: &Option<String>| v.clone().unwrap_or_else(|| "–".into());
    let contraction = format!("{} to {}", number(r.contraction.0, 4), number(r.contraction.1, 4));
    let mut out = pairs(&[
        ("name", f.name.clone()),
        ("kind", f.kind().into()),
        ("equation", f.equation()),
        ("range", range_text(r.outer_diameter_mm, r.wall_mm, r.pressure_mpa, contraction)),
        ("muscles", made_text(f)),
        ("method", p.method.clone()),
        ("table", format!("{} ({} points, {})", known(&p.table), p.points, p.data_hash)),
        ("plan", known(&p.plan_hash)),
        ("program", format!("mckibben {}", p.version)),
    ]);
    out.push_str("\nTerms\n\n");
    let value = |v: f64| format!("{v:+.6e}");
    out.push_str(&match &f.body {
        Body::Paper(c) => {
            let rows =
                paper_terms(c).into_iter().map(|(name, unit, v)| vec![name, value(v), unit.to_owned()]);
            table(&["name", "value", "unit"], rows.collect())
        }
        Body::Global(t) => {
            let rows = t.terms.iter().map(|t| vec![value(t.value), "MPa".into(), t.name()]);
            table(&["value", "unit", "times"], rows.collect())
        }
    });
    out.push_str("\nErrors in % of the muscle's blocked force at the table's highest pressure\n\n");
    out.push_str(&errors_table(error_rows(f)));
    out
}
