//! The values of a file against the list of keys: each is of its kind, and within its bounds.

use super::error::{FileError, without_key};
use super::keys::{Key, dimension, dotted, join, words};
use super::source::{Source, shortened};
use crate::nearest::{meant, nearest};
use crate::rubber::{Law, foreign};
use crate::units::{Dimension, Values, parse_quantity, parse_values, plausible};
use serde_json::{Map, Value, json};
use toml_edit::{Item, TableLike, Value as Written};

const TEXT: &str = "a text in quotes";
const LIST: &str = "a list";
/// A number without unit, for messages.
const PLAIN: &str = "a number without unit, such as 0.8";
/// What a command over time is, for messages.
pub const OVER_TIME: &str = "pairs of times and values such as [[\"0 s\", \"0 bar\"], [\"0.1 \
    s\", \"3 bar\"]], or \"ramp 0..3 bar in 2 s\", \"sine 1..3 bar at 2 Hz\", \"chirp 1..3 bar \
    from 0.1..5 Hz in 10 s\", \"table:command.csv\"";

/// The values of a table; `all` are the keys of the whole file.
pub(super) fn table(
    source: &Source<'_>,
    path: &str,
    table: &dyn TableLike,
    keys: &[Key],
    all: &[Key],
) -> Result<Value, FileError> {
    let mut out = Map::new();
    for (name, item) in table.iter() {
        let Some(key) = keys.iter().find(|key| key.name == name) else {
            return Err(unknown(source, path, table, name, keys, all));
        };
        let name = join(path, name);
        let law = item
            .as_table_like()
            .and_then(|table| table.get("law")?.as_str());
        let value = match (key.table(law), item.as_table_like(), item.as_value()) {
            (Some(inner), Some(table), _) => self::table(source, &name, table, &inner, all)?,
            (inner, None, Some(value)) if inner.is_none() || key.kind == "end-factor" => key
                .read(value)
                .map_err(|problem| source.error(&name, problem))?,
            (inner, ..) => {
                let expected = inner.map_or_else(|| key.expected(), |_| "a table of keys".into());
                return Err(
                    source.error(&name, format!("is {}; expected {expected}", type_of(item)))
                );
            }
        };
        out.insert(key.name.into(), value);
    }
    for key in keys
        .iter()
        .filter(|key| key.is_needed && !table.contains_key(key.name))
    {
        let name = join(path, key.name);
        let Some(inner) = key.table(None) else {
            return Err(source.error(
                path,
                format!(
                    "{name} is missing; expected {} ({})",
                    expected(&key.kind),
                    key.about
                ),
            ));
        };
        self::table(source, &name, &toml_edit::Table::new(), &inner, all)?;
    }
    Ok(out.into())
}

fn unknown(
    source: &Source<'_>,
    path: &str,
    table: &dyn TableLike,
    key: &str,
    keys: &[Key],
    all: &[Key],
) -> FileError {
    let span = table.key(key).and_then(toml_edit::Key::span);
    let is_constant = Law::KINDS.iter().any(|law| law.names().contains(&key));
    let law = table
        .get("law")
        .and_then(Item::as_str)
        .and_then(Law::kind_named);
    if let Some(law) = law.filter(|_| is_constant) {
        return source.key_error(&join(path, key), span, foreign(law));
    }
    let known: Vec<&str> = keys.iter().map(|key| key.name).collect();
    let all = dotted("", all.to_vec());
    let all = || all.iter().map(String::as_str);
    let last = |dotted: &str| dotted.rsplit('.').next().is_some_and(|last| last == key);
    // `thickness` in the tube is its `wall_thickness`, not that of the braid.
    let of_last_word = |k: &&str| k.strip_suffix(key).is_some_and(|k| k.ends_with('_'));
    let suggestion = known.iter().copied().find(of_last_word);
    let suggestion = suggestion.or_else(|| all().find(|dotted| last(dotted)));
    let suggestion = suggestion.or_else(|| nearest(key, known.iter().copied()));
    let suggestion =
        suggestion.or_else(|| all().find(|k| nearest(key, k.rsplit('.').next()).is_some()));
    let problem = format!(
        "unknown key{}; known here: {}",
        meant(suggestion),
        known.join(", ")
    );
    source.key_error(&join(path, &shortened(key)), span, problem)
}

