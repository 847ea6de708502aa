//! The validation reports of measured muscles and rubbers as people read them.

use super::{
    MeasuredAnswer, MeasuredBranch, MeasuredCase, MeasuredFacts, MeasuredResult, MeasuredRubber,
    MeasuredRubberFit, MeasuredStress,
};
use crate::{
    Units, in_one_line, number,
    print::{Csv, Page, Rows, Show, Table},
    units::{MEGAPASCALS, NUMBER, PERCENT},
    words::in_a_row,
};

impl Show for MeasuredAnswer {
    fn page(&self, u: &Units) -> Page {
        let mut page = Page::default();
        if !self.cases.is_empty() {
            page.line(format!(
                "Validation: {} against measured muscles. Bias is measured − computed; % is of the \
                 blocked force; within ± is the share of the points inside the ±. Errors by \
                 contraction: in JSON",
                self.model
            ));
        }
        for case in &self.cases {
            case.onto(&mut page, &self.results, u);
        }
        for case in &self.rubbers {
            case.onto(&mut page, &self.stresses);
        }
        page
    }

    fn csv(&self) -> Csv {
        if self.results.is_empty() {
            Csv::rows(&self.stresses)
        } else {
            Csv::rows(&self.results)
        }
    }
}

/// What is known of a case, and its fitted constants.
fn head(page: &mut Page, about: (&MeasuredFacts, usize), title: &str, found: Rows) {
    let (facts, points) = about;
    page.line("");
    page.line(format!("{}{title}", facts.title));
    page.line("");
    page.rows(
        Rows::default()
            .text("folder", &facts.name)
            .text("source", &facts.source)
            .text("terms", &facts.terms)
            .text("known", &facts.known)
            .text("unknown", &facts.unknown)
            .text("points", points),
    );
    page.paragraph("Found, ± 95 %");
    page.rows(found);
    page.gap();
}

impl MeasuredCase {
    fn onto(&self, page: &mut Page, results: &[MeasuredResult], u: &Units) {
        let found = self.fits.iter().filter(|f| !f.parameters.is_empty()).fold(
            Rows::default(),
            |rows, f| {
                let label = format!("{} [{}]", f.fit, f.fitted_to);
                rows.text(&label, in_one_line(&f.parameters))
            },
        );
        head(
            page,
            (&self.facts, self.points),
            ", points that pull",
            found,
        );
        let results: Vec<&MeasuredResult> = results
            .iter()
            .filter(|r| r.case == self.facts.name)
            .collect();
        let force = u.force.digits(3);
        let share = PERCENT.digits(3);
        page.table(
            Table::of(&results)
                .quantity("rms", &force, |r| r.group.means.rms_n)
                .quantity("of the blocked force", &share, |r| {
                    r.group.means.rms_of_blocked
                })
                .quantity("bias", &force, |r| r.group.means.bias_n)
                .quantity("largest", &force, |r| r.group.means.largest_n)
                .text("points", |r| r.group.means.points)
                .text("unanswered", |r| r.group.unanswered)
                .quantity("within ±", &share, |r| r.group.means.held)
                .text("blind", |r| r.group.blind)
                .text("of", |r| &r.group.of)
                .text("fitted to", |r| &r.fitted_to)
                .text("fit", |r| &r.fit),
        );
        let branches: Vec<(&MeasuredBranch, String)> = results
            .iter()
            .flat_map(|r| {
                r.group
                    .by_branch
                    .iter()
                    .map(move |b| (b, format!("{} [{}]", r.fit, r.group.of)))
            })
            .collect();
        page.table_under(
            "Branches",
            Table::of(&branches)
                .text("branch", |b| b.0.branch.name())
                .text("points", |b| b.0.errors.points)
                .quantity("rms", &force, |b| b.0.errors.rms_n)
                .quantity("bias", &force, |b| b.0.errors.bias_n)
                .quantity("within ±", &share, |b| b.0.errors.held)
                .text("of", |b| &b.1),
        );
    }
}

impl MeasuredRubber {
    fn onto(&self, page: &mut Page, stresses: &[MeasuredStress]) {
        let found = self.fits.iter().fold(Rows::default(), |rows, fit| {
            rows.text(&fit.fit, constants(fit))
        });
        let title = "; % is of the measured stress";
        head(page, (&self.facts, self.points), title, found);
        let errors: Vec<&MeasuredStress> = stresses
            .iter()
            .filter(|s| s.case == self.facts.name)
            .collect();
        let stress = MEGAPASCALS.digits(3);
        page.table(
            Table::of(&errors)
                .unaligned("rms", &stress, |s| s.group.errors.rms_mpa)
                .unaligned("of the measured", &PERCENT.digits(3), |s| {
                    s.group.errors.relative
                })
                .unaligned("bias", &stress, |s| s.group.errors.bias_mpa)
                .unaligned("largest", &stress, |s| s.group.errors.largest_mpa)
                .text("points", |s| s.group.errors.points)
                .quantity("to stretch", &NUMBER.digits(3), |s| {
                    s.group.errors.to_stretch
                })
                .text("blind", |s| s.group.blind)
                .text("of", |s| &s.group.of)
                .text("fit", |s| &s.fit),
        );
    }
}

/// The constants of a fitted law, its Prony series, and whether it is doubtful.
fn constants(fit: &MeasuredRubberFit) -> String {
    let constants = fit.parameters.iter().map(|p| {
        format!("{} {} {}", p.name, number(p.value, 3), p.unit)
            .trim()
            .to_owned()
    });
    let branches = fit
        .prony
        .iter()
        .map(|(share, time_s)| format!("g {} at {} s", number(*share, 2), number(*time_s, 2)));
    let doubt = (!fit.stable).then(|| "not stable in a muscle".to_owned());
    in_a_row(constants.chain(branches).chain(doubt))
}
