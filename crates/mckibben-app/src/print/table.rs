//! Tables of equal things.

use super::amount::Amount;
use crate::{Scale, units::NUMBER, words::aligned};

/// A heading and the cells below it.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    pub heading: String,
    pub cells: Vec<String>,
}

/// A table with a line for each of a list.
#[derive(Debug)]
pub struct Table<'a, T> {
    list: &'a [T],
    pub(super) columns: Vec<Column>,
}

impl<'a, T> Table<'a, T> {
    pub fn of(list: &'a [T]) -> Self {
        Self {
            list,
            columns: vec![],
        }
    }

    /// A column of quantities of one unit, with their points aligned.
    pub fn quantity<A: Into<Amount>>(
        self,
        label: &str,
        scale: &Scale,
        amount: impl Fn(&'a T) -> A,
    ) -> Self {
        let amounts: Vec<Amount> = self.list.iter().map(|of| amount(of).into()).collect();
        let is_percent = scale.name == "%";
        let heading = if is_percent || scale.name.is_empty() {
            label.into()
        } else {
            scale.heading(label)
        };
        let numbers = amounts.iter().map(|amount| match amount {
            Amount::Number(v) | Amount::Within(v, _) => Some(scale.rounded(*v)),
            _ => None,
        });
        let numbers: Vec<Option<f64>> = numbers.collect();
        let cells = amounts.iter().zip(aligned(&numbers, scale.digits));
        let cells = cells.map(|(amount, aligned)| {
            let text = match amount {
                Amount::Number(_) => aligned,
                amount => amount.bare(scale)?,
            };
            let is_number = !matches!(amount, Amount::Words(_));
            Some(text + if is_number && is_percent { " %" } else { "" })
        });
        self.cells(heading, cells.collect())
    }

    /// A column of words, or of numbers without a unit.
    pub fn text<A: Into<Amount>>(self, heading: &str, text: impl Fn(&'a T) -> A) -> Self {
        self.quantity(heading, &NUMBER, text)
    }

    /// A column of cells; what there is not is a dash.
    fn cells(self, heading: String, cells: Vec<Option<String>>) -> Self {
        if cells.iter().flatten().all(String::is_empty) {
            return self;
        }
        let cells = cells.into_iter().map(|cell| cell.unwrap_or("–".into()));
        self.column(heading, cells.collect())
    }

    /// A column of cells as they are.
    pub fn column(mut self, heading: String, cells: Vec<String>) -> Self {
        self.columns.push(Column { heading, cells });
        self
    }
}
