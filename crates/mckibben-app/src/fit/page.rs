//! Fitted formulas as people read them, in the units of the formula.

use super::{CheckFormulaAnswer, FitAnswer, coefficients, is_of_the_paper};
use crate::{
    Units, number,
    print::{Csv, Page, Rows, Show, Table},
    units::{DEGREES, NUMBER, PERCENT},
    words::in_a_row,
};
use mckibben_campaign::fit::{
    FittedFormula, PaperMethod,
    results::Results,
    signs::{Sign, signs},
};
use mckibben_core::formula::{
    Body, Document, Formula, FormulaErrors, Made, MadeBraid, NamedBraid, UniversalFormula,
    UniversalSummary, paper_terms,
};
use schemars::JsonSchema;
use serde::Serialize;

impl Show for FitAnswer {
    fn page(&self, _: &Units) -> Page {
        let mut page = formula_page(&self.formula, self.fitted.is_none());
        if let Some(fitted) = &self.fitted {
            intermediate(fitted, self.failed, &mut page);
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(terms(&self.formula))
    }
}

impl Show for CheckFormulaAnswer {
    fn page(&self, _: &Units) -> Page {
        let mut page = formula_page(&self.formula, self.coefficients.is_empty());
        page.table_under(
            "Coefficients of (11), published and fitted",
            coefficients::table(&self.coefficients),
        );
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(terms(&self.formula))
    }
}

/// A term of a formula.
#[derive(Serialize, JsonSchema)]
struct TermRow {
    name: String,
    unit: &'static str,
    value: f64,
}

fn terms(formula: &Document) -> Vec<TermRow> {
    let row = |(name, unit, value)| TermRow { name, unit, value };
    match formula {
        Document::Section(f) => match &f.body {
            Body::Paper(c) => paper_terms(c).into_iter().map(row).collect(),
            Body::Global(t) => {
                let terms = t.terms.iter().map(|t| (t.name(), "MPa", t.value));
                terms.map(row).collect()
            }
        },
        Document::Universal(f) => {
            let terms = f.terms.iter();
            terms.map(|t| row((f.term_name(t), "1", t.value))).collect()
        }
    }
}

/// What a formula is, where it holds, and its errors; with its terms if that is wanted.
fn formula_page(formula: &Document, with_terms: bool) -> Page {
    let (rows, provenance, against) = match formula {
        Document::Section(f) => (section(f), &f.provenance, &f.errors.against),
        Document::Universal(f) => (universal(f), &f.provenance, &f.errors.against),
    };
    let mut page = Page::from(
        rows.text("method", &provenance.method)
            .text("points", provenance.points)
            .text("table", &provenance.table)
            .text("data", &provenance.data_hash)
            .text("plan", &provenance.plan_hash)
            .text("mckibben", &provenance.version),
    );
    if with_terms {
        page.paragraph("Terms");
        page.gap();
        page.table(
            Table::of(&terms(formula))
                .unaligned("value", &NUMBER.digits(7), |t| t.value)
                .text("unit", |t| t.unit)
                .text("name", |t| &t.name),
        );
    }
    page.paragraph(format!("Errors against {against}"));
    page.gap();
    match formula {
        Document::Section(f) => section_errors(&f.errors, &mut page),
        Document::Universal(f) => {
            let left_out = "muscles left out, a fifth at a time";
            let rows = [
                ("all fitted", &f.errors.fit),
                (left_out, &f.errors.left_out),
            ];
            universal_errors("points that pull", &rows, &mut page);
        }
    }
    page
}

fn section(f: &Formula) -> Rows {
    let kind = match &f.body {
        Body::Paper(_) => "paper",
        Body::Global(_) => "global",
    };
    let (range, made) = (&f.range, &f.made_for);
    let u = Units::default();
    let constants = made.rubber.constants.iter();
    let constants = constants.map(|(name, v)| format!("{name} {}", number(*v, 5)));
    Rows::default()
        .text("name", &f.name)
        .text("kind", kind)
        .text("equation", f.equation())
        .text(
            "range",
            [
                interval("outer_diameter_mm", range.outer_diameter_mm),
                interval("wall_mm", range.wall_mm),
                interval("pressure_mpa", range.pressure_mpa),
                interval("contraction", range.contraction),
            ]
            .join(", "),
        )
        .quantity("L0", &u.length.digits(4), made.length_mm)
        .quantity("θ0", &DEGREES, made.angle_deg)
        .text("rubber", &made.rubber.name)
        .text("law", &made.rubber.law)
        .text("constants", in_a_row(constants))
        .text("braid", braid(made))
}

fn braid(made: &Made) -> String {
    match made.braid {
        MadeBraid::Named(NamedBraid::Paper) => "stiffness paper".into(),
        MadeBraid::Named(NamedBraid::Inextensible) => "stiffness inextensible".into(),
        MadeBraid::Stiffness(k) => format!("stiffness_n_per_mm {}", number(k, 5)),
        MadeBraid::TimesDiameter(k) => {
            format!("stiffness_times_diameter_n {}", number(k, 5))
        }
    }
}

fn universal(f: &UniversalFormula) -> Rows {
    let range = &f.range;
    Rows::default()
        .text("name", &f.name)
        .text("kind", "universal")
        .text("form", "membrane")
        .text("equation", f.equation())
        .text(
            "range",
            [
                interval("wall_ratio", range.wall_ratio),
                interval("length_ratio", range.length_ratio),
                interval("angle_deg", range.angle_deg),
                interval("pressure_per_modulus", range.pressure_per_modulus),
                format!("strand_strain {}", number(range.strand_strain, 5)),
                interval("contraction_of_ideal", range.contraction_of_ideal),
                interval("c01_share", range.c01_share),
            ]
            .join(", "),
        )
}

/// The ends of a range; an upper one may be open.
fn interval(name: &str, (low, high): (f64, f64)) -> String {
    let high = if high.is_finite() {
        number(high, 5)
    } else {
        String::new()
    };
    format!("{name} {}..{high}", number(low, 5))
}

/// The errors of all points, of those that were left out, and by region.
fn section_errors(errors: &FormulaErrors, page: &mut Page) {
    let mut rows = vec![("all fitted".to_owned(), &errors.fit)];
    if let Some(held_out) = &errors.held_out {
        let diameters = held_out.outer_diameters_mm.iter().map(|d| number(*d, 4));
        let name = match in_a_row(diameters) {
            none if none.is_empty() => "held out".to_owned(),
            listed => format!("held out: D0 {listed}"),
        };
        rows.push((name, &held_out.errors));
    }
    rows.extend(errors.regions.iter().map(|region| {
        let name = format!("{} {}", region.quantity, number(region.value, 4));
        (name, &region.errors)
    }));
    let share = PERCENT.digits(3);
    let force = Units::default().force.digits(3);
    page.table(
        Table::of(&rows)
            .text("points that pull", |e| &e.0)
            .text("number", |e| e.1.points)
            .quantity("rms", &share, |e| e.1.rms)
            .quantity("95 % of them", &share, |e| e.1.p95)
            .quantity("largest", &share, |e| e.1.max)
            .quantity("(12)", &share, |e| e.1.max_12)
            .unaligned("largest", &force, |e| e.1.max_n),
    );
}

fn universal_errors(heading: &str, rows: &[(&str, &UniversalSummary)], page: &mut Page) {
    let share = PERCENT.digits(3);
    page.table(
        Table::of(rows)
            .text(heading, |e| e.0)
            .text("number", |e| e.1.points)
            .text("muscles", |e| e.1.muscles)
            .unaligned("rms", &share, |e| e.1.rms)
            .unaligned("95 % of them", &share, |e| e.1.p95)
            .unaligned("99 %", &share, |e| e.1.p99)
            .unaligned("largest", &share, |e| e.1.max),
    );
}

/// Intermediate results of a formula for muscles of one make.
fn intermediate(f: &FittedFormula, failed: usize, page: &mut Page) {
    let unused = f.unused;
    page.paragraph(format!(
        "{unused} points were not used, {failed} had no answer"
    ));
    if let Some(g) = &f.global {
        let chosen = g.terms.terms.len();
        let candidates = g.candidates;
        let step = g.steps.get(chosen.saturating_sub(1));
        let step = step.filter(|_| chosen < candidates);
        let why = step.and_then(|step| step.left_out).map(|rms| {
            let rms = 100.0 * rms;
            format!(", chosen by rms {rms:.3} % on inner diameters left out one at a time")
        });
        let why = why.unwrap_or_default();
        page.line(format!("{chosen} of {candidates} candidate terms{why}"));
    }
    if let Some(paper) = &f.paper {
        steps(paper, is_of_the_paper(&f.formula), page);
    }
}

/// R² of the steps, curves that a rule changed, and of the paper's muscles the signs of section 3.3.1.
fn steps(m: &PaperMethod, of_the_paper: bool, page: &mut Page) {
    let smallest = |list: &mut dyn Iterator<Item = f64>| list.fold(1.0, f64::min);
    let parabolas = m.walls.iter().flat_map(|w| w.parabolas.iter().flatten());
    let curves = smallest(&mut m.curves.iter().filter_map(|c| Some(c.abc?.r2)));
    let lines = smallest(&mut m.lines.iter().flat_map(|l| l.lines).map(|f| f.r2));
    let walls = smallest(&mut parabolas.map(|f| f.r2));
    let diameters = smallest(&mut m.r2.into_iter().flatten());
    page.paragraph(format!(
        "Smallest R² of each step: F over ε (5) {curves:.4}; a, b, c over P (8) {lines:.4}; m, q \
         over s (9) {walls:.4}; X over D0 (11) {diameters:.4}"
    ));
    for c in m.curves.iter().filter(|c| !c.rule.is_empty()) {
        let d = c.outer_diameter_mm;
        let s = c.wall_mm;
        let p = c.pressure_mpa;
        page.line(format!("Curve D0 {d}, s {s} mm at {p} MPa: {}", c.rule));
    }
    if !of_the_paper {
        return;
    }
    page.paragraph("Signs that section 3.3.1 of the paper states (pairs of neighbouring curves)");
    page.gap();
    let length = Units::default().length.digits(4);
    page.table(
        Table::of(&signs(m))
            .quantity("D0", &length, |s| s.outer_diameter_mm)
            .text("statement", |s| {
                let does = if s.rises { "rises" } else { "falls" };
                format!("{} {does} with {}", s.coefficient, s.with)
            })
            .text("pairs", |s| format!("{} of {}", s.holding, s.pairs))
            .text("holds", Sign::holds),
    );
}

impl Show for Results {
    fn page(&self, _: &Units) -> Page {
        let u = Units::default();
        let share = PERCENT.digits(3);
        let mut page = Page::default();
        page.line(
            "In % of the finite elements' blocked force of the same muscle at 0.25 MPa, over \
             points where they pull",
        );
        page.gap();
        let length = u.length.digits(4);
        page.table(
            Table::of(&self.findings)
                .unaligned("at most", &share, |f| f.at_most)
                .quantity("largest", &share, |f| f.errors.summary.max)
                .quantity("rms", &share, |f| f.errors.summary.rms)
                .quantity("(12)", &share, |f| f.errors.summary.max_12)
                .quantity("largest", &u.force.digits(3), |f| f.errors.summary.max_n)
                .text("points", |f| f.errors.summary.points)
                .text("comparison", |f| &f.comparison)
                .quantity("worst at D0", &length, |f| f.errors.worst.outer_diameter_mm)
                .quantity("s", &length, |f| f.errors.worst.wall_mm)
                .quantity("P", &u.pressure, |f| f.errors.worst.pressure_mpa)
                .quantity("ε", &NUMBER, |f| f.errors.worst.contraction),
        );
        page.paragraph(
            "Random muscles of any size and material, where they pull, in % of the blocked force \
             at the same pressure",
        );
        page.gap();
        let random = self.random_muscles.iter();
        let random = random.map(|row| (row.model.as_str(), &row.errors));
        universal_errors("model", &random.collect::<Vec<_>>(), &mut page);
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.findings)
    }
}