impl Key {
    /// What is expected there, for messages.
    fn expected(&self) -> String {
        let what = expected(&self.kind);
        // A kind alone does not say what is in a text or a list.
        let is_plain = matches!(what.as_str(), TEXT | LIST);
        if is_plain {
            format!("{what} ({})", self.about)
        } else {
            what
        }
    }

    fn read(&self, value: &Written) -> Result<Value, String> {
        let read = of_kind(&self.kind, value, &self.expected())?;
        if let (Some(measure), Some(number)) = (self.measure, read.as_f64()) {
            measure
                .check(number)
                .map_err(|error| without_key(&error, measure.key))?;
        }
        Ok(read)
    }
}

fn expected(kind: &str) -> String {
    let (word, rest) = words(kind);
    match word {
        ">0" | ">=0" => expected(rest),
        "number" | "whole" | "within" | "end-factor" => PLAIN.into(),
        "boolean" => "true or false, without quotes".into(),
        "word" => format!("one of {}", rest.replace(' ', ", ")),
        "or" => {
            let (words, rest) = words(rest);
            format!(
                "\"{}\", or {}",
                words.replace('/', "\", \""),
                expected(rest)
            )
        }
        "list" | "pair" => LIST.into(),
        "values" => {
            "a list such as \"30,40,50\", or a range such as \"0..0.25:0.01\" or \"10..60\"".into()
        }
        "range" => "a range such as \"0..80 mm\" or \"-60..60 deg\"".into(),
        "over-time" => OVER_TIME.into(),
        name => dimension(name).map_or(TEXT, Dimension::expectation).into(),
    }
}

/// A value of a kind in the units used inside; `expected` is what else is allowed there.
fn of_kind(kind: &str, value: &Written, expected: &str) -> Result<Value, String> {
    let (word, rest) = words(kind);
    let wrong = || format!("is {}; expected {expected}", type_of_value(value));
    let unknown = |text: &str, words: &str| {
        let near = nearest(text, words.split([' ', '/']));
        format!("is not known{}; expected {expected}", meant(near))
    };
    let text = value.as_str().map(str::trim);
    match (word, text) {
        (">0" | ">=0", _) => {
            let read = of_kind(rest, value, expected)?;
            let (number, is_above) = (read.as_f64(), word == ">0");
            let low = number.filter(|v| *v < 0.0 || is_above && *v == 0.0);
            let unit = dimension(rest)
                .map_or(String::new(), |d| format!("\u{a0}{}", d.unit_inside().name));
            let must = if is_above {
                "be above zero"
            } else {
                "not be below zero"
            };
            low.map_or(Ok(read), |v| {
                Err(format!("is {v}{}; it must {must}", unit.trim_end()))
            })
        }
        ("number" | "end-factor", _) => sound(value, PLAIN).map(Value::from),
        ("whole", _) => {
            let whole =
                Some(sound(value, PLAIN)?).filter(|v| v.fract() == 0.0 && (0.0..=1e15).contains(v));
            whole
                .map(|v| Value::from(v as u64))
                .ok_or_else(|| "must be a whole number, zero or above".into())
        }
        ("within", _) => {
            let read = sound(value, PLAIN)?;
            let (low, high) = words(rest);
            let within = low.parse().is_ok_and(|low: f64| low <= read)
                && high.parse().is_ok_and(|high: f64| read <= high);
            if within {
                Ok(read.into())
            } else {
                Err(format!("is {read}; it must be from {low} to {high}"))
            }
        }
        ("boolean", _) => value.as_bool().map(Value::from).ok_or_else(wrong),
        ("word", Some(text)) if rest.split(' ').any(|word| word == text) => Ok(text.into()),
        ("word", Some(text)) => Err(unknown(text, rest)),
        ("or", _) => {
            let (words, rest) = words(rest);
            match text {
                Some(text) if words.split('/').any(|word| word == text) => Ok(text.into()),
                Some(text)
                    if !text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) =>
                {
                    Err(unknown(text, words))
                }
                _ => of_kind(rest, value, expected),
            }
        }
        ("list", _) => value
            .as_array()
            .ok_or_else(wrong)?
            .iter()
            .map(|v| of_kind(rest, v, expected))
            .collect(),
        ("pair", _) => match value
            .as_array()
            .map(|array| array.iter().collect::<Vec<_>>())
            .as_deref()
        {
            Some(&[first, second]) => {
                let (one, other) = words(rest);
                Ok(json!([
                    of_kind(one, first, expected)?,
                    of_kind(other, second, expected)?
                ]))
            }
            _ => Err(wrong()),
        },
        ("values" | "range", _) => {
            let (dimension, suffix) = words(rest);
            let read = values(
                value,
                super::keys::dimension(dimension).unwrap_or(Dimension::Ratio),
                suffix,
            )?;
            match (word, &read.0) {
                ("range", Values::Interval(low, high)) => Ok(json!([low, high])),
                ("range", _) => Err(format!("must be {expected}")),
                _ => Ok(json!(read)),
            }
        }
        ("over-time", Some(_)) => Ok(value.as_str().into()),
        ("over-time", None) => of_kind(&format!("list pair time {rest}"), value, expected),
        ("conditioned", Some(text)) if text.ends_with('%') => {
            Ok(json!({ "strain": quantity(value, Dimension::Ratio)? }))
        }
        ("conditioned", _) => quantity(value, Dimension::Pressure).map(Value::from),
        _ => match dimension(word) {
            Some(dimension) => quantity(value, dimension).map(Value::from),
            None => value.as_str().map(Value::from).ok_or_else(wrong),
        },
    }
}

