//! Identified constants as people read them.

use super::{IdentifiedPoint, IdentifyAnswer, with_error_bar};
use crate::{
    UnderstoodTable, Units, percent,
    print::{Csv, Page, Rows, Show, Table},
    units::NUMBER,
};
use mckibben_core::{
    extremes::peak,
    muscle::{Bench, measures::TAKE_UP},
};
use mckibben_fit::identify::{Identification, Identified};
use std::borrow::Cow;

impl Show for IdentifyAnswer {
    fn page(&self, u: &Units) -> Page {
        let model = &self.model;
        let data = &self.data;
        let points = self.points.len();
        let mut page = Page::default();
        page.lines(self.understood.iter().map(UnderstoodTable::line));
        page.line(format!("model {model}, {points} points of {data}"));
        page.line(self.muscle.line(u));
        page.gap();
        let parameters: Vec<Identified> = self
            .identified
            .parameters
            .iter()
            .map(|p| in_units(p, u))
            .collect();
        page.table(constants(&parameters));
        correlation(&self.identified, &mut page);
        page.gap();
        page.rows(self.residuals(u));
        let force = u.force.digits(3);
        page.table(
            Table::of(&self.identified.spreads)
                .text("", |s| &s.label)
                .text("points", |s| s.points)
                .quantity("rms", &force, |s| s.rms_n)
                .quantity("largest", &force, |s| s.max_n)
                .quantity("mean", &force, |s| s.mean_n),
        );
        if !self.warnings.is_empty() {
            page.gap();
        }
        page.lines(self.warnings.iter().map(|note| format!("- {note}")));
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(self.points.iter().map(IdentifiedPoint::from))
    }
}

impl IdentifyAnswer {
    fn residuals(&self, u: &Units) -> Rows {
        let identified = &self.identified;
        let force = u.force.digits(3);
        let largest_n = peak(self.points.iter().map(|p| p.point.at.force_n));
        let bench = identified
            .bench
            .as_ref()
            .filter(|_| self.muscle_file.contains("\n[identified]"));
        Rows::default()
            .quantity("rms of the residuals", &force, identified.rms_n)
            .quantity("at the start", &force, identified.rms_before_n)
            .quantity("largest", &force, identified.max_n)
            .quantity(
                "largest force",
                &u.force,
                Some(largest_n).filter(|n| *n > 0.0),
            )
            .text("this bench", bench.map(|bench| bench_text(bench, u)))
    }
}

/// A pressure of the muscle in units; the moduli of rubbers are in MPa.
fn in_units(p: &Identified, u: &Units) -> Identified {
    let Cow::Borrowed(unit) = u.pressure.name else {
        return p.clone();
    };
    if p.name != TAKE_UP.key {
        return p.clone();
    }
    Identified {
        value: u.pressure.value(p.value),
        standard_error: u.pressure.value(p.standard_error),
        half_width: u.pressure.value(p.half_width),
        unit,
        ..p.clone()
    }
}

/// Identified constants, each with its ±.
pub fn constants(parameters: &[Identified]) -> Table<'_, Identified> {
    Table::of(parameters)
        .text("", |p| &p.name)
        .text("value", |p| with_error_bar(p).0)
        .text("± 95 %", |p| with_error_bar(p).1)
        .unaligned("std. error", &NUMBER.digits(2), |p| p.standard_error)
        .text("unit", |p| p.unit)
        .unaligned("start", &NUMBER, |p| p.start)
        .text("told by", |p| match p {
            p if p.at_bound => "nothing: on its bound",
            p if p.identifiable => "these points",
            p if p.prior_standard_deviation.is_some() => "measured muscles",
            p if !p.matters => "nothing: no effect",
            _ => "nothing",
        })
}

/// The lower triangle of the correlations, where there are any.
fn correlation(identified: &Identification, page: &mut Page) {
    let parameters = &identified.parameters;
    let rows: Vec<usize> = (1..parameters.len()).collect();
    if rows.is_empty() {
        return;
    }
    let mut table = Table::of(&rows).text("correlation", |&i| &parameters[i].name);
    for (j, column) in parameters.iter().enumerate().take(rows.len()) {
        table = table.text(&column.name, |&i| {
            if j < i {
                format!("{:.2}", identified.correlation[i][j])
            } else {
                String::new()
            }
        });
    }
    page.gap();
    page.table(table);
}

/// Where a bench was.
fn bench_text(bench: &Bench, u: &Units) -> String {
    let [(p, q), (e, f)] = [bench.pressure_mpa, bench.contraction];
    let [p, q] = [p, q].map(|v| u.pressure.show(v));
    let e = percent(e);
    let f = percent(f);
    let points = bench.points;
    format!("{points} points, {p} to {q}, contractions {e} to {f}")
}
