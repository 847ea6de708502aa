//! A parsed file with the position of each key, and its values in the units used inside.

use super::{
    error::{FileError, TextPosition, without_key},
    keys::{Keys, join},
    said::in_our_words,
};
use crate::{
    joined,
    muscle::MuscleError,
    units::{Dimension, plausible, typed::read_number},
};
use schemars::JsonSchema;
use serde::{
    Deserialize,
    de::{DeserializeOwned, IntoDeserializer},
};
use serde_json::Value;
use serde_path_to_error::Segment;
use std::{borrow::Cow, cell::Cell, fmt, ops::Range};
use toml_edit::{Document, Item, Key, Table, TableLike, TomlError, de::Deserializer};

/// The longest file in bytes.
pub const MAX_BYTES: usize = 1 << 20;

/// Where a byte offset lies in a text.
pub fn position_at(text: &str, offset: usize) -> TextPosition {
    let before = text.get(..offset).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    TextPosition {
        line: before.matches('\n').count() + 1,
        column: before[line_start..].chars().count() + 1,
    }
}

/// A text and its parsed form.
#[derive(Debug)]
pub struct Source<'t> {
    text: &'t str,
    document: Document<&'t str>,
    /// Those of what it was read into.
    keys: Cell<fn() -> Keys>,
}

