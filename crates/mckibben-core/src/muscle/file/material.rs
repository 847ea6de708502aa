//! What the tube is made of: `rubber = "name"`, or `[tube.material]` with a law and its constants.

use super::{error::FileError, source::Source};
use crate::{
    muscle::{MuscleError, Rubber},
    rubber::{
        Bulk, Conditioned, Constant, Law, LawKind, law_of, library,
        over_time::{Held, OgdenRoxburgh, Prony},
    },
    units::{
        Dimension, Positive, parse_quantity,
        typed::{Pressure, Ratio, text_or_number},
    },
};
use indexmap::IndexMap;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer};
use serde_json::{Map, Value, json};

/// `[tube.material]`.
#[derive(Debug, Deserialize, JsonSchema)]
#[schemars(extend("additionalProperties" = false))]
pub struct Material {
    /// The law and its constants.
    #[serde(flatten)]
    #[schemars(schema_with = "laws")]
    law: Map<String, Value>,
    /// Where the constants come from
    name: Option<String>,
    /// "incompressible", or a pressure
    bulk_modulus: Option<Bulk>,
    /// Largest stretch of the data behind the constants
    fitted_to_stretch: Option<Positive<f64>>,
    /// At which a strip of it breaks, such as "500 %"
    elongation_at_break: Option<Ratio>,
    /// Of rubber that was stretched before (Ogden & Roxburgh 1999)
    softening: Option<OgdenRoxburgh>,
    /// Pressure of its cycles, or largest strain that all of it has seen, such as "50 %"
    #[serde(default, deserialize_with = "conditioned")]
    #[schemars(with = "Option<Pressure>")]
    conditioned: Option<Conditioned>,
    /// Shares of the stress that relax, each with a time constant: [[0.2, "2 s"]]
    prony: Option<Prony>,
    /// How long the rubber was held
    held: Option<Held>,
}

fn conditioned<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Conditioned>, D::Error> {
    let of_text = |text: &str| {
        if text.trim().ends_with('%') {
            parse_quantity(text, Dimension::Ratio).map(|strain| Conditioned::Strain { strain })
        } else {
            parse_quantity(text, Dimension::Pressure).map(Conditioned::Pressure)
        }
    };
    let expected = Dimension::Pressure.expectation();
    text_or_number(&expected, of_text, Conditioned::Pressure, from).map(Some)
}

/// The laws, and the constants of all of them.
fn laws(_: &mut SchemaGenerator) -> Schema {
    let law = json!({
        "description": "The law of the rubber (`mckibben parts list rubbers`)",
        "enum": Law::names(),
        "x-comment": "",
    });
    // A letter may be another constant in another law.
    let mut constants: IndexMap<&str, Vec<Value>> = IndexMap::new();
    for law in Law::KINDS {
        for constant in law.constants {
            let schema = of_constant(law, constant);
            let known = constants.entry(constant.name).or_default();
            if !known.contains(&schema) {
                known.push(schema);
            }
        }
    }
    let mut properties = Map::from_iter([("law".to_owned(), law)]);
    for (name, mut schemas) in constants {
        let schema = match &schemas[..] {
            [_] => schemas.remove(0),
            _ => json!({ "description": schemas[0]["description"], "anyOf": schemas }),
        };
        properties.insert(name.to_owned(), schema);
    }
    let rules = Law::KINDS.iter().map(|kind| {
        json!({
            "if": { "properties": { "law": { "const": kind.name } }, "required": ["law"] },
            "then": { "required": kind.names() },
        })
    });
    json_schema!({
        "properties": properties,
        "required": ["law"],
        "allOf": rules.collect::<Value>(),
    })
}

/// The schema of a constant of a law.
pub fn of_constant(law: &LawKind, constant: &Constant) -> Value {
    let mut one = json!({ "type": "number" });
    if constant.is_modulus() {
        one["x-quantity"] = json!(constant.dimension);
        one["x-unit"] = constant.unit().into();
    }
    let mut schema = if law.is_sum {
        json!({ "type": "array", "items": one })
    } else {
        one
    };
    schema["description"] = constant.doc.into();
    schema
}

pub fn rubbers(_: &mut SchemaGenerator) -> Schema {
    // A damaged table of names leaves the key without them.
    let all = library::entries().unwrap_or_default();
    let mut schema = named(all.iter().map(|entry| entry.name.as_str()));
    let comment = "or [tube.material] with a law and its constants";
    schema.insert("x-comment".into(), comment.into());
    schema
}

/// The schema of a text for which there are names.
pub fn named<'n>(names: impl Iterator<Item = &'n str>) -> Schema {
    let names: Vec<&str> = names.collect();
    json_schema!({ "anyOf": [{ "enum": names }, { "type": "string" }] })
}

/// The rubber of a name, or that of the table.
pub fn rubber(
    source: &Source<'_>,
    name: Option<String>,
    material: Option<Material>,
) -> Result<Rubber, FileError> {
    match (name, material) {
        (Some(_), Some(_)) => Err(source.error(
            "tube.rubber",
            "give either `rubber` or [tube.material]; both are given",
        )),
        (Some(name), None) => {
            library::find(&name).map_err(|e| source.error("tube.rubber", e.to_string()))
        }
        (None, Some(material)) => with_constants(source, material),
        (None, None) => Ok(Rubber::paper()),
    }
}

const TABLE: &str = "tube.material";

fn with_constants(source: &Source<'_>, material: Material) -> Result<Rubber, FileError> {
    let is_known = |key: &&String| {
        *key == "law"
            || Law::KINDS
                .iter()
                .any(|law| law.names().contains(&key.as_str()))
    };
    if let Some(key) = material.law.keys().find(|key| !is_known(key)) {
        return Err(source.unknown(TABLE, key));
    }
    let located = |error: MuscleError| source.refused(&error);
    let law = law_of(&material.law).map_err(|e| {
        let message = format!("{TABLE}.{e}");
        located(MuscleError { message, ..e })
    })?;
    let mut rubber = Rubber {
        name: material.name,
        law,
        bulk: material.bulk_modulus.unwrap_or_default(),
        fitted_to_stretch: material.fitted_to_stretch.map(f64::from),
        elongation_at_break: material.elongation_at_break.map(f64::from),
        softening: material.softening,
        conditioned: material.conditioned,
        prony: material.prony.filter(|series| !series.branches.is_empty()),
    };
    if let Some(held) = material.held {
        if let Held::For(time_s) = held
            && time_s < 0.0
        {
            return Err(source.error(
                "tube.material.held",
                format!("is {time_s}\u{a0}s; it must not be below zero"),
            ));
        }
        if rubber.prony.is_none() {
            return Err(source.missing(
                "tube.material.prony",
                "tube.material.held",
                "it says how the rubber relaxes",
            ));
        }
        // Before its stresses are taken as less, the series must be one.
        rubber.check().map_err(located)?;
        rubber = rubber.relaxed(held);
    }
    // Constants that are written are those of this muscle, also where they are the library's for
    // another one.
    if library::follows(&rubber) {
        rubber = library::without_name(rubber);
    }
    Ok(rubber)
}
