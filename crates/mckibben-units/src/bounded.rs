//! Quantities with a bound, and intervals of them.

use super::{
    range::{Values, parse_values},
    typed::Quantity,
};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Deserializer, Serialize, de::Error};
use std::borrow::Cow;

/// A quantity above zero.
pub type Positive<Q> = Bounded<Q, false>;
/// A quantity of zero or above.
pub type NotNegative<Q> = Bounded<Q, true>;

/// A quantity above zero, or of zero or above.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Bounded<Q, const MAY_BE_ZERO: bool>(Q);

impl<Q: Quantity, const MAY_BE_ZERO: bool> Bounded<Q, MAY_BE_ZERO> {
    /// Of a quantity within the bound.
    pub fn new(quantity: Q) -> Option<Self> {
        let value: f64 = quantity.into();
        (value > 0.0 || MAY_BE_ZERO && value == 0.0).then_some(Self(quantity))
    }
}

impl<Q: Quantity, const MAY_BE_ZERO: bool> From<Bounded<Q, MAY_BE_ZERO>> for f64 {
    fn from(bounded: Bounded<Q, MAY_BE_ZERO>) -> Self {
        bounded.0.into()
    }
}

impl<'de, Q, const MAY_BE_ZERO: bool> Deserialize<'de> for Bounded<Q, MAY_BE_ZERO>
where
    Q: Quantity + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let quantity = Q::deserialize(from)?;
        let (value, unit): (f64, _) = (quantity.into(), Q::DIMENSION.unit_inside().name);
        if let Some(bounded) = Self::new(quantity) {
            return Ok(bounded);
        }
        let must = if MAY_BE_ZERO {
            "not be below zero"
        } else {
            "be above zero"
        };
        let given = format!("{value}\u{a0}{unit}");
        Err(D::Error::custom(format!(
            "is {}; it must {must}",
            given.trim_end()
        )))
    }
}

impl<Q: JsonSchema, const MAY_BE_ZERO: bool> JsonSchema for Bounded<Q, MAY_BE_ZERO> {
    fn schema_name() -> Cow<'static, str> {
        let bound = if MAY_BE_ZERO {
            "NotNegative"
        } else {
            "Positive"
        };
        format!("{bound}_{}", Q::schema_name()).into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = Q::json_schema(generator);
        let bound = if MAY_BE_ZERO {
            "minimum"
        } else {
            "exclusiveMinimum"
        };
        schema.insert(bound.to_owned(), 0.into());
        schema
    }
}

/// An interval, as text: `0..80 mm`.
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(with = "String")]
pub struct Interval<Q> {
    /// Its lower end.
    pub low: Q,
    /// Its upper end.
    pub high: Q,
}

impl<'de, Q: Quantity> Deserialize<'de> for Interval<Q> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let text = String::deserialize(from)?;
        match parse_values(&text, Q::DIMENSION).map_err(D::Error::custom)? {
            Values::Interval(low, high) => Ok(Self {
                low: low.into(),
                high: high.into(),
            }),
            Values::List(_) => Err(D::Error::custom(
                "must be a range such as \"0..80 mm\" or \"-60..60 deg\"",
            )),
        }
    }
}
