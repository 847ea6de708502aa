//! An answer as a table for other programs: the columns are those of the rows' schema, so that they
//! are the same whatever the values.

use schemars::{JsonSchema, Schema, SchemaGenerator, generate::SchemaSettings};
use serde::Serialize;
use serde_json::{Error, Value, to_value};

/// Rows as objects, and the schema of their type.
#[derive(Debug)]
pub struct Csv {
    pub rows: Result<Vec<Value>, Error>,
    schema: fn(SchemaGenerator) -> Schema,
    /// Whether the values of objects in a row are columns as well.
    pub is_flat: bool,
}

impl Csv {
    /// A line for each of a list.
    pub fn rows<T: Serialize + JsonSchema>(list: impl IntoIterator<Item = T>) -> Self {
        Self {
            rows: list.into_iter().map(to_value).collect(),
            schema: SchemaGenerator::into_root_schema_for::<T>,
            is_flat: false,
        }
    }

    /// One line.
    pub fn row<T: Serialize + JsonSchema>(row: &T) -> Self {
        Self::rows([row])
    }

    /// One line, with the values of its objects beside the others.
    pub fn flat<T: Serialize + JsonSchema>(row: &T) -> Self {
        Self {
            is_flat: true,
            ..Self::row(row)
        }
    }

    pub fn schema(&self) -> Value {
        let settings = SchemaSettings::draft2020_12().for_serialize();
        (self.schema)(settings.into_generator()).to_value()
    }
}