impl<'t> Source<'t> {
    /// Parses a text.
    ///
    /// # Errors
    /// [`FileError`] where it is no TOML, or longer than [`MAX_BYTES`].
    pub fn parse(text: &'t str) -> Result<Self, FileError> {
        if text.len() > MAX_BYTES {
            return Err(FileError::new(format!(
                "is longer than {MAX_BYTES} bytes, too long for such a file"
            )));
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        match Document::parse(text) {
            Ok(document) => Ok(Self {
                text,
                document,
                keys: Cell::new(Keys::default),
            }),
            Err(error) => Err(syntax(text, &error)),
        }
    }

    /// What is written, as a struct; its JSON Schema says in messages which keys there are.
    ///
    /// # Errors
    /// [`FileError`] with line, column, key, what stood there and what is expected.
    pub fn read<T: DeserializeOwned + JsonSchema>(&self) -> Result<T, FileError> {
        self.keys.set(Keys::of::<T>);
        let value = Value::deserialize(Deserializer::from(self.document.clone()))
            .map_err(|error| FileError::new(error.message()))?;
        if let Some((path, is)) = no_number("", &value) {
            return Err(self.keys.get()().no_number(self, &path, is));
        }
        self.part(value)
    }

    /// The same of some of what is written.
    ///
    /// # Errors
    /// As [`Source::read`].
    pub fn part<T: DeserializeOwned>(&self, value: impl Into<Value>) -> Result<T, FileError> {
        serde_path_to_error::deserialize(value.into()).map_err(|error| {
            let path = self.dotted(error.path());
            self.keys.get()().error(self, &path, &error.inner().to_string())
        })
    }

    /// The dotted key of a path: of an element of a list that of the list; of a table in a list,
    /// with its number behind it.
    fn dotted(&self, path: &serde_path_to_error::Path) -> String {
        let mut out = String::new();
        for segment in path {
            let inner = match segment {
                Segment::Map { key } => join(&out, key),
                Segment::Seq { index } => join(&out, &(index + 1).to_string()),
                _ => break,
            };
            if matches!(segment, Segment::Seq { .. }) && self.row(&inner).is_none() {
                break;
            }
            out = inner;
        }
        out
    }

    /// A key that its table has not.
    pub fn unknown(&self, table: &str, key: &str) -> FileError {
        self.keys.get()().unknown(self, table, key)
    }

    fn table(&self, dotted: &str) -> Option<&dyn TableLike> {
        if dotted.is_empty() {
            return Some(self.document.as_table());
        }
        match self.row(dotted) {
            Some(row) => Some(row),
            None => self.find(dotted)?.1.as_table_like(),
        }
    }

    /// A table in a list of tables, by its number.
    fn row(&self, dotted: &str) -> Option<&Table> {
        let (list, number) = dotted.rsplit_once('.')?;
        let place = number.parse::<usize>().ok()?.checked_sub(1)?;
        self.find(list)?.1.as_array_of_tables()?.get(place)
    }

    /// Key and value at a dotted key, where it is written.
    fn find(&self, dotted: &str) -> Option<(&Key, &Item)> {
        let (parents, last) = dotted.rsplit_once('.').unwrap_or(("", dotted));
        self.table(parents)?.get_key_value(last)
    }

    /// Whether something is written at a dotted key.
    pub fn has(&self, dotted: &str) -> bool {
        self.find(dotted).is_some()
    }

    /// The text with the line of a key as a comment, so that all other lines keep their place;
    /// `None` where it is not written on a line of its own, or is a table.
    pub fn without(&self, dotted: &str) -> Option<String> {
        let (key, item) = self.find(dotted)?;
        let (start, end) = (key.span()?.start, item.as_value()?.span()?.end);
        let line = self.text[..start].rfind('\n').map_or(0, |i| i + 1);
        let is_one = !self.text.get(start..end)?.contains('\n');
        is_one.then(|| [&self.text[..line], "#", &self.text[line..]].concat())
    }

    /// Where a key of a table is.
    pub(super) fn key_span(&self, table: &str, key: &str) -> Option<Range<usize>> {
        self.table(table)?.key(key)?.span()
    }

    /// The text at a dotted key.
    pub fn text_at(&self, dotted: &str) -> Option<&str> {
        self.find(dotted)?.1.as_str()
    }

    /// The texts of a table.
    pub fn texts(&self, dotted: &str) -> impl Iterator<Item = &str> {
        self.table(dotted)
            .into_iter()
            .flat_map(TableLike::iter)
            .filter_map(|(_, item)| item.as_str())
    }

    /// The number at a dotted key, in the unit inside.
    pub fn number(&self, dotted: &str, dimension: Dimension) -> Option<f64> {
        let value = self.find(dotted)?.1.as_value()?.clone();
        read_number(dimension, value.into_deserializer()).ok()
    }

    /// The value of a key that another part of the program judges.
    ///
    /// # Errors
    /// What it says.
    pub fn valid<T, E: fmt::Display>(
        &self,
        dotted: &str,
        result: Result<T, E>,
    ) -> Result<T, FileError> {
        result.map_err(|error| self.error(dotted, format!("is invalid: {error}")))
    }

    /// The problem that a key is missing; it is at `at`, which needs it, or is its table.
    pub fn missing(&self, dotted: &str, at: &str, needs: impl fmt::Display) -> FileError {
        self.error(at, format!("{dotted} is missing; {needs}"))
    }

    /// The values of two keys of a table, or neither; each key has with it what is needed of it.
    ///
    /// # Errors
    /// [`FileError`] where only one is written.
    pub fn both<A, B>(
        &self,
        table: &str,
        first: (&str, Option<A>, &str),
        second: (&str, Option<B>, &str),
    ) -> Result<Option<(A, B)>, FileError> {
        let [one, other] = [first.0, second.0].map(|key| join(table, key));
        match (first.1, second.1) {
            (Some(_), None) => Err(self.missing(&other, &one, second.2)),
            (None, Some(_)) => Err(self.missing(&one, &other, first.2)),
            (first, second) => Ok(first.zip(second)),
        }
    }

    /// The error of the muscle, at the line of the key that caused it.
    pub fn refused(&self, error: &MuscleError) -> FileError {
        // A constant of a law is a key of the rubber's table.
        let full = |key: &&'static str| {
            if key.contains('.') {
                Cow::Borrowed(*key)
            } else {
                Cow::from(format!("tube.material.{key}"))
            }
        };
        let keys: Vec<Cow<'_, str>> = error.fields.iter().map(full).collect();
        let key = keys
            .iter()
            .find(|k| self.has(k))
            .or(keys.first())
            .map_or("muscle", |key| key.as_ref());
        // What does not suit the other measures may be a default.
        let sizes = ["tube.outer_diameter", "tube.wall_thickness", "tube.length"];
        let default = keys
            .iter()
            .find(|k| sizes.contains(&k.as_ref()) && !self.has(k))
            .map(|key| format!("; {key} is not written, so this is its default"));
        self.error(key, without_key(error, key) + &default.unwrap_or_default())
    }

