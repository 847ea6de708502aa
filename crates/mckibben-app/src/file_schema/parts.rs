//! The parts that schemas of files consist of: tables, quantities, words.

use mckibben::units::Dimension;
use serde_json::{Map, Value, json};

pub(super) fn table(about: &str, keys: impl IntoIterator<Item = (impl Into<String>, Value)>) -> Value {
    let keys: Map<String, Value> = keys.into_iter().map(|(key, schema)| (key.into(), schema)).collect();
    json!({ "type": "object", "description": about, "properties": keys, "additionalProperties": false })
}

/// A table without some of whose keys there is nothing.
pub(super) fn needing(mut table: Value, keys: &[&str]) -> Value {
    table["required"] = json!(keys);
    table
}

/// The root of a file: its tables, and what is for people.
pub(super) fn root(tables: impl IntoIterator<Item = (&'static str, Value)>) -> Value {
    let people = [("name", text("Name, for people")), ("notes", text("Notes, for people"))];
    table("", tables.into_iter().chain(people))
}

/// A number in the unit inside, or a text with a unit.
pub(super) fn quantity(dimension: Dimension, about: &str) -> Value {
    match dimension.unit_inside().name {
        "" => {
            json!({ "type": ["number", "string"], "description": format!("{about}: a ratio, or a text such as \"10 %\"") })
        }
        unit => json!({
            "type": ["number", "string"],
            "description": format!("{about}: a text with its unit, or a number in {unit}"),
            "x-unit": unit,
        }),
    }
}

/// A quantity above zero, where it is a number.
pub(super) fn positive(dimension: Dimension, about: &str) -> Value {
    let mut schema = quantity(dimension, about);
    schema["exclusiveMinimum"] = json!(0);
    schema
}

pub(super) fn number(about: &str) -> Value {
    json!({ "type": "number", "description": about })
}

pub(super) fn text(about: &str) -> Value {
    json!({ "type": "string", "description": about })
}

pub(super) fn boolean(about: &str) -> Value {
    json!({ "type": "boolean", "description": about })
}

/// One of some words.
pub(super) fn word(about: &str, words: impl IntoIterator<Item = impl Into<Value>>) -> Value {
    json!({ "description": about, "enum": words.into_iter().map(Into::into).collect::<Vec<Value>>() })
}

/// A text for which there are names; other texts may be right as well.
pub(super) fn named(about: &str, names: impl IntoIterator<Item = impl Into<Value>>) -> Value {
    let names: Vec<Value> = names.into_iter().map(Into::into).collect();
    json!({ "description": about, "anyOf": [{ "enum": names }, { "type": "string" }] })
}

/// One of some words, or a quantity.
pub(super) fn word_or(words: &[&str], quantity: Value) -> Value {
    let about = quantity["description"].clone();
    json!({ "description": about, "anyOf": [{ "enum": words }, quantity] })
}

/// Pairs such as times and values.
pub(super) fn pairs(about: &str) -> Value {
    let pair =
        json!({ "type": "array", "items": { "type": ["number", "string"] }, "minItems": 2, "maxItems": 2 });
    json!({ "type": "array", "items": pair, "description": about })
}

/// Both coordinates of a point.
pub(super) fn point(about: &str) -> Value {
    let mut schema = quantity(Dimension::Length, about);
    let about = schema["description"].take();
    json!({ "type": "array", "items": { "type": ["number", "string"] }, "minItems": 2, "maxItems": 2, "description": about })
}

/// Values: a list, a range, or a list of values.
pub(super) fn values(about: &str) -> Value {
    json!({
        "description": format!("{about}: a list (\"30,40 mm\"), or a range (\"0..0.25:0.01 MPa\")"),
        "anyOf": [
            { "type": ["number", "string"] },
            { "type": "array", "items": { "type": ["number", "string"] }, "minItems": 1 },
        ],
    })
}
