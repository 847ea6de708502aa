//! Rows as columns in memory.

use super::layout::Field;
use crate::columns::{PointRow, Slot};
use mckibben_core::units::named;
use mckibben_io::parquet::{Column, Text};
use std::sync::Arc;

/// Adds the value of a row in a field.
fn push(column: &mut Column, field: &Field, row: &mut PointRow) {
    match (column, field.slot(row)) {
        (Column::Int64(c), Slot::Whole(v)) => c.push(*v as i64),
        (Column::Int32(c), Slot::Count(v)) => c.push(i32::try_from(*v).unwrap_or(i32::MAX)),
        (Column::Double(c), Slot::Number(v)) => c.push(*v),
        (Column::Double(c), Slot::Measures(list)) => {
            c.push(field.value_in(list).unwrap_or(0.0));
        }
        (Column::Optional(c), Slot::Optional(v)) => c.push(*v),
        (Column::Optional(c), Slot::Constants(list) | Slot::Sensitivities(list)) => {
            c.push(field.value_in(list));
        }
        (Column::Flag(c), Slot::Flag(v)) => c.push(*v),
        (Column::Text(c), Slot::Text(v)) => c.push(Text::from(v.as_str())),
        (Column::Text(c), Slot::Status(v)) => c.push(Text::from(v.to_string().as_str())),
        _ => {}
    }
}

/// Puts line `i` into a row, or the error in it.
fn fill(
    column: &Column,
    i: usize,
    field: &Field,
    row: &mut PointRow,
) -> Option<Result<(), String>> {
    let text = |c: &[Text]| Some(c.get(i)?.as_utf8().unwrap_or("").to_owned());
    match (column, field.slot(row)) {
        (Column::Int64(c), Slot::Whole(v)) => *v = *c.get(i)? as u64,
        (Column::Int32(c), Slot::Count(v)) => *v = u32::try_from(*c.get(i)?).unwrap_or(0),
        (Column::Double(c), Slot::Number(v)) => *v = *c.get(i)?,
        (Column::Double(c), Slot::Measures(list)) => {
            list.push((field.key.clone(), *c.get(i)?));
        }
        (Column::Optional(c), Slot::Optional(v)) => *v = *c.get(i)?,
        (Column::Optional(c), Slot::Constants(list) | Slot::Sensitivities(list)) => {
            list.extend(c.get(i)?.map(|v| (field.key.clone(), v)));
        }
        (Column::Flag(c), Slot::Flag(v)) => *v = *c.get(i)?,
        (Column::Text(c), Slot::Text(v)) => *v = text(c)?,
        (Column::Text(c), Slot::Status(v)) => match named(&text(c)?) {
            Some(status) => *v = status,
            None => return Some(Err(format!("{}: an unknown word", field.name))),
        },
        _ => return None,
    }
    Some(Ok(()))
}

/// Some rows of a campaign.
pub struct Table {
    pub(super) fields: Arc<[Field]>,
    pub columns: Vec<Column>,
    pub rows: usize,
}

impl Table {
    pub fn new(fields: Arc<[Field]>) -> Self {
        Self {
            columns: fields.iter().map(Field::kind).collect(),
            fields,
            rows: 0,
        }
    }

    pub fn push(&mut self, mut row: PointRow) {
        for (column, field) in self.columns.iter_mut().zip(self.fields.iter()) {
            push(column, field, &mut row);
        }
        self.rows += 1;
    }

    /// Adds rows `from..to` of another table of the same layout.
    pub fn extend(&mut self, other: &Table, from: usize, to: usize) {
        for (column, more) in self.columns.iter_mut().zip(&other.columns) {
            column.extend(more, from, to);
        }
        self.rows += to - from;
    }

    /// Row `i`, or the error in it.
    pub fn row(&self, i: usize) -> Result<PointRow, String> {
        let mut row = PointRow::default();
        for (column, field) in self.columns.iter().zip(self.fields.iter()) {
            fill(column, i, field, &mut row)
                .unwrap_or_else(|| Err(format!("{}: no value", field.name)))?;
        }
        Ok(row)
    }
}
