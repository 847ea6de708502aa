//! Values of measures as fields of requests.

use super::{MEASURES, Measure, fields};
use crate::units::parse_quantity;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Map, Value, json};
use std::{borrow::Cow, collections::BTreeMap};

/// Values of measures, in the order of their table.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(try_from = "Map<String, Value>")]
pub struct MeasureValues(BTreeMap<usize, f64>);

impl MeasureValues {
    /// The value of a measure.
    pub fn get(&self, measure: &Measure) -> Option<f64> {
        self.0.get(&measure.place()).copied()
    }

    /// Puts a value in.
    pub fn set(&mut self, measure: &Measure, value: f64) {
        self.0.insert(measure.place(), value);
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = (&'static Measure, f64)> {
        self.0
            .iter()
            .map(|(place, value)| (MEASURES[*place], *value))
    }
}

impl<const N: usize> From<[(&'static Measure, f64); N]> for MeasureValues {
    fn from(values: [(&'static Measure, f64); N]) -> Self {
        let mut out = Self::default();
        values
            .into_iter()
            .for_each(|(measure, value)| out.set(measure, value));
        out
    }
}

impl Serialize for MeasureValues {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(
            self.iter()
                .filter_map(|(measure, value)| Some((measure.field?, value))),
        )
    }
}

impl TryFrom<Map<String, Value>> for MeasureValues {
    type Error = serde_json::Error;

    /// Reads fields; those of no measure are ignored.
    fn try_from(given: Map<String, Value>) -> Result<Self, serde_json::Error> {
        let mut out = Self::default();
        for (field, measure) in fields() {
            let value = match given.get(field) {
                Some(Value::String(text)) if !measure.is_plain() => Some(
                    parse_quantity(text, measure.dimension).map_err(serde::de::Error::custom)?,
                ),
                Some(value) => Option::<f64>::deserialize(value)?,
                None => None,
            };
            out.0.extend(value.map(|value| (measure.place(), value)));
        }
        Ok(out)
    }
}

impl Measure {
    /// Its place in the table.
    fn place(&self) -> usize {
        MEASURES.iter().take_while(|m| **m != self).count()
    }

    /// The schema of its field; `more` is added to the sentence about it.
    pub fn schema(&self, more: &str) -> Value {
        let mut field = json!({
            "description": self.documentation(more), "type": ["number", "null"], "format": "double",
            "x-key": self.key,
        });
        if !self.symbol.is_empty() {
            field["x-symbol"] = self.symbol.into();
        }
        if !self.is_plain() {
            field["x-quantity"] = json!(self.dimension);
            field["x-unit"] = self.unit().into();
        }
        field
    }

    /// The same in a request, with the values that it may have (`x-above`, `x-minimum`,
    /// `x-maximum`: the muscle refuses others, not the reader of the request) and the one of a
    /// muscle that does not state it.
    pub fn request_schema(&self) -> Value {
        let mut field = self.schema("");
        for (end, value) in self.bounds.ends() {
            field[format!("x-{end}")] = value.into();
        }
        if let Some(value) = self.usual() {
            field["default"] = value.into();
        }
        field
    }
}

impl Measure {
    /// The schema of its key in a muscle file.
    pub fn file_schema(&self) -> Value {
        let mut key = json!({
            "description": self.sentence().trim_end_matches('.'), "type": "number",
        });
        if !self.is_plain() || self.is_share {
            key["x-quantity"] = json!(self.dimension);
        }
        if !self.unit().is_empty() {
            key["x-unit"] = self.unit().into();
        }
        if !self.symbol.is_empty() {
            key["x-symbol"] = self.symbol.into();
        }
        for (end, value) in self.bounds.ends() {
            let end = if end == "above" {
                "exclusiveMinimum"
            } else {
                end
            };
            key[end] = value.into();
        }
        if let Some(usual) = self.usual() {
            key["default"] = usual.into();
        }
        key
    }
}

impl schemars::JsonSchema for MeasureValues {
    fn schema_name() -> Cow<'static, str> {
        "MeasureValues".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let properties: Map<String, Value> = fields()
            .map(|(field, measure)| (field.to_owned(), measure.schema("")))
            .collect();
        schemars::json_schema!({ "type": "object", "properties": properties })
    }
}
