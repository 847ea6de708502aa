//! A muscle in requests: a file, names, and a field for each measure of [`mckibben::muscle::measures`].

use crate::fields::{InGroup, Stiffness, TextFile, name_or_file};
use mckibben::muscle::measures::{ANGLE, LENGTH, MeasureValues, OUTER_DIAMETER, STIFFNESS, WALL, fields};
use mckibben::muscle::{Measure, Muscle};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error as _, MapAccess, Visitor};
use serde::{
    Deserialize, Deserializer, Serialize, Serializer, de::value::MapAccessDeserializer, ser::SerializeMap,
};
use serde_json::{Map, Value};
use std::{borrow::Cow, fmt, sync::LazyLock};

/// A muscle: a muscle file, and values that replace those of the file. Default values are those of the paper's
/// prototype: D0 30 mm, s 3 mm, L0 285 mm, θ0 28°, rubber and braid `paper`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MuscleFields {
    pub named: NamedFields,
    /// Measures in place of what these say.
    pub measures: MeasureValues,
}

/// What of a muscle has a name, or completes one.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(transform = InGroup(mckibben::muscle::measures::GROUP))]
pub struct NamedFields {
    /// Muscle file (TOML), or a muscle of the library by its name without a text (`lib:dmsp-20-300`); the other fields override what it says.
    #[serde(deserialize_with = "name_or_file")]
    pub muscle: Option<TextFile>,
    /// A rubber: NAME or NAME:LAW of the library, a hardness such as `shore:30A`, or a stress at 100 % such as `s100:0.6MPa`.
    pub rubber: Option<String>,
    /// A muscle file (TOML) whose rubber is taken, such as `rubber` writes.
    pub rubber_file: Option<TextFile>,
    /// A sleeve of the library: its angle on this diameter, its strands.
    pub braid: Option<String>,
    /// Diameter of one strand, mm: in place of its cross-section, or of a named sleeve whose source does not state it.
    pub strand_diameter_mm: Option<f64>,
    /// Stiffness k of one strand family: a number in N/mm, `inextensible` or `paper`.
    pub stiffness: Option<Stiffness>,
}

impl From<NamedFields> for MuscleFields {
    fn from(named: NamedFields) -> Self {
        Self { named, measures: MeasureValues::default() }
    }
}

impl<const N: usize> From<[(&'static Measure, f64); N]> for MuscleFields {
    fn from(values: [(&'static Measure, f64); N]) -> Self {
        Self { named: NamedFields::default(), measures: values.into() }
    }
}

impl MuscleFields {
    /// A muscle file alone.
    pub fn of_file(file: TextFile) -> Self {
        NamedFields { muscle: Some(file), ..NamedFields::default() }.into()
    }
}

/// The field of [`STIFFNESS`], which holds a number or a name.
pub(crate) const STIFFNESS_FIELD: &str = "stiffness";

/// Names of the fields, in the order of the schema: the file, the sizes and the angle, what has a name, the other measures.
static NAMES: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    let measures: Vec<&str> = fields().map(|(field, _)| field).collect();
    let sizes = measures.iter().position(|f| *f == "angle_deg").map_or(0, |i| i + 1);
    let (first, rest) = measures.split_at(sizes);
    let named = ["rubber", "rubber_file", "braid", "strand_diameter_mm", "stiffness"];
    [&["muscle"], first, &named, rest].concat()
});

impl Serialize for MuscleFields {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let named = serde_json::to_value(&self.named).map_err(serde::ser::Error::custom)?;
        let mut map = serializer.serialize_map(None)?;
        for name in NAMES.iter() {
            if let Some(value) = Measure::of_field(name).and_then(|m| self.measures.get(m)) {
                map.serialize_entry(name, &value)?;
            } else if let Some(value) = named.get(name) {
                map.serialize_entry(name, value)?;
            }
        }
        map.end()
    }
}

impl<'de> Deserialize<'de> for MuscleFields {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_struct("MuscleFields", &NAMES, Fields)
    }
}

struct Fields;

impl<'de> Visitor<'de> for Fields {
    type Value = MuscleFields;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the fields of a muscle")
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<MuscleFields, A::Error> {
        let fields = Value::deserialize(MapAccessDeserializer::new(map))?;
        let named = NamedFields::deserialize(&fields).map_err(A::Error::custom)?;
        Ok(MuscleFields { named, measures: MeasureValues::deserialize(fields).map_err(A::Error::custom)? })
    }
}

impl JsonSchema for MuscleFields {
    fn schema_name() -> Cow<'static, str> {
        "MuscleFields".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = NamedFields::json_schema(generator);
        let mut named = match schema.remove("properties") {
            Some(Value::Object(named)) => named,
            _ => Map::new(),
        };
        let one = |name: &&str| {
            let mut field =
                Measure::of_field(name).map(Measure::request_schema).or_else(|| named.remove(*name))?;
            if *name == STIFFNESS_FIELD {
                field["x-key"] = STIFFNESS.key.into();
                field["x-symbol"] = STIFFNESS.symbol.into();
            }
            Some(((*name).to_owned(), field))
        };
        let properties: Map<String, Value> = NAMES.iter().filter_map(one).collect();
        schema.insert("properties".into(), properties.into());
        schema
    }
}

/// Measures of a muscle beside those of its summary, where they are stated.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[serde(transparent)]
pub struct Stated(MeasureValues);

impl Stated {
    fn fields() -> impl Iterator<Item = (&'static str, &'static Measure)> {
        fields().filter(|(_, measure)| ![&OUTER_DIAMETER, &WALL, &LENGTH, &ANGLE].contains(measure))
    }

    pub fn iter(&self) -> impl Iterator<Item = (&'static Measure, f64)> {
        self.0.iter()
    }
}

impl From<&Muscle> for Stated {
    fn from(muscle: &Muscle) -> Self {
        let mut out = MeasureValues::default();
        for (_, measure) in Self::fields() {
            muscle.measure(measure).into_iter().for_each(|value| out.set(measure, value));
        }
        Self(out)
    }
}

impl JsonSchema for Stated {
    fn schema_name() -> Cow<'static, str> {
        "Stated".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let one =
            |(field, measure): (&str, &Measure)| (field.to_owned(), measure.schema(", where it is stated"));
        let properties: Map<String, Value> = Self::fields().map(one).collect();
        json_schema!({ "type": "object", "properties": properties })
    }
}
