//! JSON Schemas of the files that people write: muscle, joint, drive and plan. Editors complete and check TOML with them.
//!
//! Keys of measures, laws, rubbers, sleeves and valves follow from their tables; the others are written here, and a test compares
//! them with the keys that the readers accept.

mod drive;
mod joint;
mod muscle;
mod plan;
use crate::problem::{Problem, ProblemKind};
use mckibben::nearest::nearest;
use mckibben::units::Dimension;
use serde_json::{Map, Value, json};

/// A kind of file with a schema: its name, what it is, and its schema.
type Kind = (&'static str, &'static str, fn() -> Value);

/// All kinds.
const KINDS: [Kind; 4] = [
    ("muscle", "A muscle: tube, braid, terminals, friction", muscle::schema),
    ("joint", "A joint with one muscle and a spring, or with two muscles", joint::schema),
    ("drive", "A muscle or a joint with valve, air, load and command, for its motion", drive::schema),
    ("plan", "A campaign: a muscle, what varies, and the points of each", plan::schema),
];

/// Names of the kinds of files that have a schema.
pub fn file_kinds() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|kind| kind.0)
}

/// The JSON Schema (draft 7, which TOML editors read) of a kind of file: `muscle`, `joint`, `drive` or `plan`.
///
/// ```
/// let schema = mckibben_app::file_schema("muscle")?;
/// assert_eq!(schema["properties"]["tube"]["properties"]["wall_thickness"]["x-unit"], "mm");
/// # Ok::<(), mckibben_app::Problem>(())
/// ```
///
/// # Errors
/// [`Problem`] of kind `usage` for another name.
pub fn file_schema(kind: &str) -> Result<Value, Problem> {
    let Some((name, about, schema)) = KINDS.iter().find(|known| known.0 == kind) else {
        let names: Vec<&str> = file_kinds().collect();
        let hint =
            nearest(kind, file_kinds()).map_or_else(String::new, |name| format!("did you mean {name}?"));
        let message = format!("there is no file of kind \"{kind}\"; the kinds are {}", names.join(", "));
        return Err(Problem::new(ProblemKind::Usage, message, hint));
    };
    let mut schema = schema();
    let head = json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": format!("{name} file of mckibben"),
        "description": about,
    });
    if let (Value::Object(head), Value::Object(schema)) = (head, &mut schema) {
        schema.extend(head);
    }
    Ok(schema)
}

/// A table with its keys.
fn table(about: &str, keys: impl IntoIterator<Item = (impl Into<String>, Value)>) -> Value {
    let keys: Map<String, Value> = keys.into_iter().map(|(key, schema)| (key.into(), schema)).collect();
    json!({ "type": "object", "description": about, "properties": keys, "additionalProperties": false })
}

/// A table without some of whose keys there is nothing.
fn needing(mut table: Value, keys: &[&str]) -> Value {
    table["required"] = json!(keys);
    table
}

/// The root of a file: its tables, and what is for people.
fn root(tables: impl IntoIterator<Item = (&'static str, Value)>) -> Value {
    let people = [("name", text("Name, for people")), ("notes", text("Notes, for people"))];
    table("", tables.into_iter().chain(people))
}

/// A number in the unit inside, or a text with a unit.
fn quantity(dimension: Dimension, about: &str) -> Value {
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
fn positive(dimension: Dimension, about: &str) -> Value {
    let mut schema = quantity(dimension, about);
    schema["exclusiveMinimum"] = json!(0);
    schema
}

/// A plain number.
fn number(about: &str) -> Value {
    json!({ "type": "number", "description": about })
}

fn text(about: &str) -> Value {
    json!({ "type": "string", "description": about })
}

fn boolean(about: &str) -> Value {
    json!({ "type": "boolean", "description": about })
}

/// One of some words.
fn word(about: &str, words: impl IntoIterator<Item = impl Into<Value>>) -> Value {
    json!({ "description": about, "enum": words.into_iter().map(Into::into).collect::<Vec<Value>>() })
}

/// A text for which there are names; other texts may be right as well.
fn named(about: &str, names: impl IntoIterator<Item = impl Into<Value>>) -> Value {
    let names: Vec<Value> = names.into_iter().map(Into::into).collect();
    json!({ "description": about, "anyOf": [{ "enum": names }, { "type": "string" }] })
}

/// One of some words, or a quantity.
fn word_or(words: &[&str], quantity: Value) -> Value {
    let about = quantity["description"].clone();
    json!({ "description": about, "anyOf": [{ "enum": words }, quantity] })
}

/// Pairs such as times and values.
fn pairs(about: &str) -> Value {
    let pair =
        json!({ "type": "array", "items": { "type": ["number", "string"] }, "minItems": 2, "maxItems": 2 });
    json!({ "type": "array", "items": pair, "description": about })
}

/// Both coordinates of a point.
fn point(about: &str) -> Value {
    let mut schema = quantity(Dimension::Length, about);
    let about = schema["description"].take();
    json!({ "type": "array", "items": { "type": ["number", "string"] }, "minItems": 2, "maxItems": 2, "description": about })
}

/// Values: a list, a range, or a list of values.
fn values(about: &str) -> Value {
    json!({
        "description": format!("{about}: a list (\"30,40 mm\"), or a range (\"0..0.25:0.01 MPa\")"),
        "anyOf": [
            { "type": ["number", "string"] },
            { "type": "array", "items": { "type": ["number", "string"] }, "minItems": 1 },
        ],
    })
}
