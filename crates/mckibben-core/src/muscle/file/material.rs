//! What the tube is made of: `rubber = "name"`, or `[tube.material]` with a law and its constants.

use super::{
    error::{FileError, without_key},
    source::Source,
    table::Rest,
};
use crate::{
    muscle::Rubber,
    rubber::{
        Bulk, Conditioned, Constant, Law, LawKind, NEEDS_ALL, library, one_of_all,
        over_time::{Held, OgdenRoxburgh, Prony},
    },
    units::{
        Dimension, Positive, parse_quantity,
        typed::{Pressure, Ratio, text_or_number},
    },
};
use indexmap::IndexMap;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{
    Deserialize, Deserializer,
    de::{Error, MapAccess, Visitor, value::MapAccessDeserializer},
};
use serde_json::{Value, json};
use std::{borrow::Cow, fmt};

/// The keys of `[tube.material]` beside the law and its constants.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Other {
    /// Where the constants come from
    name: Option<String>,
    /// Bulk modulus
    bulk_modulus: Option<Bulk>,
    /// Largest stretch of the data behind the constants
    fitted_to_stretch: Option<Positive<f64>>,
    /// Strain at which a strip of it breaks, such as "500 %"
    elongation_at_break: Option<Ratio>,
    /// Softening of rubber that was stretched before (Ogden & Roxburgh 1999)
    softening: Option<OgdenRoxburgh>,
    /// What the rubber has seen: a pressure, or a strain such as "50 %"
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

/// `[tube.material]`.
#[derive(Debug)]
pub struct Material {
    law: &'static LawKind,
    /// The values of each constant that is written: one, or one a term in a sum.
    constants: Vec<Option<Vec<f64>>>,
    other: Other,
}

impl<'de> Deserialize<'de> for Material {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        // The law comes first: it says how its constants are read.
        from.deserialize_struct("Material", &["law"], Reader)
    }
}

struct Reader;

impl<'de> Visitor<'de> for Reader {
    type Value = Material;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a law and its constants")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Material, A::Error> {
        let first: Option<String> = map.next_key()?;
        if first.as_deref() != Some("law") {
            return Err(A::Error::missing_field("law"));
        }
        let OneLaw(law) = map.next_value()?;
        let mut constants = vec![None; law.constants.len()];
        let take = |key: &str, map: &mut A| {
            let Some(i) = law.constants.iter().position(|c| c.name == key) else {
                return Ok(false);
            };
            constants[i] = Some(match (law.is_sum, law.constants[i].is_modulus()) {
                (false, true) => vec![map.next_value::<Pressure>()?.0],
                (false, false) => vec![map.next_value()?],
                (true, true) => map
                    .next_value::<Vec<Pressure>>()?
                    .iter()
                    .map(|p| p.0)
                    .collect(),
                (true, false) => map.next_value()?,
            });
            Ok(true)
        };
        let other = Other::deserialize(MapAccessDeserializer::new(Rest { map, take }))?;
        Ok(Material {
            law,
            constants,
            other,
        })
    }
}

/// A law by its name.
struct OneLaw(&'static LawKind);

impl<'de> Deserialize<'de> for OneLaw {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let name = String::deserialize(from)?;
        Law::kind_named(name.trim()).map(Self).ok_or_else(|| {
            let near = crate::nearest::meant(crate::nearest::nearest(&name, Law::names()));
            D::Error::custom(format!("is not known{near}; expected {}", one_of_all()))
        })
    }
}

impl JsonSchema for Material {
    fn schema_name() -> Cow<'static, str> {
        "Material".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let law = json!({
            "description": "The law of the rubber (`mckibben parts list rubbers`)",
            "enum": Law::names(),
        });
        // A letter may be another constant in another law.
        let mut constants: IndexMap<&str, Vec<Value>> = IndexMap::new();
        for law in Law::KINDS {
            for constant in law.constants {
                let schema = of_constant(law, constant, generator);
                let known = constants.entry(constant.name).or_default();
                if !known.contains(&schema) {
                    known.push(schema);
                }
            }
        }
        let mut properties = serde_json::Map::from_iter([("law".to_owned(), law)]);
        for (name, mut schemas) in constants {
            let schema = match &schemas[..] {
                [_] => schemas.remove(0),
                _ => json!({ "description": schemas[0]["description"], "anyOf": schemas }),
            };
            properties.insert(name.to_owned(), schema);
        }
        let mut schema = Other::json_schema(generator);
        if let Some(Value::Object(other)) = schema.remove("properties") {
            properties.extend(other);
        }
        let rules = Law::KINDS.iter().map(|kind| {
            json!({
                "if": { "properties": { "law": { "const": kind.name } }, "required": ["law"] },
                "then": { "required": kind.names() },
            })
        });
        schema.insert("properties".into(), properties.into());
        schema.insert("required".into(), json!(["law"]));
        schema.insert("allOf".into(), rules.collect());
        schema
    }
}

fn of_constant(law: &LawKind, constant: &Constant, generator: &mut SchemaGenerator) -> Value {
    let one = if constant.is_modulus() {
        Pressure::json_schema(generator)
    } else {
        f64::json_schema(generator)
    };
    let mut schema = if law.is_sum {
        json_schema!({ "type": "array", "items": one })
    } else {
        one
    };
    schema.insert("description".into(), constant.doc.into());
    schema.to_value()
}

pub fn rubbers(_: &mut SchemaGenerator) -> Schema {
    // A damaged table of names leaves the key without them.
    named(
        library::entries()
            .unwrap_or_default()
            .iter()
            .map(|entry| entry.name.as_str()),
    )
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
    let Material {
        law,
        constants,
        other,
    } = material;
    let values = |(constant, values): (&Constant, Option<Vec<f64>>)| {
        let key = format!("{TABLE}.{}", constant.name);
        values.ok_or_else(|| source.missing(&key, "tube.material.law", NEEDS_ALL))
    };
    let lists = law
        .constants
        .iter()
        .zip(constants)
        .map(values)
        .collect::<Result<Vec<_>, _>>()?;
    let law = law.law_of_terms(&lists);
    let wrong = |key: &str, said: String| source.error(&format!("{TABLE}.{key}"), said);
    let mut rubber = Rubber {
        name: other.name,
        law: law.map_err(|e| wrong(e.fields[0], e.message.clone()))?,
        bulk: other.bulk_modulus.unwrap_or_default(),
        fitted_to_stretch: other.fitted_to_stretch.map(f64::from),
        elongation_at_break: other.elongation_at_break.map(f64::from),
        softening: other.softening,
        conditioned: other.conditioned,
        prony: other.prony.filter(|series| !series.branches.is_empty()),
    };
    if let Some(held) = other.held {
        if let Held::For(time_s) = held
            && time_s < 0.0
        {
            let said = format!("is {time_s}\u{a0}s; it must not be below zero");
            return Err(wrong("held", said));
        }
        if rubber.prony.is_none() {
            let needs = "it says how the rubber relaxes";
            return Err(source.missing("tube.material.prony", "tube.material.held", needs));
        }
        // Before its stresses are taken as less, the series must be one.
        rubber
            .check()
            .map_err(|e| wrong("prony", without_key(&e, "tube.material.prony")))?;
        rubber = rubber.relaxed(held);
    }
    // Constants that are written are those of this muscle, also where they are the library's for
    // another one.
    if library::follows(&rubber) {
        rubber = library::without_name(rubber);
    }
    Ok(rubber)
}
