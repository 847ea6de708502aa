//! Curves as people read them.

use super::{CurveAnswer, PointRow, StudyAnswer, study_rows};
use crate::{
    Units, breakdown, percent,
    print::{Csv, Page, Show, Table},
    units::PERCENT,
    words::{aligned, half_width, within},
};
use mckibben_core::{
    answer::Answer,
    by_number::ByNumber,
    curve::{Curve, CurvePoint, Test},
    muscle::Direction,
    study::StudyPanel,
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
        page.line(format!("{} test, model {}", self.test.name(), self.model));
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

    /// The ± of the quantity that the test computes, from the least to the largest.
    fn half_widths(&self, page: &mut Page, u: &Units) {
        let answers = || self.points().filter_map(|q| q.answer.as_ref().ok());
        let known = || answers().filter_map(|a| computed(self.test, a, u)?.1);
        let Some((low, high)) = known().reduce(f64::min).zip(known().reduce(f64::max)) else {
            return;
        };
        let unit = match self.test {
            Test::Isotonic => "%",
            _ => &u.force.name,
        };
        let low = half_width(low);
        let high = half_width(high);
        page.paragraph(format!(
            "± {low} to {high} {unit}: 95 %, of a muscle that is built"
        ));
        let of_pull = answers().filter_map(|a| a.uncertainty_parts_n.filter(|_| !a.slack));
        if let Some(largest) = of_pull.max_by_number(|a| a.total()) {
            let parts = breakdown(&largest, &u.force);
            page.line(format!("the largest of the pull: {parts}"));
        }
    }

    /// One row per value along the curves, one column per curve.
    fn table(&self, u: &Units) -> Table<'_, CurvePoint> {
        let first = self.curves.first().map_or(&[][..], |c| &c.points[..]);
        let table = Table::of(first);
        let mut table = match self.test {
            Test::Isobaric => table.quantity("ε", &PERCENT, |q| q.contraction),
            _ => table.quantity("P", &u.pressure, |q| q.pressure_mpa),
        };
        for (i, curve) in self.curves.iter().enumerate() {
            let fixed = match self.test {
                Test::Isometric => {
                    format!("{} at ε {}", u.force.heading("F"), percent(curve.fixed))
                }
                Test::Isotonic => format!("ε at {}", u.force.show(curve.fixed)),
                Test::Isobaric => {
                    let pressure = u.pressure.show(curve.fixed);
                    format!("{} at {pressure}", u.force.heading("F"))
                }
            };
            let heading = if self.both {
                format!("{fixed}, {}", Direction::BRANCHES[i % 2].motion())
            } else {
                fixed
            };
            table = table.column(heading, cells(self.test, curve, u));
        }
        table
    }
}

/// The quantity that a test computes and its ±, as they are shown: a contraction in per cent, or
/// the pull of a muscle that is not slack.
fn computed(test: Test, a: &Answer, u: &Units) -> Option<(f64, Option<f64>)> {
    let (scale, value, half) = match test {
        Test::Isotonic => (&PERCENT, a.response.contraction, a.contraction_uncertainty),
        _ => (&u.force, a.response.force_n, a.uncertainty_n),
    };
    (test == Test::Isotonic || !a.slack)
        .then(|| (scale.value(value), half.map(|half| scale.value(half))))
}

/// A curve's answers, to the digits that the least ± of them leaves.
fn cells(test: Test, curve: &Curve, u: &Units) -> Vec<String> {
    let values: Vec<_> = curve
        .points
        .iter()
        .map(|q| computed(test, q.answer.as_ref().ok()?, u))
        .collect();
    let least = values.iter().filter_map(|v| (*v)?.1).reduce(f64::min);
    let numbers: Vec<Option<f64>> = values.iter().map(|v| v.map(|v| v.0)).collect();
    let cells = match least {
        Some(least) => numbers
            .iter()
            .map(|v| v.map_or_else(|| "–".into(), |v| within(v, least)))
            .collect(),
        None => aligned(&numbers, 4),
    };
    cells
        .into_iter()
        .zip(&curve.points)
        .map(|(cell, q)| match &q.answer {
            Ok(_) if test == Test::Isotonic => cell + " %",
            Ok(a) if a.slack => "slack".into(),
            _ => cell,
        })
        .collect()
}

impl Show for StudyAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = Page::default();
        let [diameter, length] = [30.0, 285.0].map(|mm| u.length.show(mm));
        let model = &self.model;
        page.line(format!(
            "Thickness study, model {model}: D0 {diameter}, L0 {length}"
        ));
        for test in [Test::Isometric, Test::Isotonic] {
            let panels: Vec<&StudyPanel> = self.panels.iter().filter(|q| q.test == test).collect();
            let table = Table::of(&panels);
            let (mut table, title) = match test {
                Test::Isometric => (
                    table.quantity("ΔL", &u.length.digits(4), |panel| panel.fixed),
                    u.force.heading("Pull F"),
                ),
                _ => (
                    table.quantity("F", &u.force.digits(4), |panel| panel.fixed),
                    "Contraction ε".into(),
                ),
            };
            let at = u.pressure.show(0.25);
            page.paragraph(format!("{title} at {at}, {} tests", test.name()));
            let curves = panels.first().map_or(&[][..], |panel| &panel.curves[..]);
            for (i, curve) in curves.iter().enumerate() {
                let last = |panel: &&StudyPanel| {
                    let last = panel.curves.get(i)?.curve.points.last()?;
                    Some(last.answer.as_ref().ok()?.response)
                };
                table = match test {
                    Test::Isometric => {
                        let pulls = panels.iter().map(|panel| Some(last(panel)?.force_n));
                        table.column(curve.label.clone(), u.force.column(pulls, 4))
                    }
                    _ => table.quantity(&curve.label, &PERCENT, |panel| {
                        last(panel).map(|r| r.contraction)
                    }),
                };
            }
            page.table(table);
        }
        page.paragraph("The paper's findings and the results here");
        for f in &self.findings {
            let verdict = if f.holds { "holds" } else { "does not hold" };
            page.line(format!("  {verdict:<14} {}", u.sentence(f.statement)));
            page.line(format!("{:17}{}", "", u.sentence(&f.ours)));
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(study_rows(&self.panels))
    }
}
