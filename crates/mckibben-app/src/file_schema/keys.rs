//! Tables of a file and their keys, as `keys.txt` lists them.

use super::muscle::{material, measures};
use mckibben::liquid::LIQUIDS;
use mckibben::muscle::measures::of_section;
use mckibben::rubber::{self, Law};
use mckibben::sleeve;
use mckibben::units::Dimension;
use mckibben_fem::elements::Elements;
use mckibben_motion::valves;
use serde_json::{Map, Value, json};

const KEYS: &str = include_str!("keys.txt");

/// A table: keys that are made elsewhere, and those of sections of the list.
pub(super) fn table(
    made: impl IntoIterator<Item = (&'static str, Value)>,
    sections: &str,
    about: &str,
) -> Value {
    let mut keys: Map<String, Value> =
        made.into_iter().map(|(key, schema)| (key.to_owned(), schema)).collect();
    let mut needed = vec![];
    for line in sections.split(' ').flat_map(lines) {
        let mut parts = line.splitn(3, " : ");
        let [name, kind, about] = [(); 3].map(|()| parts.next().unwrap_or_default());
        let key = name.trim_end_matches('*');
        needed.extend((key != name).then_some(key));
        keys.insert(key.into(), of_kind(kind, about));
    }
    let mut table =
        json!({ "type": "object", "description": about, "properties": keys, "additionalProperties": false });
    if !needed.is_empty() {
        table["required"] = json!(needed);
    }
    table
}

fn lines(section: &str) -> impl Iterator<Item = &'static str> {
    let head = format!("[{section}]");
    KEYS.lines().skip_while(move |line| *line != head).skip(1).take_while(|line| !line.is_empty())
}

fn of_kind(kind: &str, about: &str) -> Value {
    let (word, rest) = kind.split_once(' ').unwrap_or((kind, ""));
    let of_type = |name: &str| json!({ "type": name, "description": about });
    let any = json!({ "type": ["number", "string"] });
    let pair = json!({ "type": "array", "items": any, "minItems": 2, "maxItems": 2 });
    match word {
        "table" => table([], rest, about),
        "measures" => table(measures(rest), rest, about),
        "material" => material(about),
        "varied" => {
            let measures = of_section(rest).map(|measure| (measure.name(), values(measure.about())));
            table(measures, &format!("varied-{rest}"), about)
        }
        "constants" => {
            let constants = Law::KINDS.iter().filter(|kind| !kind.is_sum).flat_map(|kind| kind.constants);
            table(constants.map(|constant| (constant.name, values(constant.doc))), "constants", about)
        }
        "number" => number(about),
        "text" => of_type("string"),
        "boolean" => of_type("boolean"),
        "list" => of_type("array"),
        "whole" => json!({ "type": "integer", "minimum": 0, "description": about }),
        "within" => {
            let [low, high] =
                [0, 1].map(|i| rest.split(' ').nth(i).and_then(|end| end.parse::<Value>().ok()));
            json!({ "type": "number", "minimum": low, "maximum": high, "description": about })
        }
        "word" => one_of(about, rest.split(' ')),
        "liquid" => one_of(about, LIQUIDS.map(|liquid| liquid.name)),
        "elements" => one_of(about, Elements::ENTRIES.map(|entry| entry.name)),
        "law" => one_of(about, Law::names()),
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
            let (other, kind) = rest.split_once(' ').unwrap_or_default();
            word_or(&[other], of_kind(kind, about))
        }
        "pairs" => json!({ "type": "array", "items": pair, "description": about }),
        "point" => {
            let mut point = pair;
            point["description"] = quantity(Dimension::Length, about)["description"].take();
            point
        }
        "values" => values(about),
        "over-time" => {
            let about = format!(
                "{about}: pairs of times and values, a value, \"ramp 0..3 bar in 2 s\", \"sine 1..3 bar at 2 Hz\", \"chirp 1..3 bar from 0.1..5 Hz in 10 s\", or \"table:command.csv\""
            );
            json!({ "description": about, "anyOf": [any, of_kind("pairs", "Pairs of times and values")] })
        }
        "presliding" => {
            let length = of_kind(">0 length", "Presliding length of the friction");
            let several =
                "Shares of the friction, each with a presliding length: [[0.6, \"0.5 mm\"], [0.4, \"3 mm\"]]";
            json!({ "description": about, "anyOf": [length, of_kind("pairs", several)] })
        }
        "end-factor" => {
            let of_pressure = table([], "end-factor", about);
            json!({ "description": about, "anyOf": [{ "type": "number" }, of_pressure] })
        }
        ">0" => positive(of_kind(rest, about)),
        name => match Dimension::all().find(|dimension| json!(dimension) == name) {
            Some(dimension) => quantity(dimension, about),
            None => of_type("string"),
        },
    }
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

pub(super) fn positive(mut quantity: Value) -> Value {
    quantity["exclusiveMinimum"] = json!(0);
    quantity
}

pub(super) fn number(about: &str) -> Value {
    json!({ "type": "number", "description": about })
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

/// A quantity, or a word in its place.
pub(super) fn word_or(words: &[&str], quantity: Value) -> Value {
    let about = quantity["description"].clone();
    json!({ "description": about, "anyOf": [{ "enum": words }, quantity] })
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
