//! An answer as a table for other programs: the columns are those of the rows' schema, so that they
//! are the same whatever the values.

use super::schema;
use mckibben_core::warning::Warning;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::{Error, Value, to_value};

/// Rows as objects, and the schema of their type.
#[must_use]
#[derive(Debug)]
pub struct Csv {
    /// An object for each row.
    pub rows: Result<Vec<Value>, Error>,
    /// The JSON Schema of a row: its keys are the columns.
    pub schema: fn() -> Value,
    /// Columns by key or by position in a list.
    pub form: CsvLayout,
    /// Warnings that the page has among its lines.
    pub warnings: Vec<Warning>,
}

/// How the lines follow from the rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CsvLayout {
    /// One line for each row.
    Rows,
    /// The values of objects in a row are columns as well.
    Flat,
    /// A row has lists of equal length.
    Columns,
}

impl Csv {
    /// A line for each of a list.
    pub fn rows<T: Serialize + JsonSchema>(list: impl IntoIterator<Item = T>) -> Self {
        Self {
            rows: list.into_iter().map(to_value).collect(),
            schema: schema::of::<T>,
            form: CsvLayout::Rows,
            warnings: vec![],
        }
    }

    /// One line.
    pub fn row<T: Serialize + JsonSchema>(row: &T) -> Self {
        Self::rows([row])
    }

    /// One line, with the values of its objects beside the others.
    pub fn flat<T: Serialize + JsonSchema>(row: &T) -> Self {
        Self {
            form: CsvLayout::Flat,
            ..Self::row(row)
        }
    }

    /// A line for each place of an object of lists.
    pub fn columns<T: Serialize + JsonSchema>(lists: &T) -> Self {
        Self {
            form: CsvLayout::Columns,
            ..Self::row(lists)
        }
    }

    /// With warnings that the page has among its lines.
    pub fn with_warnings(mut self, list: &[Warning]) -> Self {
        self.warnings.extend_from_slice(list);
        self
    }
}
