//! What numbers and names of a file must be, for serde.

use serde::{
    Deserialize, Deserializer,
    de::{Error, Unexpected},
};

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde hands over references"
)]
pub fn is_zero(n: &u8) -> bool {
    *n == 0
}

pub fn power<'de, D: Deserializer<'de>>(d: D) -> Result<u8, D::Error> {
    let n = u8::deserialize(d)?;
    let wrong = Unexpected::Unsigned(n.into());
    if n <= 20 {
        Ok(n)
    } else {
        Err(D::Error::invalid_value(
            wrong,
            &"a whole number from 0 to 20",
        ))
    }
}

pub fn name<'de, D: Deserializer<'de>>(d: D) -> Result<String, D::Error> {
    match String::deserialize(d)? {
        n if n.trim().is_empty() => Err(D::Error::custom("is empty; expected a name")),
        n if n.contains(char::is_control) => Err(D::Error::custom(
            "contains control characters; expected a name on one line",
        )),
        n => Ok(n),
    }
}

fn number<'de, D: Deserializer<'de>>(
    d: D,
    expected: &'static str,
    right: fn(f64) -> bool,
) -> Result<f64, D::Error> {
    let v = f64::deserialize(d)?;
    if right(v) {
        Ok(v)
    } else {
        Err(D::Error::invalid_value(Unexpected::Float(v), &expected))
    }
}

pub fn positive<'de, D: Deserializer<'de>>(d: D) -> Result<f64, D::Error> {
    number(d, "a number above zero", |v| v > 0.0)
}

pub fn share<'de, D: Deserializer<'de>>(d: D) -> Result<f64, D::Error> {
    number(d, "zero or more", |v| v >= 0.0)
}

pub fn maybe_positive<'de, D: Deserializer<'de>>(d: D) -> Result<Option<f64>, D::Error> {
    #[derive(Deserialize)]
    struct Positive(#[serde(deserialize_with = "positive")] f64);
    Ok(Option::<Positive>::deserialize(d)?.map(|value| value.0))
}

/// `[low, high]`
pub fn interval<'de, D: Deserializer<'de>>(d: D) -> Result<(f64, f64), D::Error> {
    ordered(<(f64, f64)>::deserialize(d)?)
}

/// `[low, high]` or `[low, null]`
pub fn open_interval<'de, D: Deserializer<'de>>(d: D) -> Result<(f64, f64), D::Error> {
    let (low, high) = <(f64, Option<f64>)>::deserialize(d)?;
    ordered((low, high.unwrap_or(f64::INFINITY)))
}

fn ordered<E: Error>((low, high): (f64, f64)) -> Result<(f64, f64), E> {
    if low <= high {
        Ok((low, high))
    } else {
        Err(E::custom("expected [low, high] with low ≤ high"))
    }
}
