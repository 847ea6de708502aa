//! `measures`: every number that describes a muscle, for forms and for readers.

use crate::{Problem, muscle_fields::STIFFNESS_FIELD};
use mckibben::muscle::measures::{MEASURES, STIFFNESS, Written};
use mckibben::{muscle::Measure, units::Dimension};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The measures of a muscle.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MeasuresRequest {}

/// The measures of a muscle.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MeasuresAnswer {
    /// All of them, in the order of the fields of requests.
    pub measures: Vec<MeasureEntry>,
}

/// A measure of a muscle.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
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
        let end = |name: &str| m.bounds.ends().into_iter().find_map(|(end, v)| (end == name).then_some(v));
        Self {
            key: m.key,
            group: m.section(),
            field: m.field.or(named.then_some(STIFFNESS_FIELD)),
            label: m.label(),
            symbol: Some(m.symbol()).filter(|s| !s.is_empty()),
            // A strain may be a percentage.
            quantity: Some(m.dimension).filter(|_| !m.is_plain() || m.written == Written::Quantity),
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
pub fn measures(_: &MeasuresRequest) -> Result<MeasuresAnswer, Problem> {
    Ok(MeasuresAnswer { measures: MEASURES.iter().map(|m| MeasureEntry::from(*m)).collect() })
}
