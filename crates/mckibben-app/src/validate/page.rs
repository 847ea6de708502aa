//! The cases of verification and validation as people read them.

use super::ValidateAnswer;
use crate::{
    Units,
    print::{Csv, Page, Show, Table},
    units::NUMBER,
};
use mckibben_core::verification::{CaseKind, Measure, VerificationRow};

/// The cases of one kind, and what they are.
const KINDS: [(&str, CaseKind, Measure, &str); 4] = [
    (
        "verification",
        CaseKind::Verification,
        Measure::Value,
        "Verification: are the equations solved right?",
    ),
    (
        "measured pulls",
        CaseKind::Validation,
        Measure::Rms,
        "Validation: are they the right equations? Root mean square of the differences from \
         measured pulls in N, over the largest or blocked one",
    ),
    (
        "other measured quantities",
        CaseKind::Validation,
        Measure::Value,
        "Validation: other measured quantities",
    ),
    (
        "± of fe",
        CaseKind::Validation,
        Measure::Share,
        "Validation: which share of measured points does the ± cover?",
    ),
];

impl Show for ValidateAnswer {
    fn page(&self, _: &Units) -> Page {
        let mut page = Page::default();
        let mut summary = vec![];
        for (name, kind, measure, title) in KINDS {
            let is_one = |c: &&VerificationRow| {
                c.kind == kind && (kind == CaseKind::Verification || c.measure == measure)
            };
            let list: Vec<&VerificationRow> = self.cases.iter().filter(is_one).collect();
            let value = NUMBER.digits(9);
            let error = NUMBER.digits(2);
            let mut table = Table::of(&list)
                .text("ok", |c| c.ok)
                .text("case", |c| &c.name)
                .unaligned("reference", &value, |c| c.reference)
                .unaligned("ours", &value, |c| c.ours)
                .unaligned("error", &error, |c| c.error)
                .unaligned("allowed", &error, |c| c.tolerance);
            if self.has_sources {
                table = table.text("source", |c| c.source);
            }
            page.line(title);
            page.gap();
            page.table(table);
            page.gap();
            let held = list.iter().filter(|c| c.ok).count();
            summary.push(format!("  {name}: {held} of {} cases hold", list.len()));
        }
        page.line("Summary");
        page.lines(summary);
        let failed = self.cases.iter().filter(|c| !c.ok);
        page.lines(failed.map(|c| format!("  FAILS: {}", c.name)));
        if !self.has_sources {
            page.paragraph("Sources of the cases: the table in CSV");
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.cases)
    }
}
