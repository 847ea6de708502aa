//! Schemas of keys.

use mckibben::liquid::LIQUIDS;
use mckibben::muscle::Measure;
use mckibben::muscle::file::{Key, OVER_TIME, dimension};
use mckibben::muscle::measures::{END_FACTOR, STIFFNESS};
use mckibben::rubber::{self, Law};
use mckibben::sleeve;
use mckibben::units::Dimension;
use mckibben_fem::elements::Elements;
use mckibben_motion::valves;
use serde_json::{Map, Value, json};

/// A table of these keys.
pub(super) fn table(keys: &[Key], about: &str) -> Value {
    let mut properties = Map::new();
    for key in keys {
        let schema = of_key(key);
        let known = properties.entry(key.name).or_insert(Value::Null);
        *known = match known.take() {
            Value::Null => schema,
            former if former == schema => schema,
            // The same letter in two laws.
            former => json!({ "description": former["description"], "anyOf": [former, schema] }),
        };
    }
    let needed: Vec<&str> = keys
        .iter()
        .filter(|key| key.is_needed)
        .map(|key| key.name)
        .collect();
    let mut table = json!({
        "type": "object", "description": about, "properties": properties, "additionalProperties": false,
    });
    if !needed.is_empty() {
        table["required"] = json!(needed);
    }
    table
}

fn of_key(key: &Key) -> Value {
    let about = key.about;
    match (key.measure, key.table(None)) {
        (Some(measure), _) => of_measure(measure, key),
        (None, Some(keys)) if key.kind == "end-factor" => {
            json!({ "description": about, "anyOf": [{ "type": "number" }, table(&keys, about)] })
        }
        (None, Some(keys)) if key.kind == "material" => of_laws(table(&keys, about)),
        (None, Some(keys)) => table(&keys, about),
        (None, None) => of_kind(&key.kind, about),
    }
}

fn of_measure(measure: &'static Measure, key: &Key) -> Value {
    if *measure == STIFFNESS {
        return of_kind(&key.kind, measure.about);
    }
    if *measure == END_FACTOR {
        return of_key(&Key {
            measure: None,
            ..key.clone()
        });
    }
    let sentence = measure.sentence();
    let is_plain = key.kind == "number";
    let mut schema = of_kind(
        &key.kind,
        if is_plain {
            &sentence
        } else {
            sentence.trim_end_matches('.')
        },
    );
    if let Some(unit) = measure.unit {
        schema["x-unit"] = unit.into();
    }
    if !measure.symbol.is_empty() {
        schema["x-symbol"] = measure.symbol.into();
    }
    for (end, value) in measure.bounds.ends() {
        schema[if end == "above" {
            "exclusiveMinimum"
        } else {
            end
        }] = value.into();
    }
    if let Some(usual) = measure.usual() {
        schema["default"] = usual.into();
    }
    schema
}

/// A rubber's table, which needs the constants of its law.
fn of_laws(mut table: Value) -> Value {
    let laws = Law::KINDS.iter().map(|kind| {
        json!({
            "if": { "properties": { "law": { "const": kind.name } }, "required": ["law"] },
            "then": { "required": kind.names() },
        })
    });
    table["allOf"] = laws.collect();
    table
}

fn of_kind(kind: &str, about: &str) -> Value {
    let (word, rest) = kind.split_once(' ').unwrap_or((kind, ""));
    let of_type = |name: &str| json!({ "type": name, "description": about });
    let any = json!({ "type": ["number", "string"] });
    match word {
        "number" => of_type("number"),
        "boolean" => of_type("boolean"),
        "whole" => json!({ "type": "integer", "minimum": 0, "description": about }),
        "within" => {
            let [low, high] = [0, 1].map(|i| {
                rest.split(' ')
                    .nth(i)
                    .and_then(|end| end.parse::<Value>().ok())
            });
            json!({ "type": "number", "minimum": low, "maximum": high, "description": about })
        }
        "word" => one_of(about, rest.split(' ')),
        "liquid" => one_of(about, LIQUIDS.map(|liquid| liquid.name)),
        "elements" => one_of(about, Elements::ENTRIES.map(|entry| entry.name)),
        "named" => named(about, rest.split(' ')),
        "valve" => named(about, valves().iter().map(|valve| valve.name.as_str())),
        // A damaged table of names leaves the key without them.
        "rubber" => {
            let all = rubber::library::entries().unwrap_or_default();
            named(about, all.iter().map(|entry| entry.name.as_str()))
        }
        "sleeve" => {
            let all = sleeve::library::entries().unwrap_or_default();
            named(about, all.iter().map(|entry| entry.sleeve.name()))
        }
        "or" => {
            let (words, kind) = rest.split_once(' ').unwrap_or_default();
            let quantity = of_kind(kind, about);
            let words: Vec<&str> = words.split('/').collect();
            json!({ "description": quantity["description"], "anyOf": [{ "enum": words }, quantity] })
        }
        "list" => {
            let mut items = of_kind(rest, about);
            items
                .as_object_mut()
                .and_then(|items| items.remove("description"));
            json!({ "type": "array", "items": items, "description": about })
        }
        "pair" => {
            json!({ "type": "array", "items": any, "minItems": 2, "maxItems": 2, "description": about })
        }
        "values" => json!({
            "description": format!("{about}: a list (\"30,40 mm\"), or a range (\"0..0.25:0.01 \
                MPa\")"),
            "anyOf": [any, { "type": "array", "items": any, "minItems": 1 }],
        }),
        "over-time" => {
            let about = format!("{about}: a value, or {OVER_TIME}");
            json!({ "description": about, "anyOf": [any, of_kind("list pair time number", "Pairs of times and values")] })
        }
        "conditioned" => of_kind("pressure", about),
        ">0" | ">=0" => {
            let mut quantity = of_kind(rest, about);
            quantity[if word == ">0" {
                "exclusiveMinimum"
            } else {
                "minimum"
            }] = json!(0);
            quantity
        }
        name => dimension(name)
            .map_or_else(|| of_type("string"), |dimension| quantity(dimension, about)),
    }
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

/// One of some words.
fn one_of(about: &str, words: impl IntoIterator<Item = impl Into<Value>>) -> Value {
    json!({ "description": about, "enum": words.into_iter().map(Into::into).collect::<Vec<Value>>() })
}

/// A text, for which there are names.
fn named(about: &str, names: impl IntoIterator<Item = impl Into<Value>>) -> Value {
    let names: Vec<Value> = names.into_iter().map(Into::into).collect();
    json!({ "description": about, "anyOf": [{ "enum": names }, { "type": "string" }] })
}
