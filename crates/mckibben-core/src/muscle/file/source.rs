//! A parsed file with the position of each key, and its values in the units used inside.

use super::{
    error::{FileError, TextPosition},
    keys::Keys,
    reader::At,
};
use crate::{
    joined,
    units::{Dimension, typed::read_number},
};
use schemars::JsonSchema;
use serde::Deserialize;
use std::{fmt, ops::Range};
use toml_edit::{Document, Item, Key, Table, TableLike, TomlError};

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
            Ok(document) => Ok(Self { text, document }),
            Err(error) => Err(syntax(text, &error)),
        }
    }

    /// What is written, as a struct; its JSON Schema says in messages which keys there are.
    ///
    /// # Errors
    /// [`FileError`] with line, column, key, what stood there and what is expected.
    pub fn read<'s, T: Deserialize<'s> + JsonSchema>(&'s self) -> Result<T, FileError> {
        let root = At::root(self.document.as_item());
        T::deserialize(root).map_err(|wrong| {
            let keys = if cfg!(feature = "keys") {
                Keys::of::<T>()
            } else {
                Keys::default()
            };
            keys.error(self, wrong)
        })
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
        let (_, item) = self.find(dotted)?;
        read_number(dimension, At::root(item)).ok()
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

    /// The problem with the value of a key that is written.
    pub fn error(&self, dotted: &str, problem: impl Into<String>) -> FileError {
        let entry = self.find(dotted);
        // The text is before the problem already.
        let text = entry.as_ref().and_then(|(_, item)| item.as_str());
        let quoted = text.map_or(String::new(), |text| format!("\"{}\" ", text.trim()));
        let problem = problem.into();
        let problem = problem.strip_prefix(&quoted).unwrap_or(&problem);
        let value = entry.as_ref().and_then(|(_, item)| item.as_value()?.span());
        let written = value
            .clone()
            .and_then(|span| self.text.get(span))
            .map(shortened);
        let span = entry.and_then(|(key, item)| value.or(key.span()).or_else(|| item.span()));
        let span = span.or_else(|| self.row(dotted)?.span());
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
