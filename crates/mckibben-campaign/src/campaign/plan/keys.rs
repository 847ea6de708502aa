//! The keys of a plan file beside those of its muscle.

use super::{
    axis::{Axis, RUBBER, Variable, variables},
    sampling::SamplingMethod,
};
use mckibben_core::{
    muscle::file::{FileError, MuscleFile, Source},
    units::{
        Dimension, Values, parse_values,
        typed::{Choice, Pressure, Ratio, read_number},
    },
};
use mckibben_fem::elements::Elements;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde_json::{Map, Value, json};
use std::borrow::Cow;

/// A campaign: a muscle, what varies, and the points of each.
#[derive(Deserialize, JsonSchema)]
#[schemars(extend("additionalProperties" = false))]
pub struct PlanKeys {
    /// The keys of the muscle that is varied
    #[serde(flatten)]
    #[schemars(with = "MuscleFile")]
    pub(super) muscle: Map<String, Value>,
    /// How the muscles are sampled
    #[serde(default)]
    pub(super) sampling: OfSampling,
    /// What varies
    #[serde(default)]
    pub(super) vary: Vary,
    /// The points of each muscle
    pub(super) test: OfTest,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfSampling {
    /// How muscles are taken from the ranges
    pub method: SamplingMethod,
    /// Number of muscles; not of a factorial plan
    pub samples: Option<u64>,
    /// Seed of the random numbers; not of a factorial plan
    pub seed: Option<u64>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OfTest {
    /// Contractions, such as "0..20:5%"
    pub contractions: Choice<Ratio>,
    /// Whether contractions are shares of the largest of the ideal muscle
    #[serde(default)]
    pub of_ideal: bool,
    /// Pressures, such as "0..0.25:0.01"
    pub pressures: Choice<Pressure>,
    /// Finite elements
    #[schemars(schema_with = "elements")]
    pub model: Option<String>,
    /// Another mesh than the default
    pub mesh: Option<String>,
    /// Whether each row has derivatives of the pull; of fe alone
    #[serde(default)]
    pub sensitivities: bool,
}

fn elements(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "enum": Elements::ENTRIES.map(|entry| entry.name) })
}

/// `[vary]`: what varies.
#[derive(Default, Deserialize)]
#[serde(transparent)]
pub struct Vary(Map<String, Value>);

impl Vary {
    /// The axes, in the order in which a factorial plan runs through them.
    ///
    /// # Errors
    /// [`FileError`] of the first key that cannot vary, or has no levels.
    pub fn axes(&self, source: &Source<'_>) -> Result<Vec<Axis>, FileError> {
        let variables = variables();
        let mut axes = vec![];
        in_table("", &self.0, source, &variables, &mut axes)?;
        axes.sort_by_key(|axis| variables.iter().position(|v| v.key == axis.key));
        Ok(axes)
    }
}

/// The axes of a table of `[vary]`; its dotted name has a dot behind it, that of `[vary]` is empty.
fn in_table(
    path: &str,
    table: &Map<String, Value>,
    source: &Source<'_>,
    variables: &[Variable],
    axes: &mut Vec<Axis>,
) -> Result<(), FileError> {
    for (name, value) in table {
        let key = format!("{path}{name}");
        let inner = format!("{key}.");
        let wrong = |said: String| source.error(&format!("vary.{key}"), said);
        if let Some(variable) = variables.iter().find(|v| v.key == key) {
            let (values, log) = levels(value, variable.dimension).map_err(wrong)?;
            let names = vec![];
            axes.push(Axis {
                key,
                values,
                log,
                names,
            });
        } else if key == RUBBER {
            axes.push(Axis::of_rubbers(
                Vec::deserialize(value).map_err(|error| wrong(error.to_string()))?,
            ));
        } else if variables.iter().any(|v| v.key.starts_with(&inner)) {
            let table = value
                .as_object()
                .ok_or_else(|| wrong("must be a table of what varies".into()))?;
            in_table(&inner, table, source, variables, axes)?;
        } else {
            let table = format!("vary.{path}");
            return Err(source.unknown(table.trim_end_matches('.'), name));
        }
    }
    Ok(())
}

/// Levels such as `"30,40,50"`, or a range such as `"0..0.25:0.01"` or `"10..60"`; and whether `log`
/// is behind them.
fn levels(value: &Value, dimension: Dimension) -> Result<(Values, bool), String> {
    let one = |value: &Value| read_number(dimension, value).map_err(|error| error.to_string());
    let list = match value {
        Value::String(text) => {
            let text = text.trim();
            let before = text.strip_suffix("log");
            let values = parse_values(before.unwrap_or(text), dimension);
            return values
                .map(|values| (values, before.is_some()))
                .map_err(|error| error.to_string());
        }
        Value::Array(list) => list.iter().map(one).collect::<Result<_, _>>()?,
        value => vec![one(value)?],
    };
    Ok((Values::List(list), false))
}

impl JsonSchema for Vary {
    fn schema_name() -> Cow<'static, str> {
        "Vary".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let table = || json!({ "type": "object", "additionalProperties": false });
        let mut all = table();
        for variable in variables() {
            let (tables, name) = variable.key.rsplit_once('.').unwrap_or_default();
            let mut inner = &mut all;
            for part in tables.split('.') {
                inner = &mut inner["properties"][part];
                if inner.is_null() {
                    *inner = table();
                }
            }
            inner["properties"][name] = of_variable(&variable);
        }
        all["properties"]["tube"]["properties"]["rubber"] = json!({
            "description": "Names of rubbers: [\"dragon-skin-30\", \"latex\"]",
            "type": "array", "items": { "type": "string" }, "minItems": 1,
        });
        all.try_into().unwrap_or_default()
    }
}

fn of_variable(variable: &Variable) -> Value {
    let any = json!({ "type": ["number", "string"] });
    json!({
        "description": format!(
            "{}: a list (\"30,40 mm\"), or a range (\"0..0.25:0.01 MPa\")", variable.about
        ),
        "anyOf": [any, { "type": "array", "items": any, "minItems": 1 }],
    })
}
