//! Curves as people read them.

use super::{CurveAnswer, PointRow, StudyAnswer, study_rows};
use crate::{
    Units, breakdown, percent,
    print::{Amount, Column, Csv, Page, Show, Table},
    units::PERCENT,
};
use mckibben_core::{
    by_number::ByNumber,
    curve::{CurvePoint, Test},
    muscle::Direction,
    warning::Warning,
};

impl Show for CurveAnswer {
    fn warnings(&self) -> Vec<Warning> {
        let mut failed = self.points().filter_map(|q| q.answer.as_ref().err());
        let count = failed.clone().count();
        let failed = failed
            .next()
            .map(|first| format!("{count} points have no answer (–); the first: {first}"));
        let mut all = self.warnings.clone();
        all.extend(failed.map(Warning::from));
        all
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = Page::default();
        page.line(format!("{} test, model {}", self.test, self.model));
        page.line(self.muscle.line(u));
        page.gap();
        page.table(self.table(u));
        self.half_widths(&mut page, u);
        if let Some(loaded) = &self.loaded {
            loaded.onto(&mut page, u);
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(self.points().map(PointRow::from))
    }
}

impl CurveAnswer {
    fn points(&self) -> impl Iterator<Item = &CurvePoint> + Clone {
        self.curves.iter().flat_map(|curve| &curve.points)
    }

    /// What the ± are, and the parts of the largest of the pull.
    fn half_widths(&self, page: &mut Page, u: &Units) {
        let of_pull = self
            .points()
            .filter_map(|q| q.answer.as_ref().ok())
            .filter_map(|a| a.uncertainty_parts_n.filter(|_| !a.slack));
        if let Some(largest) = of_pull.max_by_number(|a| a.total()) {
            page.paragraph("medians, ±: 95 %, of a muscle that is built");
            let parts = breakdown(&largest, &u.force);
            page.line(format!("the largest of the pull: {parts}"));
        }
    }

    /// One row per value along the curves, one column per curve.
    fn table(&self, u: &Units) -> Table<'_, CurvePoint> {
        let table = Table::of(self.curves.first().map_or(&[][..], |c| &c.points[..]));
        let mut table = match self.test {
            Test::Isobaric => table.quantity("ε", &PERCENT, |q| q.contraction),
            _ => table.quantity("P", &u.pressure, |q| q.pressure_mpa),
        };
        for (i, curve) in self.curves.iter().enumerate() {
            let (scale, label) = match self.test {
                Test::Isometric => (&u.force, format!("F at ε {}", percent(curve.fixed))),
                Test::Isotonic => (&PERCENT, format!("ε at {}", u.force.show(curve.fixed))),
                Test::Isobaric => (&u.force, format!("F at {}", u.pressure.show(curve.fixed))),
            };
            let branch = if self.both {
                format!(", {}", Direction::BRANCHES[i % 2].motion())
            } else {
                String::new()
            };
            let amounts: Vec<Amount> = curve
                .points
                .iter()
                .map(|q| computed(self.test, q))
                .collect();
            table = table.with(Column::of(&(label + &branch), &scale.digits(4), &amounts));
        }
        table
    }
}

/// The quantity that a test computes, of a muscle that is built with its ±, else by the model.
fn computed(test: Test, q: &CurvePoint) -> Amount {
    match &q.answer {
        Ok(a) if test == Test::Isotonic => (
            a.predicted.unwrap_or(a.response.contraction),
            a.contraction_uncertainty,
        )
            .into(),
        Ok(a) if a.slack => "slack".into(),
        Ok(a) => (
            a.built.map_or(a.response.force_n, |b| b.predicted_n),
            a.uncertainty_n,
        )
            .into(),
        Err(_) => Amount::Nothing,
    }
}

impl Show for StudyAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = Page::of(self, u, &["points"]);
        let curve = self.panels.first().and_then(|panel| panel.curves.first());
        let points = curve.map_or(1, |curve| curve.curve.points.len());
        let ends: Vec<_> = study_rows(&self.panels)
            .skip(points - 1)
            .step_by(points)
            .collect();
        page.list(
            "",
            &ends,
            u,
            &[
                "test",
                "fixed",
                "curve",
                "pressure_mpa",
                "force_n",
                "contraction",
            ],
        );
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(study_rows(&self.panels))
    }
}
