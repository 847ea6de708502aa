//! Text of an answer by its keys: how a key ends says the unit of its numbers.
//!
//! Keys stand with blanks between them, each as `key+half=label:4%~`, all but the key optional: `half` is the key of its ±, `_` in a label is a
//! blank, and behind `:` are the digits. Of a column all numbers have as many decimals; with `~` behind the digits each has its own. `%` shows a
//! ratio in per cent. A dot leads into an object; lists in an object are ranges.

use super::text::{Units, aligned, columns, half_width, number, within};
use crate::spec::without_unit;
use mckibben::units::{Dimension, NamedUnit};
use mckibben_app::units::Scale;
use serde::Serialize;
use serde_json::Value;

struct Key<'a> {
    path: &'a str,
    half: Option<&'a str>,
    label: String,
    /// The unit that is shown, and how many of it the unit of the key is.
    unit: String,
    factor: f64,
    digits: usize,
    is_aligned: bool,
}

/// Anything as what its keys lead to.
pub fn value<T: Serialize>(of: &T) -> Value {
    serde_json::to_value(of).unwrap_or_default()
}

/// The values of an object, each with its label; those that are not there are left out.
pub fn listed(of: &Value, keys: &str, u: &Units) -> Vec<(String, String)> {
    let keys = keys.split_whitespace().map(|token| Key::of(token, u));
    keys.filter_map(|key| Some((key.label.clone(), key.text(of)?))).collect()
}

/// A table with a row for each value of a list; columns of which there is nothing are left out.
pub fn tabled<T: Serialize>(list: &[T], keys: &str, u: &Units) -> String {
    if list.is_empty() {
        return String::new();
    }
    let rows: Vec<Value> = list.iter().map(value).collect();
    let keys = keys.split_whitespace().map(|token| Key::of(token, u));
    columns(keys.filter_map(|key| key.column(&rows)))
}

fn at<'a>(of: &'a Value, path: &str) -> Option<&'a Value> {
    path.split('.').try_fold(of, |of, key| of.get(key)).filter(|value| !value.is_null())
}

impl<'a> Key<'a> {
    fn of(token: &'a str, u: &Units) -> Self {
        let (head, format) = token.split_once(':').unwrap_or((token, ""));
        let (head, label) = head.split_once('=').map_or((head, None), |(head, label)| (head, Some(label)));
        let (path, half) = head.split_once('+').map_or((head, None), |(path, half)| (path, Some(half)));
        let key = path.rsplit('.').next().unwrap_or(path);
        let (unit, factor) = if format.contains('%') { ("%".to_owned(), 100.0) } else { unit(key, u) };
        Self {
            path,
            half,
            label: label.unwrap_or_else(|| without_unit(key)).replace('_', " "),
            unit,
            factor,
            digits: format.trim_end_matches(['%', '~']).parse().unwrap_or(4),
            is_aligned: !format.contains('~'),
        }
    }

    fn number(&self, of: &Value, path: &str) -> Option<f64> {
        let number = at(of, path)?.as_f64()?;
        // What is left of rounding is nothing.
        Some(if number.abs() < 1e-9 { 0.0 } else { self.factor * number })
    }

    /// A value with its ± where there is one, but without its unit.
    fn bare(&self, of: &Value) -> Option<String> {
        let Some(number_there) = self.number(of, self.path) else { return Some(plain(at(of, self.path)?)) };
        let half = self.half.and_then(|half| self.number(of, half));
        Some(match half {
            Some(half) => format!("{} ± {}", within(number_there, half), half_width(half)),
            None if self.label == "±" => half_width(number_there),
            None => number(number_there, self.digits),
        })
    }

    fn text(&self, of: &Value) -> Option<String> {
        let is_number = self.number(of, self.path).is_some();
        let text = self.bare(of).filter(|text| !text.is_empty())?;
        Some(if is_number { format!("{text} {}", self.unit).trim_end().to_owned() } else { text })
    }

    fn column(&self, rows: &[Value]) -> Option<(String, Vec<String>)> {
        let numbers: Vec<Option<f64>> = rows.iter().map(|row| self.number(row, self.path)).collect();
        let is_plain = self.half.is_none() && self.is_aligned;
        let percent = if self.unit == "%" { " %" } else { "" };
        let cells = rows.iter().zip(&numbers).zip(aligned(&numbers, self.digits));
        let cells = cells.map(|((row, number), aligned)| match number {
            Some(_) if is_plain => Some(aligned + percent),
            Some(_) => self.bare(row).map(|text| text + percent),
            None => self.bare(row),
        });
        let cells: Vec<Option<String>> = cells.collect();
        let heading = match &*self.unit {
            "" | "%" => self.label.clone(),
            unit => format!("{} [{unit}]", self.label),
        };
        let is_known = cells.iter().flatten().any(|cell| !cell.is_empty());
        is_known.then(|| (heading, cells.into_iter().map(|c| c.unwrap_or_else(|| "–".into())).collect()))
    }
}

/// The unit in which the numbers of a key are shown, and how many of it the key's own unit is.
fn unit(key: &str, u: &Units) -> (String, f64) {
    let of = |scale: &Scale| (scale.name.clone(), scale.value(1.0));
    let Some(named) = NamedUnit::of_field(key) else { return (String::new(), 1.0) };
    match named.dimension {
        Some(Dimension::Pressure) if key.contains("pressure") => of(&u.pressure),
        Some(Dimension::Force) => of(&u.force),
        Some(Dimension::Length) => of(&u.length),
        Some(Dimension::Volume) => of(&u.volume),
        Some(Dimension::Stiffness) => of(&u.stiffness()),
        Some(Dimension::Angle) => ("°".into(), 1.0),
        None if named.unit == "mm/s" => (format!("{}/s", u.length.name), u.length.value(1.0)),
        _ => (named.unit.into(), 1.0),
    }
}

/// A text, a list or an object on one line.
fn plain(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::Bool(is) => if *is { "yes" } else { "no" }.into(),
        Value::Number(v) => v.as_f64().map_or_else(String::new, |v| number(v, 5)),
        Value::String(text) => text.clone(),
        Value::Array(list) => list.iter().map(plain).collect::<Vec<_>>().join(", "),
        Value::Object(fields) => {
            let one = |(key, value): (&String, &Value)| match value {
                Value::Array(ends) => {
                    format!("{key} {}", ends.iter().map(plain).collect::<Vec<_>>().join(".."))
                }
                value => format!("{key} {}", plain(value)),
            };
            fields.iter().map(one).collect::<Vec<_>>().join(", ")
        }
    }
}
