//! Compared models as people read them.

use super::{CompareAnswer, ComparedModel};
use crate::{
    UnderstoodTable, Units,
    print::{Csv, Page, Show, Table},
    units::{NUMBER, PERCENT},
    words::in_a_row,
};
use mckibben_core::warning::Warning;
use mckibben_fit::compare::Comparison;

impl Show for CompareAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = Page::default();
        page.lines(self.understood.iter().map(UnderstoodTable::line));
        page.line(self.muscle.line(u));
        page.line(format!("against {}", self.against(u)));
        page.gap();
        let (there, not): (Vec<&ComparedModel>, Vec<&ComparedModel>) =
            self.models.iter().partition(|m| m.errors.cause.is_none());
        let some = not
            .iter()
            .copied()
            .filter(|m| m.errors.rms_n.is_some() || m.errors.volume_points > 0);
        let compared: Vec<&ComparedModel> = there.into_iter().chain(some).collect();
        let force = u.force.digits(3);
        page.table(
            Table::of(&compared)
                .text("model", |m| &m.errors.model)
                .quantity("rms", &force, |m| m.errors.rms_n)
                .quantity("of the largest pull", &PERCENT.digits(3), |m| {
                    m.errors.rms_n.map(|rms| rms / self.largest_force_n)
                })
                .quantity("R²", &NUMBER.digits(4), |m| m.errors.r_squared)
                .quantity("largest", &force, |m| m.errors.max_n)
                .quantity("mean", &force, |m| m.errors.mean_n)
                .text("points", |m| m.errors.points)
                .text("fitted", |m| match m.fitted() {
                    none if none.is_empty() && self.is_fitted => {
                        "none of the constants to fit".into()
                    }
                    fitted => fitted,
                }),
        );
        page.paragraph("mean: above zero if the model predicts too much pull");
        // Beside the pulls: what of them, its unit, and its points with rms and mean of the errors.
        type Beside = fn(&Comparison) -> (usize, Option<f64>, Option<f64>);
        let volumes: Beside = |e| (e.volume_points, e.rms_volume_mm3, e.mean_volume_mm3);
        let contractions: Beside =
            |e| (e.contraction_points, e.rms_contraction, e.mean_contraction);
        for (what, scale, of) in [
            ("volume of the cavity:", &u.volume.digits(3), volumes),
            ("contraction under the load:", &PERCENT, contractions),
        ] {
            if self.models.iter().all(|m| of(&m.errors).0 == 0) {
                continue;
            }
            page.paragraph(what);
            page.table(
                Table::of(&compared)
                    .text("model", |m| &m.errors.model)
                    .quantity("rms", scale, |m| of(&m.errors).1)
                    .quantity("mean", scale, |m| of(&m.errors).2)
                    .text("points", |m| Some(of(&m.errors).0).filter(|n| *n > 0)),
            );
        }
        let cause = |m: &ComparedModel| Some(u.sentence(m.errors.cause.as_ref()?));
        page.table_under(
            "not compared, or not at these points:",
            Table::of(&not)
                .text("model", |m| &m.errors.model)
                .text("points", |m| Some(m.errors.unanswered).filter(|n| *n > 0))
                .text("cause", |m| cause(m)),
        );
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.models)
    }
}

impl CompareAnswer {
    /// What the models are compared with.
    fn against(&self, u: &Units) -> String {
        if self.understood.is_empty() {
            return format!("the model {}", self.reference);
        }
        let which = if self.branch.is_mean() {
            " (mean of the branches where both are given)"
        } else {
            ""
        };
        let names = in_a_row(self.understood.iter().map(|table| table.data.clone()));
        let points = self.points;
        let largest = u.force.show(self.largest_force_n);
        format!("{points} points of {names}{which}, largest {largest}")
    }
}
