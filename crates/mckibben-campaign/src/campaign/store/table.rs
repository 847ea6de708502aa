//! Rows as columns in memory.

use super::layout::{Field, Layout};
use crate::Row;
use crate::columns::Slot;
use parquet::data_type::ByteArray;
use std::sync::Arc;

/// A column, of the kind that Parquet knows.
#[derive(Debug, Clone)]
pub(crate) enum Column {
    Int64(Vec<i64>),
    Int32(Vec<i32>),
    Double(Vec<f64>),
    Optional(Vec<Option<f64>>),
    Text(Vec<ByteArray>),
}

impl Column {
    /// An empty column for what a field holds.
    pub(crate) fn new(field: &Field) -> Self {
        match field.slot(&mut Row::default()) {
            Slot::Whole(_) => Self::Int64(vec![]),
            Slot::Count(_) => Self::Int32(vec![]),
            Slot::Number(_) | Slot::Constants(_) | Slot::Measures(_) => Self::Double(vec![]),
            Slot::Optional(_) | Slot::Sensitivities(_) => Self::Optional(vec![]),
            Slot::Text(_) | Slot::Status(_) => Self::Text(vec![]),
        }
    }

    /// Its type in a schema of Parquet, before and behind its name.
    pub(super) fn schema(&self) -> (&'static str, &'static str) {
        match self {
            Self::Int64(_) => ("REQUIRED INT64", ""),
            Self::Int32(_) => ("REQUIRED INT32", ""),
            Self::Double(_) => ("REQUIRED DOUBLE", ""),
            Self::Optional(_) => ("OPTIONAL DOUBLE", ""),
            Self::Text(_) => ("REQUIRED BYTE_ARRAY", " (UTF8)"),
        }
    }

    fn extend(&mut self, other: &Column, from: usize, to: usize) {
        match (self, other) {
            (Self::Int64(a), Self::Int64(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Int32(a), Self::Int32(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Double(a), Self::Double(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Optional(a), Self::Optional(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Text(a), Self::Text(b)) => a.extend_from_slice(&b[from..to]),
            _ => {}
        }
    }

    /// Adds what a row has in a field.
    fn push(&mut self, field: &Field, row: &mut Row) {
        match (self, field.slot(row)) {
            (Self::Int64(c), Slot::Whole(v)) => c.push(*v as i64),
            (Self::Int32(c), Slot::Count(v)) => c.push(i32::try_from(*v).unwrap_or(i32::MAX)),
            (Self::Double(c), Slot::Number(v)) => c.push(*v),
            (Self::Double(c), Slot::Constants(list) | Slot::Measures(list)) => {
                c.push(field.of(list).unwrap_or(0.0))
            }
            (Self::Optional(c), Slot::Optional(v)) => c.push(*v),
            (Self::Optional(c), Slot::Sensitivities(list)) => c.push(field.of(list)),
            (Self::Text(c), Slot::Text(v)) => c.push(ByteArray::from(v.as_str())),
            (Self::Text(c), Slot::Status(v)) => c.push(ByteArray::from(v.to_string().as_str())),
            _ => {}
        }
    }

    /// Puts line `i` into a row; what is wrong with it otherwise.
    fn fill(&self, i: usize, field: &Field, row: &mut Row) -> Option<Result<(), String>> {
        let text = |c: &[ByteArray]| Some(c.get(i)?.as_utf8().unwrap_or("").to_owned());
        match (self, field.slot(row)) {
            (Self::Int64(c), Slot::Whole(v)) => *v = *c.get(i)? as u64,
            (Self::Int32(c), Slot::Count(v)) => *v = u32::try_from(*c.get(i)?).unwrap_or(0),
            (Self::Double(c), Slot::Number(v)) => *v = *c.get(i)?,
            (Self::Double(c), Slot::Constants(list) | Slot::Measures(list)) => {
                list.push((field.key().to_owned(), *c.get(i)?));
            }
            (Self::Optional(c), Slot::Optional(v)) => *v = *c.get(i)?,
            (Self::Optional(c), Slot::Sensitivities(list)) => {
                list.extend(c.get(i)?.map(|v| (field.key().to_owned(), v)));
            }
            (Self::Text(c), Slot::Text(v)) => *v = text(c)?,
            (Self::Text(c), Slot::Status(v)) => match text(c)?.parse() {
                Ok(status) => *v = status,
                Err(error) => return Some(Err(format!("{}: {error}", field.name))),
            },
            _ => return None,
        }
        Some(Ok(()))
    }
}

/// Some rows of a campaign.
#[derive(Debug, Clone)]
pub(crate) struct Table {
    fields: Arc<[Field]>,
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: usize,
}

impl Table {
    pub(crate) fn new(layout: &Layout) -> Self {
        let fields: Arc<[Field]> = layout.fields().into();
        Self { columns: fields.iter().map(Column::new).collect(), fields, rows: 0 }
    }

    pub(super) fn of(fields: &Arc<[Field]>, columns: Vec<Column>, rows: usize) -> Self {
        Self { fields: fields.clone(), columns, rows }
    }

    /// Adds a row.
    pub(crate) fn push(&mut self, mut row: Row) {
        for (column, field) in self.columns.iter_mut().zip(self.fields.iter()) {
            column.push(field, &mut row);
        }
        self.rows += 1;
    }

    /// Adds rows `from..to` of another table of the same layout.
    pub(crate) fn extend(&mut self, other: &Table, from: usize, to: usize) {
        for (column, more) in self.columns.iter_mut().zip(&other.columns) {
            column.extend(more, from, to);
        }
        self.rows += to - from;
    }

    /// Row `i`, or what is wrong with it.
    pub(crate) fn row(&self, i: usize) -> Result<Row, String> {
        let mut row = Row::default();
        for (column, field) in self.columns.iter().zip(self.fields.iter()) {
            column.fill(i, field, &mut row).unwrap_or_else(|| Err(format!("{}: no value", field.name)))?;
        }
        Ok(row)
    }
}
