//! Laws of tension tests as people read them.

use super::RubberFitAnswer;
use crate::{
    UnderstoodTable, Units, number,
    print::{Csv, Page, Show},
};
use mckibben_core::warning::Warning;
use mckibben_fit::rubber::FittedLaw;

/// Fields that stand otherwise on the page, or in files.
const APART: [&str; 5] = ["understood", "law", "parameters", "failed", "muscle_file"];

impl Show for RubberFitAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings
            .iter()
            .cloned()
            .chain(self.failed.iter().cloned().map(Warning::from))
            .collect()
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = UnderstoodTable::lines(&self.understood);
        page.and(Page::of(self, u, &APART));
        let constants = [
            "law",
            "constant",
            "value",
            "standard_error",
            "unit",
            "identifiable",
        ];
        page.list("constants", &self.constants(), u, &constants);
        let hoop = number(self.hoop_stretch, 3);
        page.paragraph(format!(
            "stable: in a muscle, at axial stretches of 0.6 to 1.1 and hoop stretches of 1 to {hoop}"
        ));
        if self.held_out > 0 {
            page.line("mode –: points of all modes in whose state a muscle's wall may be");
        }
        self.closing(&mut page);
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(self.constants())
    }
}

impl RubberFitAnswer {
    /// What holding a law stable costs, and why one is recommended.
    fn closing(&self, page: &mut Page) {
        for law in &self.laws {
            if let Some(free) = law.quality.free_r_squared {
                let name = law.form.name();
                let how = law.stability_words();
                let with = law.quality.r_squared;
                page.line(format!("{name} {how}: R² {with:.5} instead of {free:.5}."));
            }
        }
        let Some(law) = self.taken() else {
            page.line("None of these laws is stable over the stretches of a muscle; use `stable`.");
            return;
        };
        let lower =
            |other: &&FittedLaw| other.is_trusted() && other.quality.aicc < law.quality.aicc;
        let why = match (self.laws.len(), self.laws.iter().find(lower)) {
            (1, _) => "stable in a muscle",
            (_, None) => "the lowest AICc of the laws that are valid in a muscle",
            _ => {
                "the lowest AICc of the laws of I1 alone, since tests along one axis do not decide \
                 between the others"
            }
        };
        page.line(format!("recommended: {}, {why}.", law.form.name()));
    }
}
