//! Tables with one line for each item of a list.

use super::amount::Amount;
use crate::{Scale, units::NUMBER, words::aligned};

/// A heading and the cells below it.
#[derive(Debug)]
pub struct Column {
    /// Quantity and unit.
    pub heading: String,
    /// From the first row to the last.
    pub cells: Vec<String>,
}

impl Column {
    /// A column of cells; what there is not is a dash, and without any there is no column.
    fn new(label: &str, scale: &Scale, cells: Vec<Option<String>>) -> Option<Self> {
        cells
            .iter()
            .flatten()
            .any(|cell| !cell.is_empty())
            .then(|| Self {
                heading: heading(label, scale),
                cells: cells
                    .into_iter()
                    .map(|cell| cell.unwrap_or("–".into()))
                    .collect(),
            })
    }

    /// A column of amounts of one unit, with their points aligned unless their sizes are unlike.
    pub fn of(label: &str, scale: &Scale, amounts: &[Amount]) -> Option<Self> {
        let sizes = || {
            amounts
                .iter()
                .filter_map(Amount::number)
                .map(f64::abs)
                .filter(|v| *v > 0.0)
        };
        let (low, high) = sizes().fold((f64::INFINITY, 0.0), |(a, b), v| (v.min(a), v.max(b)));
        let cells = if high > UNLIKE * low {
            amounts
                .iter()
                .map(|amount| unaligned_cell(amount, scale))
                .collect()
        } else {
            aligned_cells(amounts, scale)
        };
        Self::new(label, scale, cells)
    }
}

/// The ratio of numbers of unlike sizes.
const UNLIKE: f64 = 100.0;

/// A table with a line for each of a list.
#[must_use]
#[derive(Debug)]
pub struct Table<'a, T> {
    list: &'a [T],
    /// From left to right.
    pub columns: Vec<Column>,
}

impl<'a, T> Table<'a, T> {
    /// A table of a list, without columns yet.
    pub fn of(list: &'a [T]) -> Self {
        Self {
            list,
            columns: vec![],
        }
    }

    /// Whether it has nothing to show.
    pub fn is_empty(&self) -> bool {
        self.columns.is_empty()
    }

    /// A column of quantities of one unit, with their points aligned.
    pub fn quantity<A: Into<Amount>>(
        self,
        label: &str,
        scale: &Scale,
        amount: impl Fn(&'a T) -> A,
    ) -> Self {
        let amounts = self.amounts(&|of| amount(of).into());
        self.with(Column::new(label, scale, aligned_cells(&amounts, scale)))
    }

    /// A column of quantities of one unit and of unlike sizes: each has its own decimals.
    pub fn unaligned<A: Into<Amount>>(
        self,
        label: &str,
        scale: &Scale,
        amount: impl Fn(&'a T) -> A,
    ) -> Self {
        let cells = self
            .amounts(&|of| amount(of).into())
            .iter()
            .map(|amount| unaligned_cell(amount, scale))
            .collect();
        self.with(Column::new(label, scale, cells))
    }

    // By reference: compiled once for each kind of row, not for each column.
    fn amounts(&self, amount: &dyn Fn(&'a T) -> Amount) -> Vec<Amount> {
        self.list.iter().map(amount).collect()
    }

    /// A column of words, or of numbers without a unit.
    pub fn text<A: Into<Amount>>(self, heading: &str, text: impl Fn(&'a T) -> A) -> Self {
        self.quantity(heading, &NUMBER, text)
    }

    /// With a column, where there is one.
    pub fn with(mut self, column: Option<Column>) -> Self {
        self.columns.extend(column);
        self
    }
}

/// The unit is in the heading; per cent stand behind the numbers.
fn heading(label: &str, scale: &Scale) -> String {
    match &*scale.name {
        "%" | "" => label.into(),
        _ => scale.heading(label),
    }
}

/// Cells of numbers with their points aligned; what has a ± or words is as it is alone.
fn aligned_cells(amounts: &[Amount], scale: &Scale) -> Vec<Option<String>> {
    let numbers = Vec::from_iter(
        amounts
            .iter()
            .map(|amount| amount.number().map(|v| scale.rounded(v))),
    );
    amounts
        .iter()
        .zip(aligned(&numbers, scale.digits))
        .map(|(amount, aligned)| match amount {
            Amount::Number(_) => Some(with_percent(aligned, amount, scale)),
            _ => unaligned_cell(amount, scale),
        })
        .collect()
}

fn unaligned_cell(amount: &Amount, scale: &Scale) -> Option<String> {
    Some(with_percent(amount.bare(scale)?, amount, scale))
}

fn with_percent(cell: String, amount: &Amount, scale: &Scale) -> String {
    let is_number = !matches!(amount, Amount::Words(_));
    if is_number && scale.name == "%" {
        cell + " %"
    } else {
        cell
    }
}
