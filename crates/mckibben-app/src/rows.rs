//! Answers as labelled rows, which the terminal and the report print. They follow from the keys of
//! an answer: how a key ends says the unit of its numbers.
//!
//! Keys have blanks between them, each as `key+half=label:4%~`, all but the key optional: `half` is
//! the key of its ±, `_` in a label is a blank, and behind `:` are the digits. Of a column all
//! numbers have as many decimals; with `~` behind the digits each has as many as it needs. `%`
//! shows a ratio in per cent, and `#` a number without its unit. A dot leads into an object; lists
//! in an object are ranges.
//!
//! Sentences have such keys in braces, and in brackets what is left out where one of its keys has
//! no value.

use crate::{Scale, Units, words::*};
use mckibben::units::{Dimension, NamedUnit};
use serde::Serialize;
use serde_json::Value;

/// A label and a value with its unit.
pub type Row = (String, String);

/// Anything as what its keys lead to.
pub fn value<T: Serialize>(of: &T) -> Value {
    serde_json::to_value(of).unwrap_or_default()
}

/// The values of an object, each with its label; those that are not there are left out.
pub fn listed(of: &Value, keys: &str, u: &Units) -> Vec<Row> {
    let keys = keys.split_whitespace().map(|token| Key::parse(token, u));
    keys.filter_map(|key| Some((key.label.clone(), key.text(of)?)))
        .collect()
}

/// A sentence with the values of an object.
pub fn said(of: &Value, sentence: &str, u: &Units) -> String {
    let (mut out, mut rest) = (String::new(), sentence);
    while let Some((before, part)) = rest.split_once(['{', '[']) {
        let is_key = rest[before.len()..].starts_with('{');
        let (inside, behind) = part
            .split_once(if is_key { '}' } else { ']' })
            .unwrap_or((part, ""));
        out += before;
        if is_key {
            out += &Key::parse(inside, u).text(of).unwrap_or_else(|| "–".into());
        } else if keys_of(inside).all(|key| Key::parse(key, u).text(of).is_some()) {
            out += &said(of, inside, u);
        }
        rest = behind;
    }
    out + rest
}

/// The keys in the braces of a sentence.
fn keys_of(sentence: &str) -> impl Iterator<Item = &str> {
    sentence
        .split('{')
        .skip(1)
        .filter_map(|part| part.split('}').next())
}

/// A sentence for each of a list.
pub fn each(list: &Value, sentence: &str, u: &Units) -> Vec<String> {
    list.as_array()
        .into_iter()
        .flatten()
        .map(|of| said(of, sentence, u))
        .collect()
}

/// A key with how its values are shown.
pub struct Key<'a> {
    pub path: &'a str,
    pub half: Option<&'a str>,
    pub label: String,
    /// The unit that is shown, and how many of it the unit of the key is.
    pub unit: String,
    factor: f64,
    pub digits: usize,
    pub is_aligned: bool,
    is_bare: bool,
}

fn at<'a>(of: &'a Value, path: &str) -> Option<&'a Value> {
    path.split('.')
        .try_fold(of, |of, key| of.get(key))
        .filter(|value| !value.is_null())
}

impl<'a> Key<'a> {
    pub fn parse(token: &'a str, u: &Units) -> Self {
        let (head, format) = token.split_once(':').unwrap_or((token, ""));
        let (head, label) = head
            .split_once('=')
            .map_or((head, None), |(head, label)| (head, Some(label)));
        let (path, half) = head
            .split_once('+')
            .map_or((head, None), |(path, half)| (path, Some(half)));
        let key = path.rsplit('.').next().unwrap_or(path);
        let (unit, factor) = if format.contains('%') {
            ("%".to_owned(), 100.0)
        } else {
            unit(key, u)
        };
        Self {
            path,
            half,
            label: label.unwrap_or_else(|| without_unit(key)).replace('_', " "),
            unit,
            factor,
            digits: format
                .trim_end_matches(['%', '~', '#'])
                .parse()
                .unwrap_or(4),
            is_aligned: !format.contains('~'),
            is_bare: format.contains('#'),
        }
    }

    pub fn number(&self, of: &Value, path: &str) -> Option<f64> {
        let number = at(of, path)?.as_f64()?;
        // A rounding error about zero is zero.
        Some(if number.abs() < 1e-9 {
            0.0
        } else {
            self.factor * number
        })
    }

    /// A value with its ± where there is one, but without its unit.
    pub fn bare(&self, of: &Value) -> Option<String> {
        let Some(number_there) = self.number(of, self.path) else {
            return Some(plain(at(of, self.path)?));
        };
        let half = self
            .half
            .and_then(|half| Some((at(of, half)?, self.number(of, half))));
        Some(match half {
            Some((_, Some(half))) => {
                format!("{} ± {}", within(number_there, half), half_width(half))
            }
            Some((said, None)) => {
                format!("{} ± {}", number(number_there, self.digits), plain(said))
            }
            None if self.label == "±" => half_width(number_there),
            None => number(number_there, self.digits),
        })
    }

    fn text(&self, of: &Value) -> Option<String> {
        let is_number = !self.is_bare && self.number(of, self.path).is_some();
        let text = self.bare(of).filter(|text| !text.is_empty())?;
        Some(if is_number {
            format!("{text} {}", self.unit).trim_end().to_owned()
        } else {
            text
        })
    }
}

/// The unit in which the numbers of a key are shown, and how many of it the unit of the key is.
fn unit(key: &str, u: &Units) -> (String, f64) {
    let of = |scale: &Scale| (scale.name.to_string(), scale.value(1.0));
    let Some(named) = NamedUnit::of_field(key) else {
        return (String::new(), 1.0);
    };
    match named.dimension {
        Some(Dimension::Pressure) if key.contains("pressure") => of(&u.pressure),
        Some(Dimension::Force) => of(&u.force),
        Some(Dimension::Length) => of(&u.length),
        Some(Dimension::Volume) => of(&u.volume),
        Some(Dimension::Stiffness) => of(&u.stiffness()),
        Some(Dimension::Angle) => ("°".into(), 1.0),
        None if named.unit == "N/MPa" => of(&u.slope()),
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
                    format!(
                        "{key} {}",
                        ends.iter().map(plain).collect::<Vec<_>>().join("..")
                    )
                }
                value => format!("{key} {}", plain(value)),
            };
            fields.iter().map(one).collect::<Vec<_>>().join(", ")
        }
    }
}

/// The name of a field without its unit.
pub fn without_unit(field: &str) -> &str {
    let ends = Dimension::all().filter_map(Dimension::end_of_name);
    let names = ends.filter_map(|end| field.strip_suffix(end)?.strip_suffix('_'));
    names.min_by_key(|name| name.len()).unwrap_or(field)
}
