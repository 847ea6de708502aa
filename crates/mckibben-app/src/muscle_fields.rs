//! A muscle in requests: a file, names, and a field for each measure of
//! [`mckibben_core::muscle::measures`].

use crate::{
    Problem, ProblemKind, Result,
    fields::{NameOrFile, Stiffness, TextFile, name_or_file, object_or},
    flags::{self, Args},
};
use mckibben_core::{
    muscle::{
        Measure, Muscle, Rubber,
        measures::{ANGLE, LENGTH, MeasureValues, OUTER_DIAMETER, STIFFNESS, WALL, fields},
    },
    units::typed::Length,
};
use mckibben_design::tubes;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Map;
use std::{
    borrow::Cow,
    ops::{Deref, DerefMut},
    str::FromStr,
};

/// A muscle: a muscle file, and values that replace those of the file. Default values are those of
/// the paper's prototype: D0 30 mm, s 3 mm, L0 285 mm, θ0 28°, rubber and braid `antonelli2018`.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
#[command(next_help_heading = "Muscle")]
pub struct MuscleFields {
    /// Muscle file; flags override its values
    ///
    /// `lib:NAME` is a muscle of the library (`mckibben parts list muscles`), `paper` that of the
    /// paper.
    #[serde(deserialize_with = "name_or_file")]
    #[arg(value_name = "MUSCLE.toml", value_parser = flags::muscle_file)]
    pub file: Option<TextFile>,
    /// Muscle file, same as [MUSCLE.toml]
    #[serde(skip)]
    #[arg(long = "muscle", value_name = "MUSCLE.toml", value_parser = flags::muscle_file, hide_short_help = true)]
    pub also_file: Option<TextFile>,
    /// Measures in place of what the file says.
    #[serde(flatten)]
    #[command(flatten)]
    pub measures: Measures,
    /// Tube as it is sold: bore and outer diameter, such as 8x12mm, or its name
    #[arg(long, value_name = "BORExOUTER", hide_short_help = true)]
    pub tube: Option<TubeSize>,
    /// Rubber: `parts list rubbers` [antonelli2018]
    ///
    /// NAME of the library, or NAME:LAW; a hardness (shore:30A), a stress at 100 %
    /// (s100:0.6MPa), or the rubber of a muscle file.
    #[arg(long, value_name = "NAME", value_parser = flags::rubber(), hide_possible_values = true)]
    pub rubber: Option<NameOrFile>,
    /// Sleeve: `parts list sleeves` [none]
    ///
    /// NAME of the library; it gives the angle and the strands. pet:6..18mm: polyester, by least
    /// and largest round diameter; pet:flat:9.4..28mm by its width where it lies flat.
    #[arg(long, value_name = "NAME", value_parser = flags::sleeves(), hide_possible_values = true)]
    pub braid: Option<String>,
    /// Diameter of one strand of a named sleeve, if its source does not state it
    #[arg(long, value_name = "DIAMETER", hide_short_help = true)]
    pub strand_diameter_mm: Option<Length>,
    /// Stiffness of one strand family [antonelli2018]
    ///
    /// In N/mm, or `inextensible`, or `antonelli2018`.
    #[schemars(extend("x-key" = STIFFNESS.key, "x-symbol" = STIFFNESS.symbol))]
    #[arg(long, value_name = "STIFFNESS", value_parser = flags::stiffness)]
    pub stiffness: Option<Stiffness>,
    /// Any key of a muscle file; may be repeated
    ///
    /// Such as terminals.seating=1.6mm; `mckibben schema --file muscle` has all keys.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[arg(long, value_name = "KEY=VALUE")]
    pub with: Vec<String>,
}

impl<const N: usize> From<[(&'static Measure, f64); N]> for MuscleFields {
    fn from(values: [(&'static Measure, f64); N]) -> Self {
        Self {
            measures: Measures(values.into()),
            ..Self::default()
        }
    }
}

impl MuscleFields {
    /// The muscle file.
    pub fn file(&self) -> Option<&TextFile> {
        self.file.as_ref().or(self.also_file.as_ref())
    }

    /// Which fields exclude each other.
    pub fn validate(&self) -> Result<()> {
        let again = self.file.is_some() && self.also_file.is_some();
        Problem::refuse_unused(&[("also_file", again)], "a muscle file is given already")?;
        let has = |measure| self.tube.is_some() && self.measures.get(measure).is_some();
        Problem::refuse_unused(
            &[
                ("outer_diameter_mm", has(&OUTER_DIAMETER)),
                ("wall_mm", has(&WALL)),
            ],
            "`tube` has its own",
        )
    }

    /// A muscle file alone.
    pub fn from_file(file: TextFile) -> Self {
        Self {
            file: Some(file),
            ..Self::default()
        }
    }

    /// An object of fields, or a name alone: `lib:dmsp-20-300`.
    pub fn or_name<'de, D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        object_or(from, |name| {
            Self::from_file(TextFile {
                name,
                text: String::new(),
            })
        })
    }
}

