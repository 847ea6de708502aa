//! `quantities`, `units` and `measures`: what a user typed, as numbers, the units there are, and
//! every number that describes a muscle.

use crate::problem::{Problem, ProblemKind, Result};
use mckibben_core::{
    muscle::{
        Measure,
        measures::{MEASURES, STIFFNESS},
    },
    size,
    units::{Dimension, RangeError, Values, parse_quantity, parse_values},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Texts that a user typed.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct QuantitiesRequest {
    /// The texts.
    pub texts: Vec<Typed>,
}

/// A text, and what it shall be.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub struct Typed {
    /// The text, such as `2.5 bar`; a list or range where it is one, such as `0..40:5psi`.
    pub text: String,
    /// What it measures.
    pub kind: Dimension,
    /// It may be a list or range.
    #[serde(default)]
    pub list: bool,
}

/// What was understood, in the order of the texts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct QuantitiesAnswer {
    /// One reading for each text.
    pub readings: Vec<Reading>,
}

/// What was understood of a text.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Reading {
    /// A number, in mm, MPa, N, degrees, or the unit inside of its kind.
    One {
        /// The number.
        value: f64,
    },
    /// A list.
    Many {
        /// The numbers; an interval without a step is cut into 20 parts.
        values: Vec<f64>,
        /// Both ends of an interval without a step, which a search takes as a whole.
        #[serde(skip_serializing_if = "Option::is_none")]
        interval: Option<[f64; 2]>,
    },
    /// It cannot be understood.
    Wrong {
        /// Why.
        problem: Problem,
    },
}

/// Parts of an interval without a step.
const DIVISIONS: usize = 20;

/// Texts of a user as numbers, of which there may be [`MAX_POINTS`](mckibben_core::units::MAX_POINTS).
pub fn quantities(request: &QuantitiesRequest) -> Result<QuantitiesAnswer> {
    let mut points = 0.0;
    let wrong = |kind: ProblemKind, message: String| Reading::Wrong {
        problem: kind.problem(message),
    };
    let mut read = |typed: &Typed| {
        let reading = if !typed.list {
            match parse_quantity(&typed.text, typed.kind) {
                Ok(value) => Reading::One { value },
                Err(error) => wrong(ProblemKind::Quantity, error.to_string()),
            }
        } else {
            match parse_values(&typed.text, typed.kind) {
                Ok(values) => Reading::Many {
                    values: values.sampled(DIVISIONS),
                    interval: match values {
                        Values::Interval(low, high) => Some([low, high]),
                        Values::List(_) => None,
                    },
                },
                Err(error @ RangeError::Quantity(_)) => {
                    wrong(ProblemKind::Quantity, error.to_string())
                }
                Err(error) => wrong(ProblemKind::Range, error.to_string()),
            }
        };
        points += match &reading {
            Reading::Many { values, .. } => values.len() as f64,
            Reading::One { .. } | Reading::Wrong { .. } => 1.0,
        };
        size::points("texts", points)?;
        Ok(reading)
    };
    Ok(QuantitiesAnswer {
        readings: request.texts.iter().map(&mut read).collect::<Result<_>>()?,
    })
}

/// The units.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct UnitsRequest {}

/// Every kind of quantity with its units.
#[derive(Debug, Serialize, JsonSchema)]
pub struct UnitsAnswer {
    /// The kinds.
    pub kinds: Vec<KindOfQuantity>,
}

/// A kind of quantity.
#[derive(Debug, Serialize, JsonSchema)]
pub struct KindOfQuantity {
    /// Its name.
    pub kind: Dimension,
    /// What a user may write.
    pub expectation: String,
    /// Its units; the one inside has the factor 1.
    pub units: Vec<UnitOfKind>,
}

/// A unit.
#[derive(Debug, Serialize, JsonSchema)]
pub struct UnitOfKind {
    /// Its usual spelling.
    pub name: &'static str,
    /// A value in this unit is `multiply` / `divide` times the value inside; two factors, so that
    /// decimals stay what they are.
    pub multiply: f64,
    /// See `multiply`.
    pub divide: f64,
}

/// Every kind of quantity with its units.
pub fn units(_: &UnitsRequest) -> Result<UnitsAnswer> {
    let kind = |kind: Dimension| KindOfQuantity {
        kind,
        expectation: kind.expectation(),
        units: kind
            .unit_names()
            .into_iter()
            .filter_map(|name| kind.unit(name))
            .map(|unit| {
                let (multiply, divide) = unit.outside();
                UnitOfKind {
                    name: unit.name,
                    multiply,
                    divide,
                }
            })
            .collect(),
    };
    Ok(UnitsAnswer {
        kinds: Dimension::all().map(kind).collect(),
    })
}

/// The measures of a muscle.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MeasuresRequest {}

/// The measures of a muscle.
#[derive(Debug, Serialize, JsonSchema)]
pub struct MeasuresAnswer {
    /// All of them, in the order of the fields of requests.
    pub measures: Vec<MeasureEntry>,
}

/// A measure of a muscle.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct MeasureEntry {
    /// Key in the muscle file.
    pub key: &'static str,
    /// Table of the muscle file.
    pub group: &'static str,
    /// Field of requests.
    pub field: Option<&'static str>,
    /// Its name, in a few words.
    pub label: &'static str,
    /// Its symbol.
    pub symbol: Option<&'static str>,
    /// What it measures; none for a plain number.
    pub quantity: Option<Dimension>,
    /// Unit of its numbers; none for a plain number.
    pub unit: Option<&'static str>,
    /// The muscle refuses this value and those below it.
    pub above: Option<f64>,
    /// Lowest value.
    pub minimum: Option<f64>,
    /// Highest value.
    pub maximum: Option<f64>,
    /// Value of a muscle that does not state it.
    pub default: Option<f64>,
    /// What it is, in a sentence.
    pub about: String,
}

impl From<&'static Measure> for MeasureEntry {
    fn from(m: &'static Measure) -> Self {
        let named = *m == STIFFNESS;
        let end = |name: &str| {
            m.bounds
                .ends()
                .into_iter()
                .find_map(|(end, v)| (end == name).then_some(v))
        };
        Self {
            key: m.key,
            group: m.section(),
            field: m.field.or(named.then_some("stiffness")),
            label: m.label,
            symbol: Some(m.symbol).filter(|s| !s.is_empty()),
            // A strain may be a percentage.
            quantity: Some(m.dimension).filter(|_| !m.is_plain() || m.is_share),
            unit: Some(m.unit()).filter(|unit| !unit.is_empty()),
            above: end("above"),
            minimum: end("minimum"),
            maximum: end("maximum"),
            default: m.usual(),
            about: m.sentence(),
        }
    }
}

/// The measures of a muscle.
pub fn measures(_: &MeasuresRequest) -> Result<MeasuresAnswer> {
    Ok(MeasuresAnswer {
        measures: MEASURES.iter().map(|m| MeasureEntry::from(*m)).collect(),
    })
}
