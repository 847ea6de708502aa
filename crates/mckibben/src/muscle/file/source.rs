//! A parsed file that knows the place of everything, and its values in the units used inside.

use super::error::{FileError, TextPosition};
use super::keys::{join, keys};
use serde::Deserialize;
use serde_json::Value;
use std::fmt;
use std::ops::Range;
use toml_edit::{Document, Item, TableLike, TomlError};

/// The longest file in bytes.
pub const MAX_BYTES: usize = 1 << 20;

/// Where a byte offset lies in a text.
pub(super) fn place(text: &str, offset: usize) -> TextPosition {
    let before = text.get(..offset).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    TextPosition {
        line: before.matches('\n').count() + 1,
        column: before[line_start..].chars().count() + 1,
    }
}

/// The text, its parsed form, and its values once they are checked.
#[derive(Debug)]
pub struct Source<'t> {
    text: &'t str,
    pub(super) document: Document<&'t str>,
    values: Value,
}

impl<'t> Source<'t> {
    /// Parses a text, and checks it against sections of the list of keys: numbers are then in the
    /// units used inside.
    ///
    /// # Errors
    /// [`FileError`] with line, column, key, what stood there and what is expected.
    pub fn read(text: &'t str, sections: &str) -> Result<Self, FileError> {
        Self::parse(text)?.checked(sections)
    }

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
                values: Value::Null,
            }),
            Err(error) => Err(syntax(text, &error)),
        }
    }

    /// The same with its values, checked against sections of the list of keys.
    ///
    /// # Errors
    /// As [`Source::read`].
    pub fn checked(mut self, sections: &str) -> Result<Self, FileError> {
        let all = keys(sections);
        self.values = super::check::table(&self, "", self.document.as_table(), &all, &all)?;
        Ok(self)
    }

    /// The table of everything.
    pub fn root(&self) -> Section<'_> {
        Section {
            source: self,
            path: String::new(),
            values: Some(&self.values),
        }
    }

    /// Key and value at a dotted key, where it is written.
    fn find(&self, dotted: &str) -> Option<(Option<Range<usize>>, &Item)> {
        let mut table: &dyn TableLike = self.document.as_table();
        let (parents, last) = dotted.rsplit_once('.').unwrap_or(("", dotted));
        for part in parents.split('.').filter(|p| !p.is_empty()) {
            table = table.get(part)?.as_table_like()?;
        }
        let (key, item) = table.get_key_value(last)?;
        Some((key.span(), item))
    }

    /// Whether something is written at a dotted key.
    pub fn has(&self, dotted: &str) -> bool {
        self.find(dotted).is_some()
    }

    /// The problem with the value of a key that is written.
    pub fn error(&self, dotted: &str, problem: impl Into<String>) -> FileError {
        let entry = self.find(dotted);
        let value = entry.as_ref().and_then(|(_, item)| item.as_value()?.span());
        let written = value
            .clone()
            .and_then(|span| self.text.get(span))
            .map(shortened);
        let span = entry.and_then(|(key, item)| value.or(key).or_else(|| item.span()));
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
        let place = span.map(|span| place(self.text, span.start));
        FileError {
            place,
            key: Some(dotted.to_owned()),
            ..FileError::new(problem)
        }
    }
}

/// A table of the file, which may be missing.
#[derive(Debug, Clone)]
pub struct Section<'s> {
    source: &'s Source<'s>,
    path: String,
    values: Option<&'s Value>,
}

impl<'s> Section<'s> {
    /// A table in this one.
    pub fn at(&self, key: &str) -> Section<'s> {
        Section {
            source: self.source,
            path: join(&self.path, key),
            values: self.value(key),
        }
    }

    fn value(&self, key: &str) -> Option<&'s Value> {
        self.values.and_then(|values| values.get(key))
    }

    /// Whether the table is written.
    pub fn is_written(&self) -> bool {
        self.values.is_some()
    }

    /// Whether a key is written.
    pub fn has(&self, key: &str) -> bool {
        self.value(key).is_some()
    }

    /// Its value, numbers in the units used inside.
    pub fn get<T: Deserialize<'s>>(&self, key: &str) -> Option<T> {
        self.value(key).and_then(|value| T::deserialize(value).ok())
    }

    /// Everything in it.
    pub fn all<T: Deserialize<'s>>(&self) -> Result<T, FileError> {
        let values = self.values.unwrap_or(&Value::Null);
        T::deserialize(values).map_err(|error| self.source.error(&self.path, error.to_string()))
    }

    /// The dotted name of a key.
    pub fn dotted(&self, key: &str) -> String {
        join(&self.path, key)
    }

    /// The problem with the value of a key.
    pub fn error(&self, key: &str, problem: impl Into<String>) -> FileError {
        self.source.error(&self.dotted(key), problem)
    }

    /// The value of a key that another part of the program judges.
    ///
    /// # Errors
    /// What it says.
    pub fn valid<T, E: fmt::Display>(
        &self,
        key: &str,
        result: Result<T, E>,
    ) -> Result<T, FileError> {
        result.map_err(|error| self.error(key, format!("is invalid: {error}")))
    }

    /// The problem that something is missing here; it is at `beside`, which needs it, or at the
    /// table itself.
    pub fn missing(&self, key: &str, beside: Option<&str>, needs: impl fmt::Display) -> FileError {
        let at = beside.map_or_else(|| self.path.clone(), |beside| self.dotted(beside));
        self.source
            .error(&at, format!("{} is missing; {needs}", self.dotted(key)))
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
        place: Some(place(text, span.start)),
        ..FileError::new(problem)
    }
}
