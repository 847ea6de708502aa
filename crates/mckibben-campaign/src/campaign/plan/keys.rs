//! The keys of a plan file beside those of its muscle.

use super::{
    axis::{Axis, RUBBER, Variable, variables},
    sampling::SamplingMethod,
};
use mckibben_core::{
    muscle::{
        Bench, Job,
        file::{Measured, MuscleFile, OfBraid, OfModels, OfTerminals, OfTube},
    },
    units::{
        Dimension, Values, parse_values,
        typed::{Choice, Pressure, Ratio, read_number},
    },
};
use mckibben_fem::elements::Elements;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{
    Deserialize, Deserializer,
    de::{DeserializeSeed, Error, MapAccess, SeqAccess, Visitor},
};
use serde_json::{Value, json};
use std::{borrow::Cow, fmt};

/// A campaign: a muscle, what varies, and the points of each.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanKeys {
    /// The rubber tube
    #[serde(default)]
    tube: OfTube,
    /// The braided sleeve
    #[serde(default)]
    braid: OfBraid,
    /// The ends
    #[serde(default)]
    terminals: OfTerminals,
    /// Friction of the braid: half of the width of the hysteresis loop
    #[serde(default)]
    friction: Measured<3>,
    /// What belongs to one model
    #[serde(default)]
    model: OfModels,
    /// What a bench says of this muscle; `identify` writes it
    identified: Option<Bench>,
    /// What it was designed for; `design` writes it
    job: Option<Job>,
    /// How the muscles are sampled
    #[serde(default)]
    pub(super) sampling: OfSampling,
    /// What varies
    #[serde(default)]
    pub(super) vary: Vary,
    /// The points of each muscle
    pub(super) test: OfTest,
    /// Name, for people
    name: Option<String>,
    /// Notes, for people
    notes: Option<String>,
}

impl PlanKeys {
    /// The muscle that is varied, and the keys of the campaign.
    pub(super) fn parts(self) -> (MuscleFile, OfSampling, Vary, OfTest) {
        let muscle = MuscleFile {
            tube: self.tube,
            braid: self.braid,
            terminals: self.terminals,
            friction: self.friction,
            model: self.model,
            identified: self.identified,
            job: self.job,
            name: self.name,
            notes: self.notes,
        };
        (muscle, self.sampling, self.vary, self.test)
    }
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

/// `[vary]`: what varies, in the order in which a factorial plan runs through it.
#[derive(Default)]
pub struct Vary(pub Vec<Axis>);

impl<'de> Deserialize<'de> for Vary {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let variables = variables();
        let mut axes = vec![];
        let table = Tables {
            path: "",
            variables: &variables,
            axes: &mut axes,
        };
        table.deserialize(from)?;
        axes.sort_by_key(|axis| variables.iter().position(|v| v.key == axis.key));
        Ok(Self(axes))
    }
}

/// Reads a table of `[vary]`.
struct Tables<'t> {
    /// Its dotted name with a dot behind it; empty of `[vary]` itself.
    path: &'t str,
    variables: &'t [Variable],
    axes: &'t mut Vec<Axis>,
}

impl<'de> DeserializeSeed<'de> for Tables<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<(), D::Error> {
        from.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Tables<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table of what varies")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(name) = map.next_key::<String>()? {
            let key = format!("{}{name}", self.path);
            let inner = format!("{key}.");
            if let Some(variable) = self.variables.iter().find(|v| v.key == key) {
                let (values, log) = map.next_value_seed(Levels(variable.dimension))?;
                let names = vec![];
                self.axes.push(Axis {
                    key,
                    values,
                    log,
                    names,
                });
            } else if key == RUBBER {
                self.axes.push(Axis::of_rubbers(map.next_value()?));
            } else if self.variables.iter().any(|v| v.key.starts_with(&inner)) {
                map.next_value_seed(Tables {
                    path: &inner,
                    variables: self.variables,
                    axes: self.axes,
                })?;
            } else {
                return Err(A::Error::unknown_field(&name, &[]));
            }
        }
        Ok(())
    }
}

/// Reads values, and whether `log` is behind them.
struct Levels(Dimension);

impl<'de> DeserializeSeed<'de> for Levels {
    type Value = (Values, bool);

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<(Values, bool), D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Levels {
    type Value = (Values, bool);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "a list such as \"30,40,50\", or a range such as \"0..0.25:0.01\" or \"10..60\"",
        )
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<(Values, bool), E> {
        Ok((Values::List(vec![value]), false))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<(Values, bool), E> {
        self.visit_f64(value as f64)
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<(Values, bool), E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<(Values, bool), E> {
        let text = text.trim();
        let before = text.strip_suffix("log");
        let values = parse_values(before.unwrap_or(text), self.0);
        values
            .map(|values| (values, before.is_some()))
            .map_err(E::custom)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(Values, bool), A::Error> {
        let mut list = vec![];
        while let Some(value) = seq.next_element_seed(Level(self.0))? {
            list.push(value);
        }
        Ok((Values::List(list), false))
    }
}

struct Level(Dimension);

impl<'de> DeserializeSeed<'de> for Level {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<f64, D::Error> {
        read_number(self.0, from)
    }
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
