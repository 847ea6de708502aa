//! Fitted formulas as people read them, in the units of the formula.

use super::{CheckFormulaAnswer, FitAnswer, coefficients};
use crate::{
    Units,
    print::{Csv, Page, Show},
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
            let unused = fitted.unused;
            let failed = self.failed;
            page.paragraph(format!(
                "{unused} points were not used, {failed} had no answer"
            ));
            if let (Body::Global(g), Some(candidates)) = (&fitted.formula.body, fitted.candidates) {
                let chosen = g.terms.len();
                page.line(format!("{chosen} of {candidates} candidate terms"));
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
            Body::Global(t) => t
                .terms
                .iter()
                .map(|t| (t.name(), "MPa", t.value))
                .map(row)
                .collect(),
        },
        Document::Universal(f) => f
            .terms
            .iter()
            .map(|t| row((f.term_name(t), "1", t.value)))
            .collect(),
    }
}
