//! TOML values → numbers, and words for what stood there.

use super::error::Problem;
use crate::units::{Dimension, parse_quantity, plausible};
use toml_edit::{Item, Value};

/// What a plain number is, for messages.
pub(super) const PLAIN: &str = "a number without unit, such as 0.8";

/// A number that is computed with.
fn sound(value: f64, expected: &'static str) -> Result<f64, Problem> {
    let found = if value.is_finite() { "a number beyond 1e-30 to 1e30" } else { "not a finite number" };
    if value.is_finite() && plausible(value) { Ok(value) } else { Err(Problem::Type { found, expected }) }
}

pub(super) fn to_quantity(value: &Value, dimension: Dimension) -> Result<f64, Problem> {
    let expected = dimension.expectation();
    match value {
        Value::String(s) if s.value().len() > 100 => Err(Problem::Type { found: "a long text", expected }),
        Value::String(s) => parse_quantity(s.value(), dimension).map_err(Problem::Quantity),
        Value::Integer(i) => Ok(*i.value() as f64),
        Value::Float(f) => sound(*f.value(), expected),
        other => Err(Problem::Type { found: value_kind(other), expected }),
    }
}

pub(super) fn to_number(value: &Value) -> Result<f64, Problem> {
    match value {
        Value::Integer(i) => Ok(*i.value() as f64),
        Value::Float(f) => sound(*f.value(), PLAIN),
        other => Err(Problem::Type { found: value_kind(other), expected: PLAIN }),
    }
}

pub(super) fn kind(item: &Item) -> &'static str {
    match item {
        Item::None => "nothing",
        Item::Value(value) => value_kind(value),
        Item::Table(_) => "a table",
        Item::ArrayOfTables(_) => "a list of tables",
    }
}

pub(super) fn value_kind(value: &Value) -> &'static str {
    match value {
        Value::String(_) => "a text",
        Value::Integer(_) | Value::Float(_) => "a number",
        Value::Boolean(_) => "true or false",
        Value::Datetime(_) => "a date or time",
        Value::Array(_) => "a list",
        Value::InlineTable(_) => "a table",
    }
}

/// A text on one line, and not longer than a message can bear.
pub(super) fn shortened(text: &str) -> String {
    let mut out: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some((cut, _)) = out.char_indices().nth(60) {
        out.truncate(cut);
        out.push('…');
    }
    out
}
