//! `check` of a formula's file.

use crate::asked::Asked;
use crate::commands::fit::{error_rows, errors_table, made_text, range_text, universal_text};
use crate::failure::Failure;
use crate::files;
use crate::format::Format;
use crate::output::emit;
use crate::output::text::{number, pairs, table};
use mckibben::formula::{Body, Document, Formula, paper_terms};
use mckibben_app::{CheckFormulaRequest, Model, ProblemKind, check_formula};

/// Shows a formula: a file, or one that is built in.
pub(super) fn show(word: &str, asked: &Asked) -> Result<u8, Failure> {
    let built_in = Model::is_taken(word);
    let file = if built_in { None } else { files::formula(word)? };
    if file.is_none() && !built_in {
        let message = format!("{word}: cannot be read: there is no such file");
        return Err(Failure::input(ProblemKind::Formula, message, "`mckibben fit` writes such files"));
    }
    if asked.text("pressure_mpa").is_some() {
        return Err(Failure::input(ProblemKind::Usage, "--pressure is of a muscle, not of a formula", ""));
    }
    let latex = asked.is("latex");
    let answer =
        check_formula(&CheckFormulaRequest { file, name: built_in.then(|| word.to_owned()), latex })?;
    match answer.latex.as_ref().filter(|_| asked.format == Format::Text) {
        Some(latex) => emit(latex, asked.path("output").as_deref()).map(|()| 0),
        None => asked.show(&answer, "terms", || text(&answer.formula)),
    }
}

fn text(formula: &Document) -> String {
    match formula {
        Document::Section(f) => as_text(f),
        Document::Universal(f) => universal_text(f),
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
        ("the paper", mckibben::PAPER.into()),
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