    /// The problem with the value of a key that is written, or else with its table.
    pub fn error(&self, dotted: &str, problem: impl Into<String>) -> FileError {
        let entry = self.find(dotted);
        // The text is before the problem already.
        let text = entry.as_ref().and_then(|(_, item)| item.as_str());
        let quoted = text.map_or(String::new(), |text| format!("\"{}\" ", text.trim()));
        let problem = in_our_words(&problem.into());
        let problem = problem.strip_prefix(&quoted).unwrap_or(&problem);
        let value = entry.as_ref().and_then(|(_, item)| item.as_value()?.span());
        let written = value
            .clone()
            .and_then(|span| self.text.get(span))
            .map(shortened);
        let table = || self.find(dotted.rsplit_once('.')?.0);
        let span = entry
            .or_else(table)
            .and_then(|(key, item)| value.or(key.span()).or_else(|| item.span()));
        let span = self.row(dotted).and_then(Table::span).or(span);
        FileError {
            written,
            ..self.key_error(dotted, span, problem)
        }
    }

    /// The problem with a key itself.
    pub(super) fn key_error(
        &self,
        dotted: &str,
        span: Option<Range<usize>>,
        problem: impl Into<String>,
    ) -> FileError {
        FileError {
            place: span.map(|span| position_at(self.text, span.start)),
            key: Some(dotted.to_owned()),
            ..FileError::new(problem)
        }
    }
}

/// What no number of a file is: where it stands, and what it is.
fn no_number(path: &str, value: &Value) -> Option<(String, &'static str)> {
    let is = match value {
        Value::Object(table) if table.contains_key("$__toml_private_datetime") => "a date or time",
        Value::Object(table) => {
            return table
                .iter()
                .find_map(|(key, value)| no_number(&join(path, key), value));
        }
        Value::Array(list) => return list.iter().find_map(|value| no_number(path, value)),
        Value::Null => "not a finite number",
        Value::Number(x) if !x.as_f64().is_some_and(plausible) => "a number beyond 1e-30 to 1e30",
        _ => return None,
    };
    Some((path.to_owned(), is))
}

/// A text on one line, and not longer than a message can bear.
pub fn shortened(text: &str) -> String {
    let mut out: String = joined(text.split_whitespace(), " ");
    if let Some((cut, _)) = out.char_indices().nth(60) {
        out.truncate(cut);
        out.push('…');
    }
    out
}

fn syntax(text: &str, error: &TomlError) -> FileError {
    let message = shortened(error.message());
    let Some(span) = error.span() else {
        return FileError::new(format!("not valid TOML: {message} in ``"));
    };
    let start = text
        .get(..span.start)
        .map_or(0, |t| t.rfind('\n').map_or(0, |i| i + 1));
    let line = text
        .get(start..)
        .and_then(|t| t.lines().next())
        .unwrap_or("");
    let value = line.split_once('=').map_or("", |(_, v)| v.trim_start());
    let unquoted = value.starts_with(|c: char| c.is_ascii_digit() || c == '-')
        && value
            .split('#')
            .next()
            .is_some_and(|v| v.contains(char::is_alphabetic) && !v.contains('"'));
    let line = shortened(line);
    let hint = if unquoted {
        " (write a quantity with a unit in quotes: \"30 mm\")"
    } else {
        ""
    };
    let problem = format!("not valid TOML: {message} in `{line}`{hint}");
    FileError {
        place: Some(position_at(text, span.start)),
        ..FileError::new(problem)
    }
}
