//! What `fit` tells people.

use crate::output::text::{number, pairs, place, table};
use mckibben::formula::{Document, ErrorSummary, Formula, UniversalFormula, UniversalSummary, UniversalTerm};
use mckibben_app::FitAnswer;
use mckibben_campaign::fit::signs::signs;
use mckibben_campaign::fit::{FittedFormula, PaperMethod};
use std::path::Path;

/// Shares in per cent, differences in N.
fn cells(name: String, e: &ErrorSummary) -> Vec<String> {
    let percent = |v: f64| format!("{:.3}", 100.0 * v);
    let mut row = vec![name, e.points.to_string(), percent(e.rms), percent(e.p95), percent(e.max)];
    row.extend([percent(e.max_12), format!("{:.1}", e.max_n)]);
    row
}

/// Rows of a formula's errors: all, held out, by region.
pub fn error_rows(formula: &Formula) -> Vec<Vec<String>> {
    let mut rows = vec![cells("all fitted".into(), &formula.errors.fit)];
    if let Some(h) = &formula.errors.held_out {
        let list: Vec<String> = h.outer_diameters_mm.iter().map(|d| number(*d, 4)).collect();
        rows.push(cells(format!("held out: D0 {}", list.join(", ")), &h.errors));
    }
    for r in &formula.errors.regions {
        let letter = match r.quantity.as_str() {
            "outer_diameter_mm" => "D0",
            "wall_mm" => "s",
            "pressure_mpa" => "P",
            _ => "ε",
        };
        rows.push(cells(format!("{letter} {}", number(r.value, 4)), &r.errors));
    }
    rows
}

pub fn errors_table(rows: Vec<Vec<String>>) -> String {
    table(&["points that pull", "number", "rms %", "95 % of them %", "max %", "(12) max %", "max N"], rows)
}

/// Rows of the table of regions that people see at once; the file has all.
const SHOWN: usize = 40;

/// A fitted formula, and where it was written.
pub fn of(answer: &FitAnswer, output: Option<&Path>) -> String {
    let mut out = match (&answer.formula, &answer.fitted) {
        (_, Some(fitted)) => section(fitted, answer.failed),
        (Document::Universal(formula), None) => universal(formula),
        // Formulas for muscles of one make come with what was found on the way.
        (Document::Section(_), None) => String::new(),
    };
    if let Some(path) = output {
        out.push_str(&format!("\nThe formula is in {0}: --model {0}\n", place(path)));
    }
    out
}

fn section(f: &FittedFormula, failed: usize) -> String {
    let formula = &f.formula;
    let (p, r) = (&formula.provenance, &formula.range);
    let interval = |(low, high): (f64, f64)| format!("{} to {}", number(low, 4), number(high, 4));
    let mut list = vec![
        ("method", p.method.clone()),
        ("points", format!("{} fitted, {} not used, {failed} without an answer", p.points, f.unused)),
        ("range", range_text(r.outer_diameter_mm, r.wall_mm, r.pressure_mpa, interval(r.contraction))),
        ("muscles", made_text(formula)),
    ];
    if let Some(g) = &f.global {
        list.push(("terms", format!("{} of {} candidates", g.terms.terms.len(), g.candidates)));
        if let Some(step) = g.steps.get(g.terms.terms.len().saturating_sub(1))
            && let Some(left_out) = step.left_out
        {
            let text = format!("rms {:.3} % on inner diameters left out one at a time", 100.0 * left_out);
            list.push(("chosen by", text));
        }
    }
    let mut out = pairs(&list);
    out.push_str("\nErrors in % of the muscle's blocked force at the table's highest pressure; (12) in % of the largest force of the isobar\n\n");
    let rows: Vec<Vec<String>> = error_rows(formula).into_iter().take(SHOWN).collect();
    out.push_str(&errors_table(rows));
    if let Some(method) = &f.paper {
        out.push_str(&signs_text(method));
    }
    out
}

/// The range in one line.
pub fn range_text(d: (f64, f64), s: (f64, f64), p: (f64, f64), contraction: String) -> String {
    let interval = |(low, high): (f64, f64)| format!("{} to {}", number(low, 4), number(high, 4));
    format!("D0 {} mm, s {} mm, P {} MPa, ε {contraction}", interval(d), interval(s), interval(p))
}

/// The muscles in one line.
pub fn made_text(formula: &Formula) -> String {
    let m = &formula.made_for;
    format!(
        "L0 {} mm, θ0 {}°, rubber {}, braid {}",
        number(m.length_mm, 5),
        number(m.angle_deg, 4),
        m.rubber.text(),
        m.braid_text()
    )
}

/// R² of the steps, curves that a rule changed, and the signs of section 3.3.1.
fn signs_text(m: &PaperMethod) -> String {
    let smallest = |list: &mut dyn Iterator<Item = f64>| list.fold(1.0, f64::min);
    let steps = [
        ("F over ε (5)", smallest(&mut m.curves.iter().filter_map(|c| c.abc).map(|f| f.r2))),
        ("a, b, c over P (8)", smallest(&mut m.lines.iter().flat_map(|l| l.lines).map(|f| f.r2))),
        (
            "m, q over s (9)",
            smallest(&mut m.walls.iter().flat_map(|w| w.parabolas.into_iter().flatten()).map(|f| f.r2)),
        ),
        ("X over D0 (11)", smallest(&mut m.r2.into_iter().flatten())),
    ];
    let list: Vec<String> = steps.iter().map(|(name, r2)| format!("{name} {r2:.4}")).collect();
    let mut out = format!("\nSmallest R² of each step: {}\n", list.join("; "));
    for c in m.curves.iter().filter(|c| !c.rule.is_empty()) {
        let (d, s, p) = (c.outer_diameter_mm, c.wall_mm, c.pressure_mpa);
        out.push_str(&format!("Curve D0 {d}, s {s} mm at {p} MPa: {}\n", c.rule));
    }
    out.push_str("\nSigns that section 3.3.1 of the paper states (pairs of neighbouring curves)\n\n");
    let rows = signs(m).into_iter().map(|s| {
        vec![
            format!("D0 {}", number(s.outer_diameter_mm, 4)),
            format!("{} {} with {}", s.coefficient, if s.rises { "rises" } else { "falls" }, s.with),
            format!("{} of {}", s.holding, s.pairs),
            if s.holds() { "holds" } else { "does not hold" }.into(),
        ]
    });
    out.push_str(&table(&["", "statement", "pairs", "verdict"], rows.collect()));
    out
}

/// A universal formula for people.
pub fn universal(f: &UniversalFormula) -> String {
    let (p, r) = (&f.provenance, &f.range);
    let known = |v: &Option<String>| v.clone().unwrap_or_else(|| "–".into());
    let interval = |(low, high): (f64, f64)| match high {
        h if h.is_infinite() => format!("from {}", number(low, 4)),
        h => format!("{} to {}", number(low, 4), number(h, 4)),
    };
    let range = format!(
        "s/D0 {}, L0/D0 {}, θ0 {}°, P/μ {}, strand strain up to {}, ε {} of the ideal muscle's largest, C01/(C10 + C01) {}",
        interval(r.wall_ratio),
        interval(r.length_ratio),
        interval(r.angle_deg),
        interval(r.pressure_per_modulus),
        number(r.strand_strain, 3),
        interval(r.contraction_of_ideal),
        interval(r.c01_share),
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
