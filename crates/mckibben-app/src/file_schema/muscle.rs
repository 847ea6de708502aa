//! What of the muscle file follows from tables of measures and laws.

use super::keys::{number, positive, quantity, table, word_or};
use mckibben::muscle::Measure;
use mckibben::muscle::measures::{STIFFNESS, Written, of_section};
use mckibben::rubber::{Constant, Law, LawKind};
use mckibben::units::Dimension;
use serde_json::{Value, json};

/// The measures of a table, with the bounds that their numbers have.
pub(super) fn measures(section: &str) -> impl Iterator<Item = (&'static str, Value)> {
    of_section(section).map(|measure| (measure.name(), of_measure(measure)))
}

fn of_measure(measure: &'static Measure) -> Value {
    if *measure == STIFFNESS {
        return word_or(&["paper", "inextensible"], positive(quantity(measure.dimension, measure.about())));
    }
    if measure.key == "terminals.end_factor" {
        return table([], "tondu-lopez", "")["properties"]["end_factor"].take();
    }
    let sentence = measure.sentence();
    let mut schema = match (measure.written, measure.dimension) {
        (Written::Number, _) | (Written::Special, Dimension::Ratio) => number(&sentence),
        _ => quantity(measure.dimension, sentence.trim_end_matches('.')),
    };
    if let Some(unit) = measure.unit {
        schema["x-unit"] = unit.into();
    }
    if !measure.symbol().is_empty() {
        schema["x-symbol"] = measure.symbol().into();
    }
    for (end, value) in measure.bounds.ends() {
        schema[if end == "above" { "exclusiveMinimum" } else { end }] = value.into();
    }
    if let Some(usual) = measure.usual() {
        schema["default"] = usual.into();
    }
    schema
}

/// `[tube.material]`: the keys beside the constants, then those of each law.
pub(super) fn material(about: &str) -> Value {
    let mut schema = table([], "material", about);
    for kind in Law::KINDS {
        for constant in kind.constants {
            let (known, own) = (&mut schema["properties"][constant.name], of_constant(constant, kind));
            *known = match known.take() {
                Value::Null => own,
                former if former == own => own,
                // The same letter in two laws.
                former => json!({ "description": former["description"], "anyOf": [former, own] }),
            };
        }
    }
    let laws = Law::KINDS.iter().map(|kind| {
        json!({
            "if": { "properties": { "law": { "const": kind.name } }, "required": ["law"] },
            "then": { "required": kind.names() },
        })
    });
    let laws: Vec<Value> = laws.collect();
    schema["allOf"] = laws.into();
    schema
}

fn of_constant(constant: &'static Constant, kind: &LawKind) -> Value {
    let one = match constant.is_modulus() {
        true => quantity(constant.dimension, constant.doc),
        false => number(constant.doc),
    };
    if !kind.is_sum {
        return one;
    }
    json!({ "type": "array", "items": one, "minItems": 1, "description": format!("{}, of each term", constant.doc) })
}
