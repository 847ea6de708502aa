//! `fit --method universal`: the ends of muscles of every make.

use super::{FitArgs, free_name, terms};
use crate::failure::Failure;
use crate::flags::Format;
use crate::output::text::{number, pairs, table};
use crate::output::{csv, emit, json, save};
use mckibben::formula::{Form, UniversalFormula, UniversalSummary, UniversalTerm};
use mckibben::progress::Silent;
use mckibben_campaign::campaign::rows;
use mckibben_campaign::fit::universal::{UniversalRequest, samples, universal};
use serde_json::json;
use std::path::Path;

pub fn run(args: &FitArgs, path: &Path, form: Form) -> Result<u8, Failure> {
    let foreign = [
        ("--hold-out", args.hold_out.is_some()),
        ("--tables", args.tables.is_some()),
        ("--plots", args.plots.is_some()),
        ("--rubber", args.rubber.is_some()),
        ("--stiffness", args.stiffness.is_some()),
        ("--muscle", args.muscle.is_some()),
    ];
    if let Some((flag, _)) = foreign.into_iter().find(|f| f.1) {
        let message = format!("{flag}: the methods universal and universal-small know no such thing");
        return Err(Failure::input(
            "usage",
            message,
            "leave it out; a campaign says everything of its muscles",
        ));
    }
    free_name(args)?;
    if path.is_file() && path.extension().is_none_or(|e| !e.eq_ignore_ascii_case("parquet")) {
        let message = format!("{}: the method universal takes a campaign in Parquet", path.display());
        return Err(Failure::input("data", message, "`mckibben campaign` makes one"));
    }
    let campaign = rows(path)?;
    let (plan_hash, seed) = (Some(campaign.provenance().plan_sha256.clone()), campaign.provenance().seed);
    let rows = campaign.collect::<Result<Vec<_>, _>>()?;
    let usual = match form {
        Form::Membrane => "universal",
        Form::Bulge => "universal-small",
    };
    let request = UniversalRequest {
        form,
        name: args.name.clone().unwrap_or_else(|| usual.into()),
        table: path.file_name().map(|n| n.to_string_lossy().into_owned()),
        plan_hash,
        seed,
    };
    let fitted = samples(&rows).and_then(|samples| universal(&samples, &request, &Silent));
    let formula = fitted.map_err(|e| Failure::input("fit", format!("{}: {e}", path.display()), ""))?;
    if let Some(file) = &args.output {
        save(file, formula.to_json().as_bytes())?;
    }
    let text = match args.format {
        Format::Json => json::print(&json!(formula)),
        Format::Csv => csv::rows(&terms(&json!(formula)))?,
        Format::Text => {
            let mut text = as_text(&formula);
            if let Some(path) = &args.output {
                text.push_str(&format!("\nThe formula is in {0}: --model {0}\n", path.display()));
            }
            text
        }
    };
    emit(&text, None)?;
    Ok(0)
}

/// A universal formula for people.
pub fn as_text(f: &UniversalFormula) -> String {
    let (p, r) = (&f.provenance, &f.range);
    let known = |v: &Option<String>| v.clone().unwrap_or_else(|| "–".into());
    let interval = |(low, high): (f64, f64)| match high {
        h if h.is_infinite() => format!("from {}", number(low, 4)),
        h => format!("{} to {}", number(low, 4), number(h, 4)),
    };
    let range = format!(
        "s/D0 {}, L0/D0 {}, θ0 {}°, P/μ {}, strand strain up to {}, ε {} of the ideal muscle's largest",
        interval(r.wall_ratio),
        interval(r.length_ratio),
        interval(r.angle_deg),
        interval(r.pressure_per_modulus),
        number(r.strand_strain, 3),
        interval(r.contraction_of_ideal),
    );
    let mut out = pairs(&[
        ("name", f.name.clone()),
        ("kind", format!("universal, {}", f.deficit.form)),
        ("equation", f.equation()),
        ("range", range),
        ("method", p.method.clone()),
        ("table", format!("{} ({} points, {})", known(&p.table), p.points, p.data_hash)),
        ("plan", known(&p.plan_hash)),
        ("program", format!("mckibben {}", p.version)),
    ]);
    out.push_str("\nTerms\n\n");
    let row = |t: &UniversalTerm| vec![format!("{:+.6e}", t.value), f.term_name(t)];
    out.push_str(&table(&["value", "times"], f.deficit.terms.iter().map(row).collect()));
    out.push_str("\nErrors in % of the muscle's blocked force at the same pressure\n\n");
    let header = ["points that pull", "number", "muscles", "rms %", "95 % of them %", "99 % %", "max %"];
    let rows = [("all fitted", f.errors.fit), ("muscles left out, a fifth at a time", f.errors.left_out)];
    out.push_str(&table(&header, rows.map(|(name, e)| errors_row(name, &e)).to_vec()));
    out
}

/// Name, points, muscles, errors in per cent.
pub fn errors_row(name: &str, e: &UniversalSummary) -> Vec<String> {
    let percent = |v: f64| format!("{:.3}", 100.0 * v);
    let mut row = vec![name.to_owned(), e.points.to_string(), e.muscles.to_string()];
    row.extend([e.rms, e.p95, e.p99, e.max].map(percent));
    row
}