/// Values: a text with a list or a range, a bare number, or a TOML list; and whether `suffix` is
/// behind them.
fn values(value: &Written, dimension: Dimension, suffix: &str) -> Result<(Values, bool), String> {
    if let Some(array) = value.as_array() {
        let list: Result<_, String> = array.iter().map(|v| quantity(v, dimension)).collect();
        return Ok((Values::List(list?), false));
    }
    let Some(text) = value.as_str() else {
        return Ok((Values::List(vec![quantity(value, dimension)?]), false));
    };
    let text = text.trim();
    let behind = Some(suffix)
        .filter(|s| !s.is_empty())
        .and_then(|s| text.strip_suffix(s));
    let values = parse_values(behind.unwrap_or(text), dimension);
    values
        .map(|values| (values, behind.is_some()))
        .map_err(|error| error.to_string())
}

fn quantity(value: &Written, dimension: Dimension) -> Result<f64, String> {
    let expected = dimension.expectation();
    match value.as_str() {
        Some(text) if text.len() > 100 => Err(format!("is a long text; expected {expected}")),
        Some(text) => parse_quantity(text, dimension).map_err(|error| error.problem),
        None => sound(value, expected),
    }
}

/// A number that is computed with.
fn sound(value: &Written, expected: &str) -> Result<f64, String> {
    let number = value
        .as_float()
        .or_else(|| value.as_integer().map(|i| i as f64));
    let given = match number {
        Some(number) if number.is_finite() && (plausible(number) || value.is_integer()) => {
            return Ok(number);
        }
        Some(number) if number.is_finite() => "a number beyond 1e-30 to 1e30",
        Some(_) => "not a finite number",
        None => type_of_value(value),
    };
    Err(format!("is {given}; expected {expected}"))
}

fn type_of(item: &Item) -> &'static str {
    match item {
        Item::None => "nothing",
        Item::Value(value) => type_of_value(value),
        Item::Table(_) => "a table",
        Item::ArrayOfTables(_) => "a list of tables",
    }
}

fn type_of_value(value: &Written) -> &'static str {
    match value {
        Written::String(_) => "a text",
        Written::Integer(_) | Written::Float(_) => "a number",
        Written::Boolean(_) => "true or false",
        Written::Datetime(_) => "a date or time",
        Written::Array(_) => "a list",
        Written::InlineTable(_) => "a table",
    }
}
