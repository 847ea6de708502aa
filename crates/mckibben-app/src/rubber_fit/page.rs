//! Laws of tension tests as people read them.

use super::RubberFitAnswer;
use crate::{
    UnderstoodTable, Units, number,
    print::{Csv, Page, Rows, Show, Table},
    units::{MEGAPASCALS, NUMBER, PERCENT, Scale},
    words::in_a_row,
};
use mckibben_core::{rubber::Law, warning::Warning};
use mckibben_fit::{
    rubber::{FittedLaw, Measure},
    rubber_over_time::{PronyFit, SofteningFit},
};

const SECONDS: Scale = Scale::fixed("s");

impl Show for RubberFitAnswer {
    fn warnings(&self) -> Vec<Warning> {
        let failed = self.failed.iter().cloned().map(Warning::from);
        self.warnings.iter().cloned().chain(failed).collect()
    }

    fn page(&self, _: &Units) -> Page {
        let mut page = Page::default();
        page.lines(self.understood.iter().map(UnderstoodTable::line));
        page.rows(
            Rows::default()
                .text("points", self.points)
                .text("held out", self.held_out)
                .text("left out", self.left_out)
                .quantity("fitted to stretch", &NUMBER, self.fitted_to_stretch)
                .text(
                    "differences that count",
                    match self.measure {
                        Measure::Absolute => "absolute",
                        Measure::Relative => "relative",
                    },
                ),
        );
        page.gap();
        page.table(self.law_table());
        if self.laws.iter().any(|law| law.modes.len() > 1) {
            let modes = of_each(&self.laws, |law| &law.modes);
            page.gap();
            page.table(
                Table::of(&modes)
                    .text("law", |m| &m.0)
                    .text("mode", |m| m.1.mode.name())
                    .text("points", |m| m.1.errors.points)
                    .quantity("to stretch", &NUMBER, |m| m.1.errors.to_stretch)
                    .unaligned("rms", &MEGAPASCALS.digits(3), |m| m.1.errors.rms_mpa),
            );
        }
        let parameters = of_each(&self.laws, |law| &law.parameters);
        page.gap();
        page.table(
            Table::of(&parameters)
                .text("law", |p| &p.0)
                .text("constant", |p| &p.1.name)
                .unaligned("value", &NUMBER.digits(5), |p| p.1.value)
                .unaligned("standard error", &NUMBER.digits(2), |p| p.1.standard_error)
                .text("unit", |p| p.1.unit)
                .text("identifiable", |p| p.1.identifiable),
        );
        let hoop = number(self.hoop_stretch, 3);
        page.line(format!(
            "in a muscle: axial stretch 0.6 to 1.1, hoop stretch 1 to {hoop}"
        ));
        let held_out = of_each(&self.laws, |law| &law.held_out);
        let share = PERCENT.digits(3);
        page.table_under(
            "Held out: rms of the differences over the rms of the measured stresses, and bias, \
             above zero where the law is too stiff",
            Table::of(&held_out)
                .text("law", |h| &h.0)
                .text("points", |h| h.1.mode.map_or("in a muscle", |m| m.name()))
                .text("number", |h| h.1.errors.points)
                .unaligned("rms", &share, |h| h.1.errors.relative)
                .unaligned("bias", &share, |h| h.1.stiffer),
        );
        if let Some(relaxation) = &self.relaxation {
            relaxation_onto(&mut page, relaxation);
        }
        if let Some(softening) = &self.softening {
            page.gap();
            page.rows(softening_rows(softening));
        }
        page.gap();
        self.closing(&mut page);
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(self.constants())
    }
}

/// What every law has several of, each with the name of its law.
fn of_each<T>(laws: &[FittedLaw], list: impl Fn(&FittedLaw) -> &[T]) -> Vec<(String, &T)> {
    let of_one = |law| list(law).iter().map(move |one| (title(law), one));
    laws.iter().flat_map(of_one).collect()
}

/// The law in words: `mooney-rivlin, constrained to be stable`.
fn title(law: &FittedLaw) -> String {
    let held = if law.constrained {
        ", constrained to be stable"
    } else {
        ""
    };
    format!("{}{held}", law.form.name())
}

fn stability(law: &FittedLaw) -> String {
    match law.quality.unstable_from_hoop_stretch {
        _ if law.law.clone().validated().is_err() => "no stiffness at rest".into(),
        None => "stable".into(),
        Some(hoop_stretch) => {
            let does = if law.law.locks_at().is_some() {
                "locks at"
            } else {
                "unstable from"
            };
            format!("{does} {}", number(hoop_stretch, 3))
        }
    }
}

impl RubberFitAnswer {
    fn law_table(&self) -> Table<'_, FittedLaw> {
        let aicc = self.laws.iter().map(|law| law.quality.aicc);
        let best = aicc.fold(f64::INFINITY, f64::min);
        let stress = MEGAPASCALS.digits(3);
        Table::of(&self.laws)
            .text("", |l| if self.is_recommended(l) { "→" } else { "" })
            .text("law", title)
            .unaligned("μ", &stress, |l| l.quality.shear_modulus_mpa)
            .quantity("R²", &NUMBER.digits(5), |l| l.quality.r_squared)
            .unaligned("rms", &stress, |l| l.quality.rms_mpa)
            .unaligned("relative", &PERCENT.digits(3), |l| l.quality.relative_rms)
            .unaligned("ΔAICc", &NUMBER.digits(3), |l| l.quality.aicc - best)
            .text("in a muscle", stability)
    }

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
        page.line(format!("→ {}: {why}.", title(law)));
    }
}

/// The constants of a law, as in its columns.
fn constants(law: &Law) -> String {
    let constants = law
        .columns()
        .into_iter()
        .map(|(name, v)| format!("{name} {}", number(v, 5)));
    in_a_row(constants)
}

fn relaxation_onto(page: &mut Page, fit: &PronyFit) {
    let stress = MEGAPASCALS.digits(3);
    page.gap();
    page.rows(
        Rows::default()
            .text("relaxation of", fit.form.name())
            .quantity("duration", &SECONDS, fit.duration_s)
            .text("at once", constants(&fit.instantaneous))
            .text("after long", constants(&fit.long_time))
            .quantity("rms", &stress, fit.rms_mpa)
            .quantity("without memory", &stress, fit.elastic_rms_mpa),
    );
    page.gap();
    page.table(
        Table::of(&fit.branches)
            .unaligned("g", &NUMBER, |b| b.share)
            .unaligned("τ", &SECONDS, |b| b.time_constant_s)
            .quantity("g/(1−Σg)", &NUMBER, |b| {
                (b.overstress, b.overstress_standard_error)
            }),
    );
    page.line("g: share of the stress at once (Prony series)");
}

fn softening_rows(fit: &SofteningFit) -> Rows {
    let stress = MEGAPASCALS.digits(3);
    let errors = fit
        .standard_errors
        .iter()
        .map(|e| e.map_or_else(String::new, |e| number(e, 5)));
    Rows::default()
        .text("softening of", fit.form.name())
        .text("first loading", constants(&fit.first_loading))
        .quantity("r", &NUMBER, fit.r)
        .quantity("m", &MEGAPASCALS, fit.m_mpa)
        .quantity("β", &NUMBER, fit.beta)
        .text("standard errors of r, m, β", in_a_row(errors))
        .quantity("largest energy", &MEGAPASCALS, fit.largest_energy_mpa)
        .text("first loading points", fit.first_loading_points)
        .quantity("their rms", &stress, fit.first_loading_rms_mpa)
        .text("later points", fit.later_points)
        .quantity("their rms", &stress, fit.later_rms_mpa)
}
