//! Identified constants as people read them.

use super::{IdentifiedPoint, IdentifyAnswer, with_error_bar};
use crate::{
    UnderstoodTable, Units,
    print::{Csv, Page, Show, Table},
    units::NUMBER,
};
use mckibben_core::muscle::measures::TAKE_UP;
use mckibben_fit::identify::{Identification, Identified};
use std::borrow::Cow;

/// Fields that stand otherwise on the page, or in files.
const APART: [&str; 6] = [
    "understood",
    "deviation",
    "parameters",
    "correlation",
    "muscle_file",
    "points",
];

impl Show for IdentifyAnswer {
    fn page(&self, u: &Units) -> Page {
        let mut page = UnderstoodTable::lines(&self.understood);
        page.gap();
        let parameters = &self.identified.parameters;
        let shown: Vec<Identified> = parameters.iter().map(|p| in_units(p, u)).collect();
        page.table(constants(&shown));
        correlation(&self.identified, &mut page);
        page.gap();
        page.and(Page::of(self, u, &APART));
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
