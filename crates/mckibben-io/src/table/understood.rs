//! What was understood of a table, for people to check.

use super::{error::short, find::Table, heading::Column, number::Decimal};
use mckibben_units::{joined, tidy};
use serde::Serialize;

/// What was understood of a table.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Understood {
    /// Rows that were read.
    pub rows: usize,
    /// Rows that were left out because their `status` is not ok.
    pub left_out: usize,
    /// Rows that were left out because what was measured is blank.
    #[serde(skip_serializing_if = "is_zero")]
    pub not_filled: usize,
    /// The line of the heading, from 1; null where columns were chosen by number.
    pub heading_line: Option<u64>,
    /// What is between fields: comma, semicolon, tab, bar or spaces.
    pub separator: String,
    /// The decimal mark: point or comma.
    pub decimal: String,
    /// Columns that were used.
    pub columns: Vec<UnderstoodColumn>,
    /// Headings of those that were not.
    pub not_used: Vec<String>,
}

/// What was understood of a column.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct UnderstoodColumn {
    /// Its heading as written.
    pub column: String,
    /// What it means.
    pub quantity: String,
    /// Its unit; empty for ratios, words and weights.
    pub unit: String,
    /// From its smallest to its largest value, in MPa, N, mm, deg or as ratio: `0.1..0.3MPa`.
    pub range: Option<String>,
    /// What was done with it, where that is not plain.
    pub note: Option<String>,
}

/// Strains and contractions that all are smaller are likely ratios under a heading of percent.
const SMALL: f64 = 0.01;

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde hands over references"
)]
fn is_zero(count: &usize) -> bool {
    *count == 0
}

impl Understood {
    /// One line for people: `45 points; P1 → pressure (kPa), x → shortening (mm, over L0 200 mm)`.
    pub fn line(&self) -> String {
        let column = |c: &UnderstoodColumn| {
            let about = match (c.unit.as_str(), c.note.as_deref()) {
                ("", None | Some("")) => String::new(),
                (about, None | Some("")) | ("", Some(about)) => format!(" ({about})"),
                (unit, Some(note)) => format!(" ({unit}, {note})"),
            };
            format!("{} → {}{about}", c.column, c.quantity)
        };
        let mut out = format!(
            "{} points; {}",
            self.rows,
            joined(self.columns.iter().map(column), ", ")
        );
        if let Some(line) = self.heading_line.filter(|line| *line > 1) {
            out += &format!("; heading in line {line}");
        }
        if self.left_out > 0 {
            out += &format!("; {} left out by their status", self.left_out);
        }
        if self.not_filled > 0 {
            out += &format!("; {} not filled in and left out", self.not_filled);
        }
        if !self.not_used.is_empty() {
            out += &format!("; not used: {}", self.not_used.join(", "));
        }
        out
    }
}

impl Table {
    /// What was understood, with the columns that were used, in the order of the table.
    pub fn understood(&self, used: &[(&Column, Option<String>)]) -> Understood {
        let mut used: Vec<_> = used.iter().collect();
        used.sort_by_key(|u| u.0.index);
        let columns = used.iter().map(|(column, note)| {
            let words = column.meaning.words();
            let values = self.some_numbers(column.meaning).unwrap_or_default();
            let end = |of: fn(f64, f64) -> f64| values.iter().copied().flatten().reduce(of);
            let range = words.dimension.and_then(|dimension| {
                let low = tidy(end(f64::min)?, 7);
                let high = tidy(end(f64::max)?, 7);
                Some(format!("{low}..{high}{}", dimension.unit_inside().name))
            });
            UnderstoodColumn {
                column: column.heading.clone(),
                quantity: words.name.clone(),
                unit: column.unit.map_or("", |u| u.name).to_owned(),
                range,
                note: self.noted(column, note.as_deref()),
            }
        });
        let is_used = |i: usize| used.iter().any(|u| u.0.index == i);
        let others = self
            .headings
            .iter()
            .enumerate()
            .filter(|(i, h)| !is_used(*i) && !h.is_empty());
        Understood {
            rows: self.rows.len(),
            left_out: self.left_out,
            not_filled: self.not_filled,
            heading_line: self.heading_line,
            separator: self.separator.name().into(),
            decimal: if self.decimal == Decimal::Comma {
                "comma"
            } else {
                "point"
            }
            .into(),
            columns: columns.collect(),
            not_used: others.map(|(_, h)| short(h)).collect(),
        }
    }

    /// What was done with a column, or is odd of it.
    fn noted(&self, column: &Column, note: Option<&str>) -> Option<String> {
        let percent = column.unit.is_some_and(|unit| unit.name == "%");
        let mut values = self
            .some_numbers(column.meaning)
            .unwrap_or_default()
            .into_iter()
            .flatten()
            .map(f64::abs);
        let small = percent && values.clone().any(|v| v > 0.0) && values.all(|v| v < SMALL);
        let notes = [
            note,
            column.negated.then_some("with the opposite sign"),
            small.then_some("all below 1 %: if they are ratios, take % out of the heading"),
        ];
        let notes = joined(notes.into_iter().flatten(), ", ");
        (!notes.is_empty()).then_some(notes)
    }
}
