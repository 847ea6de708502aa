//! `quantities` and `units`: what a user typed, as numbers, and the units there are.

use crate::problem::{Problem, ProblemKind};
use mckibben::size;
use mckibben::units::{Dimension, RangeError, Values, parse_quantity, parse_values};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Texts that a user typed.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct QuantitiesRequest {
    /// The texts.
    pub texts: Vec<Typed>,
}

/// A text, and what it shall be.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
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
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct QuantitiesAnswer {
    /// One reading for each text.
    pub readings: Vec<Reading>,
}

/// What was understood of a text.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
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

/// Texts of a user as numbers, of which there may be [`MAX_POINTS`](mckibben::units::MAX_POINTS).
pub fn quantities(request: &QuantitiesRequest) -> Result<QuantitiesAnswer, Problem> {
    let mut points = 0.0;
    let wrong = |kind, message: String| Reading::Wrong { problem: Problem::new(kind, message, "") };
    let mut read = |typed: &Typed| {
        let reading = match typed.list {
            false => match parse_quantity(&typed.text, typed.kind) {
                Ok(value) => Reading::One { value },
                Err(error) => wrong(ProblemKind::Quantity, error.to_string()),
            },
            true => match parse_values(&typed.text, typed.kind) {
                Ok(values) => Reading::Many {
                    values: values.sampled(DIVISIONS),
                    interval: match values {
                        Values::Interval(low, high) => Some([low, high]),
                        Values::List(_) => None,
                    },
                },
                Err(error @ RangeError::Quantity(_)) => wrong(ProblemKind::Quantity, error.to_string()),
                Err(error) => wrong(ProblemKind::Range, error.to_string()),
            },
        };
        points += match &reading {
            Reading::Many { values, .. } => values.len() as f64,
            Reading::One { .. } | Reading::Wrong { .. } => 1.0,
        };
        size::points("texts", points)?;
        Ok(reading)
    };
    Ok(QuantitiesAnswer { readings: request.texts.iter().map(&mut read).collect::<Result<_, Problem>>()? })
}

/// The units.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct UnitsRequest {}

/// Every kind of quantity with its units.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct UnitsAnswer {
    /// The kinds.
    pub kinds: Vec<KindOfQuantity>,
}

/// A kind of quantity.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct KindOfQuantity {
    /// Its name.
    pub kind: Dimension,
    /// What a user may write.
    pub expectation: &'static str,
    /// Its units; the one inside has the factor 1.
    pub units: Vec<UnitOfKind>,
}

/// A unit.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct UnitOfKind {
    /// Its usual spelling.
    pub name: &'static str,
    /// A value in this unit is `multiply` / `divide` times the value inside; two factors, so that decimals stay what they are.
    pub multiply: f64,
    /// See `multiply`.
    pub divide: f64,
}

/// Every kind of quantity with its units.
pub fn units(_: &UnitsRequest) -> Result<UnitsAnswer, Problem> {
    let kind = |kind: Dimension| KindOfQuantity {
        kind,
        expectation: kind.expectation(),
        units: kind
            .unit_names()
            .into_iter()
            .filter_map(|name| kind.unit(name))
            .map(|unit| {
                let (multiply, divide) = unit.outside();
                UnitOfKind { name: unit.name, multiply, divide }
            })
            .collect(),
    };
    Ok(UnitsAnswer { kinds: Dimension::all().map(kind).collect() })
}