/// A tube as it is sold: `8x12mm`, or its name in the catalogue.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "String", into = "String")]
#[schemars(with = "String")]
pub struct TubeSize {
    /// Bore in mm.
    pub inner_mm: f64,
    /// Outer diameter in mm.
    pub outer_mm: f64,
    /// Its name and its rubber, where it is one of the catalogue.
    pub part: Option<(String, Rubber)>,
}

impl FromStr for TubeSize {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self> {
        let wrong = || {
            Problem::new(
                ProblemKind::Quantity,
                format!(
                    "\"{text}\" is not a tube; expected its bore and outer diameter, such as 8x12mm, \
                 or its name"
                ),
                "`parts list tubes` lists the names; or give `outer_diameter_mm` and \
                `wall_mm`",
            )
        };
        if let Ok(part) = tubes::catalogue().and_then(|all| tubes::find(all, text)) {
            return Ok(Self {
                inner_mm: part.inner_diameter_mm,
                outer_mm: part.outer_diameter_mm,
                part: Some((part.name, part.rubber)),
            });
        }
        let (inner, outer) = text.split_once(['x', 'X', '×']).ok_or_else(wrong)?;
        let inner = inner.trim();
        let outer = outer.trim();
        let unit_at = |text: &str| text.trim_end_matches(|c: char| !c.is_ascii_digit()).len();
        // A unit behind both holds for both.
        let inner = if unit_at(inner) == inner.len() {
            format!("{inner}{}", &outer[unit_at(outer)..])
        } else {
            inner.to_owned()
        };
        let length = |text: &str| {
            text.parse::<Length>()
                .map_err(|e| ProblemKind::Quantity.problem(e))
        };
        let (Length(inner_mm), Length(outer_mm)) = (length(&inner)?, length(outer)?);
        if 0.0 < inner_mm && inner_mm < outer_mm {
            Ok(Self {
                inner_mm,
                outer_mm,
                part: None,
            })
        } else {
            Err(wrong())
        }
    }
}

impl TryFrom<String> for TubeSize {
    type Error = Problem;

    fn try_from(text: String) -> Result<Self> {
        text.parse()
    }
}

impl From<TubeSize> for String {
    fn from(tube: TubeSize) -> Self {
        match tube.part {
            Some((name, _)) => name,
            None => format!("{}x{}mm", tube.inner_mm, tube.outer_mm),
        }
    }
}

/// Values of measures: fields of a request, and the flags of the most usual ones.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Measures(pub MeasureValues);

impl Deref for Measures {
    type Target = MeasureValues;

    fn deref(&self) -> &MeasureValues {
        &self.0
    }
}

impl DerefMut for Measures {
    fn deref_mut(&mut self) -> &mut MeasureValues {
        &mut self.0
    }
}

impl JsonSchema for Measures {
    fn schema_name() -> Cow<'static, str> {
        "Measures".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let measures =
            fields().map(|(field, measure)| (field.to_owned(), measure.request_schema()));
        json_schema!({ "type": "object", "properties": measures.collect::<Map<_, _>>() })
    }
}

/// Schema of the measures of a muscle beside those of its summary.
pub fn stated_schema(_: &mut SchemaGenerator) -> Schema {
    let stated =
        stated_measures().map(|(field, m)| (field.to_owned(), m.schema(", where it is stated")));
    json_schema!({ "type": "object", "properties": stated.collect::<Map<_, _>>() })
}

fn stated_measures() -> impl Iterator<Item = (&'static str, &'static Measure)> {
    fields().filter(|(_, measure)| ![&OUTER_DIAMETER, &WALL, &LENGTH, &ANGLE].contains(measure))
}

/// Measures of a muscle beside those of its summary, where they are stated.
pub fn stated(muscle: &Muscle) -> MeasureValues {
    let mut out = MeasureValues::default();
    for (_, measure) in stated_measures() {
        muscle
            .measure(measure)
            .into_iter()
            .for_each(|value| out.set(measure, value));
    }
    out
}
