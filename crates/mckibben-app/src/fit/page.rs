//! Fitted formulas as people read them, in the units of the formula.

use super::{CheckFormulaAnswer, FitAnswer, coefficients, is_of_the_paper};
use crate::{
    Units,
    print::{Csv, Page, Show, Table},
    units::{NUMBER, PERCENT},
};
use mckibben_campaign::fit::{
    PaperMethod,
    results::Results,
    signs::{Sign, signs},
};
use mckibben_core::formula::{Body, Document, paper_terms};
use schemars::JsonSchema;
use serde::Serialize;

impl Show for FitAnswer {
    fn page(&self, _: &Units) -> Page {
        let without: &[&str] = match &self.fitted {
            Some(_) => &["terms", "tables"],
            None => &["tables"],
        };
        let mut page = Page::of(self, &Units::default(), without);
        if let Some(fitted) = &self.fitted {
            let (unused, failed) = (fitted.unused, self.failed);
            page.paragraph(format!(
                "{unused} points were not used, {failed} had no answer"
            ));
            if let Some(g) = &fitted.global {
                let (chosen, candidates) = (g.terms.terms.len(), g.candidates);
                page.line(format!("{chosen} of {candidates} candidate terms"));
            }
            if let Some(paper) = &fitted.paper {
                steps(paper, is_of_the_paper(&fitted.formula), &mut page);
            }
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(terms(&self.formula))
    }
}

impl Show for CheckFormulaAnswer {
    fn page(&self, _: &Units) -> Page {
        let without: &[&str] = if self.coefficients.is_empty() {
            &["latex"]
        } else {
            &["latex", "terms", "coefficients"]
        };
        let mut page = Page::of(self, &Units::default(), without);
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
        let length = u.length.digits(4);
        let mut page = Page::default();
        page.line("in % of the blocked force at 0.25 MPa, where the muscle pulls");
        page.gap();
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
        page.and(Page::of(self, &u, &["findings"]));
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.findings)
    }
}
