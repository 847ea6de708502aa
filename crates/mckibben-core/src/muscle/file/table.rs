//! The measures in a table of a muscle file, beside the keys of its struct.

use super::{error::FileError, source::Source};
use crate::muscle::{
    Measure,
    measures::{END_FACTOR, MeasureValues, SECTIONS, STIFFNESS, of_section},
};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde_json::{Map, Value};
use std::borrow::Cow;

/// What is written in a table, by its number in [`SECTIONS`], beside the keys of its struct.
#[derive(Debug, Default, Deserialize)]
#[serde(transparent)]
pub struct Measured<const TABLE: usize>(Map<String, Value>);

impl<const TABLE: usize> Measured<TABLE> {
    /// Its measures; what is more than a number there has its field in the struct of the table.
    fn all() -> impl Iterator<Item = &'static Measure> {
        of_section(SECTIONS[TABLE]).filter(|m| ![&END_FACTOR, &STIFFNESS].contains(m))
    }

    /// Puts the values in.
    ///
    /// # Errors
    /// [`FileError`] of the first key that is no measure, or has no value of one.
    pub fn read(&self, source: &Source<'_>, values: &mut MeasureValues) -> Result<(), FileError> {
        for (name, value) in &self.0 {
            let measure = Self::all()
                .find(|m| m.name() == name)
                .ok_or_else(|| source.unknown(SECTIONS[TABLE], name))?;
            let value = measure
                .read(value)
                .map_err(|e| source.error(measure.key, e.to_string()))?;
            measure.check(value).map_err(|e| source.refused(&e))?;
            values.set(measure, value);
        }
        Ok(())
    }
}

impl<const TABLE: usize> JsonSchema for Measured<TABLE> {
    fn schema_name() -> Cow<'static, str> {
        SECTIONS[TABLE].into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let measures = Self::all().map(|m| (m.name().to_owned(), m.file_schema()));
        json_schema!({
            "type": "object",
            "additionalProperties": false,
            "properties": measures.collect::<Map<_, _>>(),
        })
    }
}
