//! Compared models as people read them.

use super::{CompareAnswer, ComparedModel, Direction};
use crate::{
    UnderstoodTable, Units,
    print::{Csv, Page, Show, Table, sentences},
    units::PERCENT,
    words::in_a_row,
};

impl Show for CompareAnswer {
    fn warnings(&self) -> Vec<String> {
        sentences(&self.warnings)
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = Page::default();
        page.lines(self.understood.iter().map(UnderstoodTable::line));
        page.line(self.muscle.line(u));
        page.line(format!("against {}", self.against(u)));
        page.gap();
        let (there, not): (Vec<&ComparedModel>, Vec<&ComparedModel>) =
            self.models.iter().partition(|m| m.errors.cause.is_none());
        let some = not.iter().copied();
        let some = some.filter(|m| m.errors.rms_n.is_some() || m.errors.volume_points > 0);
        let compared: Vec<&ComparedModel> = there.into_iter().chain(some).collect();
        let force = u.force.digits(3);
        page.table(
            Table::of(&compared)
                .text("model", |m| &m.errors.model)
                .quantity("rms", &force, |m| m.errors.rms_n)
                .quantity("of the largest pull", &PERCENT.digits(3), |m| {
                    m.errors.rms_n.map(|rms| rms / self.largest_force_n)
                })
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
        if self.models.iter().any(|m| m.errors.volume_points > 0) {
            let volume = u.volume.digits(3);
            let points = |m: &ComparedModel| Some(m.errors.volume_points).filter(|n| *n > 0);
            page.paragraph("volume of the cavity:");
            page.table(
                Table::of(&compared)
                    .text("model", |m| &m.errors.model)
                    .quantity("rms", &volume, |m| m.errors.rms_volume_mm3)
                    .quantity("mean", &volume, |m| m.errors.mean_volume_mm3)
                    .text("points", |m| points(m)),
            );
        }
        if self.models.iter().any(|m| m.errors.contraction_points > 0) {
            let points = |m: &ComparedModel| Some(m.errors.contraction_points).filter(|n| *n > 0);
            page.paragraph("contraction under the load:");
            page.table(
                Table::of(&compared)
                    .text("model", |m| &m.errors.model)
                    .quantity("rms", &PERCENT, |m| m.errors.rms_contraction)
                    .quantity("mean", &PERCENT, |m| m.errors.mean_contraction)
                    .text("points", |m| points(m)),
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
        let which = if self.branch == Direction::Mean {
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
