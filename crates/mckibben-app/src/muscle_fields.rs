//! A muscle in requests: a file, names, and a field for each measure of
//! [`mckibben::muscle::measures`].

use crate::fields::{InGroup, Stiffness, TextFile, name_or_file};
use mckibben::muscle::measures::{
    ANGLE, LENGTH, MeasureValues, OUTER_DIAMETER, STIFFNESS, WALL, fields,
};
use mckibben::muscle::{Measure, Muscle};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use serde_json::Map;

/// A muscle: a muscle file, and values that replace those of the file. Default values are those of
/// the paper's prototype: D0 30 mm, s 3 mm, L0 285 mm, θ0 28°, rubber and braid `paper`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct MuscleFields {
    #[serde(flatten)]
    pub named: NamedFields,
    /// Measures in place of what these say.
    #[serde(flatten)]
    #[schemars(schema_with = "request_schema")]
    pub measures: MeasureValues,
}

fn request_schema(_: &mut SchemaGenerator) -> Schema {
    let measures = fields().map(|(field, measure)| (field.to_owned(), measure.request_schema()));
    json_schema!({ "type": "object", "properties": measures.collect::<Map<_, _>>() })
}

/// What of a muscle has a name, or completes one.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(transform = InGroup(mckibben::muscle::measures::GROUP))]
pub struct NamedFields {
    /// Muscle file (TOML), or a muscle of the library by its name without a text
    /// (`lib:dmsp-20-300`); the other fields override what it says.
    #[serde(deserialize_with = "name_or_file")]
    pub muscle: Option<TextFile>,
    /// A rubber: NAME or NAME:LAW of the library, a hardness such as `shore:30A`, or a stress at
    /// 100 % such as `s100:0.6MPa`.
    pub rubber: Option<String>,
    /// A muscle file (TOML) whose rubber is taken, such as `rubber` writes.
    pub rubber_file: Option<TextFile>,
    /// A sleeve of the library: its angle on this diameter, its strands.
    pub braid: Option<String>,
    /// Diameter of one strand, mm: in place of its cross-section, or of a named sleeve whose source
    /// does not state it.
    pub strand_diameter_mm: Option<f64>,
    /// Stiffness k of one strand family: a number in N/mm, `inextensible` or `paper`.
    #[schemars(extend("x-key" = STIFFNESS.key, "x-symbol" = STIFFNESS.symbol))]
    pub stiffness: Option<Stiffness>,
}

impl From<NamedFields> for MuscleFields {
    fn from(named: NamedFields) -> Self {
        Self {
            named,
            measures: MeasureValues::default(),
        }
    }
}

impl<const N: usize> From<[(&'static Measure, f64); N]> for MuscleFields {
    fn from(values: [(&'static Measure, f64); N]) -> Self {
        Self {
            named: NamedFields::default(),
            measures: values.into(),
        }
    }
}

impl MuscleFields {
    /// A muscle file alone.
    pub fn from_file(file: TextFile) -> Self {
        NamedFields {
            muscle: Some(file),
            ..NamedFields::default()
        }
        .into()
    }
}

/// Schema of the measures of a muscle beside those of its summary.
pub(crate) fn stated_schema(_: &mut SchemaGenerator) -> Schema {
    let stated =
        stated_measures().map(|(field, m)| (field.to_owned(), m.schema(", where it is stated")));
    json_schema!({ "type": "object", "properties": stated.collect::<Map<_, _>>() })
}

fn stated_measures() -> impl Iterator<Item = (&'static str, &'static Measure)> {
    fields().filter(|(_, measure)| ![&OUTER_DIAMETER, &WALL, &LENGTH, &ANGLE].contains(measure))
}

/// Measures of a muscle beside those of its summary, where they are stated.
pub(crate) fn stated(muscle: &Muscle) -> MeasureValues {
    let mut out = MeasureValues::default();
    for (_, measure) in stated_measures() {
        muscle
            .measure(measure)
            .into_iter()
            .for_each(|value| out.set(measure, value));
    }
    out
}
