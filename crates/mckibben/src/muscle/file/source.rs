//! A parsed file that knows where everything stands: sections, and typed look-ups in them.

use super::error::{FileError, Problem, TextPosition};
use super::values::{PLAIN, kind, shortened, to_number, to_quantity, value_kind};
use crate::nearest::{meant, nearest};
use crate::units::{Dimension, Values, parse_values};
use std::borrow::Cow;
use std::ops::Range;
use toml_edit::{Document, Item, TableLike, TomlError, Value};

/// The longest muscle file in bytes.
pub const MAX_BYTES: usize = 1 << 20;

/// Where a byte offset lies in a text.
pub(super) fn place(text: &str, offset: usize) -> TextPosition {
    let before = text.get(..offset).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    TextPosition { line: before.matches('\n').count() + 1, column: before[line_start..].chars().count() + 1 }
}

/// The text and its parsed form.
#[derive(Debug)]
pub struct Source<'t> {
    text: &'t str,
    document: Document<&'t str>,
}

/// A table of the file, which may be missing.
#[derive(Clone, Copy)]
pub struct Section<'s> {
    source: &'s Source<'s>,
    path: &'static str,
    table: Option<&'s dyn TableLike>,
}

impl<'t> Source<'t> {
    /// Parses a text.
    ///
    /// # Errors
    /// [`FileError`] where it is no TOML, or longer than [`MAX_BYTES`].
    pub fn parse(text: &'t str) -> Result<Self, FileError> {
        if text.len() > MAX_BYTES {
            return Err(FileError::new(Problem::Said(format!(
                "is longer than {MAX_BYTES} bytes, too long for such a file"
            ))));
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        match Document::parse(text) {
            Ok(document) => Ok(Self { text, document }),
            Err(error) => Err(syntax(text, &error)),
        }
    }

    /// The table of everything.
    pub fn root(&self) -> Section<'_> {
        Section { source: self, path: "", table: Some(self.document.as_table()) }
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

    fn slice(&self, span: &Range<usize>) -> Option<String> {
        self.text.get(span.clone()).map(shortened)
    }

    /// The problem with the value of a key that is written.
    pub fn error(&self, dotted: &str, problem: Problem) -> FileError {
        let error = FileError::new(problem);
        let Some((key_span, item)) = self.find(dotted) else {
            return error.under(dotted, None);
        };
        let value_span = item.as_value().and_then(Value::span);
        let written = value_span.as_ref().and_then(|s| self.slice(s));
        let start = value_span.or(key_span).or_else(|| item.span()).map(|s| s.start);
        error.at(start.map(|s| place(self.text, s))).under(dotted, written)
    }

    /// The problem with a key itself.
    fn key_error(&self, dotted: &str, span: Option<Range<usize>>, problem: Problem) -> FileError {
        FileError::new(problem).at(span.map(|s| place(self.text, s.start))).under(dotted, None)
    }
}

impl<'s> Section<'s> {
    /// A table in this one.
    pub fn section(&self, key: &str, path: &'static str) -> Result<Section<'s>, FileError> {
        let table = match self.table.and_then(|t| t.get(key)) {
            None => None,
            Some(item) => match item.as_table_like() {
                Some(table) => Some(table),
                None => return Err(self.type_error(key, item, "a table of keys")),
            },
        };
        Ok(Section { source: self.source, path, table })
    }

    /// Whether the table is written.
    pub fn is_written(&self) -> bool {
        self.table.is_some()
    }

    /// Whether a key is written.
    pub fn has(&self, key: &str) -> bool {
        self.table.is_some_and(|t| t.contains_key(key))
    }

    /// The dotted name of a key.
    pub fn dotted(&self, key: &str) -> String {
        if self.path.is_empty() { key.into() } else { format!("{}.{key}", self.path) }
    }

    /// The problem with the value of a key.
    pub fn error(&self, key: &str, problem: Problem) -> FileError {
        self.source.error(&self.dotted(key), problem)
    }

    /// The problem that something is missing here; it is at `beside`, which needs it, or at the table itself.
    pub fn missing(&self, key: &str, beside: Option<&str>, needs: impl Into<Cow<'static, str>>) -> FileError {
        let problem = Problem::Missing { missing: self.dotted(key), needs: needs.into() };
        match beside {
            Some(beside) => self.error(beside, problem),
            None => self.source.error(self.path, problem),
        }
    }

    fn type_error(&self, key: &str, item: &Item, expected: &'static str) -> FileError {
        self.error(key, Problem::Type { found: kind(item), expected })
    }

    /// Every key must be one of `known`. `all` are the dotted keys of the whole file: a key that belongs elsewhere is
    /// recognised by them.
    pub fn only(&self, known: &[&'static str], all: &[&'static str]) -> Result<(), FileError> {
        for (key, span) in self.keys() {
            if known.contains(&key) {
                continue;
            }
            // `thickness` in the tube is its `wall_thickness`, not that of the braid.
            let last_word =
                || known.iter().copied().find(|k| k.strip_suffix(key).is_some_and(|k| k.ends_with('_')));
            let elsewhere = || all.iter().find(|k| k.rsplit('.').next() == Some(key)).copied();
            let here = || nearest(key, known.iter().copied());
            let far = || all.iter().find(|k| nearest(key, k.rsplit('.').next()).is_some()).copied();
            let suggestion = last_word().or_else(elsewhere).or_else(here).or_else(far).map(str::to_string);
            let problem = Problem::Said(format!(
                "unknown key{}; known here: {}",
                meant(suggestion.as_deref()),
                known.join(", ")
            ));
            return Err(self.source.key_error(&self.dotted(&shortened(key)), span, problem));
        }
        Ok(())
    }

    /// The keys that are written, and where.
    pub fn keys(&self) -> impl Iterator<Item = (&'s str, Option<Range<usize>>)> + use<'s> {
        let table = self.table;
        table
            .into_iter()
            .flat_map(|t| t.iter())
            .map(move |(k, _)| (k, table.and_then(|t| t.key(k)).and_then(toml_edit::Key::span)))
    }

    /// The problem with a key itself, wherever its value stands.
    pub fn key_error(&self, key: &str, span: Option<Range<usize>>, problem: Problem) -> FileError {
        self.source.key_error(&self.dotted(key), span, problem)
    }

    fn value(&self, key: &str, expected: &'static str) -> Result<Option<&'s Value>, FileError> {
        match self.table.and_then(|t| t.get(key)) {
            None => Ok(None),
            Some(Item::Value(value)) => Ok(Some(value)),
            Some(item) => Err(self.type_error(key, item, expected)),
        }
    }

    /// Whether the value is a text that ends in `%`.
    pub fn is_percent(&self, key: &str) -> bool {
        let written = self.table.and_then(|t| t.get(key)).and_then(Item::as_str);
        written.is_some_and(|text| text.trim_end().ends_with('%'))
    }

    /// A quantity: a text with a unit, or a bare number.
    pub fn quantity(&self, key: &str, dimension: Dimension) -> Result<Option<f64>, FileError> {
        let value = self.value(key, dimension.expectation())?;
        value.map(|v| to_quantity(v, dimension).map_err(|p| self.error(key, p))).transpose()
    }

    /// A number without unit.
    pub fn number(&self, key: &str) -> Result<Option<f64>, FileError> {
        self.value(key, PLAIN)?.map(|v| to_number(v).map_err(|p| self.error(key, p))).transpose()
    }

    /// A text.
    pub fn text(&self, key: &str, expected: &'static str) -> Result<Option<&'s str>, FileError> {
        let Some(value) = self.value(key, expected)? else { return Ok(None) };
        let problem = || Problem::Type { found: value_kind(value), expected };
        value.as_str().map(Some).ok_or_else(|| self.error(key, problem()))
    }

    /// `true` or `false`.
    pub fn boolean(&self, key: &str) -> Result<Option<bool>, FileError> {
        let expected = "true or false, without quotes";
        let Some(value) = self.value(key, expected)? else { return Ok(None) };
        let problem = || Problem::Type { found: value_kind(value), expected };
        value.as_bool().map(Some).ok_or_else(|| self.error(key, problem()))
    }

    /// A list of pressures (with a dimension) or plain numbers (without).
    pub fn list(&self, key: &str, dimension: Option<Dimension>) -> Result<Option<Vec<f64>>, FileError> {
        let expected = match dimension {
            Some(_) => "a list such as [\"0.62 MPa\", 0.0012]",
            None => "a list of numbers such as [1.3, 5.0]",
        };
        let Some(value) = self.value(key, expected)? else { return Ok(None) };
        let Some(array) = value.as_array() else {
            return Err(self.error(key, Problem::Type { found: value_kind(value), expected }));
        };
        let read = |v: &Value| match dimension {
            Some(dimension) => to_quantity(v, dimension),
            None => to_number(v),
        };
        let list = array.iter().map(read).collect::<Result<Vec<f64>, Problem>>();
        list.map(Some).map_err(|p| self.error(key, p))
    }

    /// A list of pairs, such as times and pressures; without a dimension a plain number.
    pub fn pairs(
        &self,
        key: &str,
        dimensions: (Option<Dimension>, Option<Dimension>),
        expected: &'static str,
    ) -> Result<Option<Vec<(f64, f64)>>, FileError> {
        let Some(value) = self.value(key, expected)? else { return Ok(None) };
        let wrong = || self.error(key, Problem::Type { found: value_kind(value), expected });
        let read = |v: &Value, dimension: Option<Dimension>| match dimension {
            Some(dimension) => to_quantity(v, dimension),
            None => to_number(v),
        };
        let pair = |item: &Value| -> Result<(f64, f64), FileError> {
            let list = item.as_array().ok_or_else(wrong)?;
            let (Some(a), Some(b), 2) = (list.get(0), list.get(1), list.len()) else { return Err(wrong()) };
            let both = read(a, dimensions.0).and_then(|a| Ok((a, read(b, dimensions.1)?)));
            both.map_err(|p| self.error(key, p))
        };
        value.as_array().ok_or_else(wrong)?.iter().map(pair).collect::<Result<_, _>>().map(Some)
    }

    /// A list of lists of numbers, each of as many.
    pub fn rows(&self, key: &str) -> Result<Option<Vec<Vec<f64>>>, FileError> {
        let expected = "rows of numbers, each of as many, such as [[1.5, 2], [1, 0.5]]";
        let Some(value) = self.value(key, expected)? else { return Ok(None) };
        let wrong = || self.error(key, Problem::Type { found: value_kind(value), expected });
        let row = |row: &Value| -> Result<Vec<f64>, FileError> {
            let row = row.as_array().ok_or_else(wrong)?;
            row.iter().map(|v| to_number(v).map_err(|p| self.error(key, p))).collect()
        };
        let rows: Vec<Vec<f64>> =
            value.as_array().ok_or_else(wrong)?.iter().map(row).collect::<Result<_, _>>()?;
        if rows.windows(2).any(|pair| pair[0].len() != pair[1].len()) {
            return Err(wrong());
        }
        Ok(Some(rows))
    }

    /// A list of texts.
    pub fn texts(&self, key: &str, expected: &'static str) -> Result<Option<Vec<&'s str>>, FileError> {
        let Some(value) = self.value(key, expected)? else { return Ok(None) };
        let wrong = || self.error(key, Problem::Type { found: value_kind(value), expected });
        let list = value.as_array().ok_or_else(wrong)?;
        list.iter().map(|v| v.as_str().ok_or_else(wrong)).collect::<Result<_, _>>().map(Some)
    }

    /// Whether a list is at a key.
    pub fn is_list(&self, key: &str) -> bool {
        self.table.and_then(|t| t.get(key)).is_some_and(Item::is_array)
    }

    /// Whether a text is at a key.
    pub fn is_text(&self, key: &str) -> bool {
        self.table.and_then(|t| t.get(key)).is_some_and(Item::is_str)
    }

    /// Values: a text with a list or a range, a bare number, or a TOML list; and whether `suffix` stood behind them.
    pub fn values(
        &self,
        key: &str,
        dimension: Dimension,
        suffix: &str,
    ) -> Result<Option<(Values, bool)>, FileError> {
        let expected = "a list such as \"30,40,50\", or a range such as \"0..0.25:0.01\" or \"10..60\"";
        let Some(value) = self.value(key, expected)? else { return Ok(None) };
        if let Some(array) = value.as_array() {
            let list = array.iter().map(|v| to_quantity(v, dimension)).collect::<Result<Vec<_>, _>>();
            return list.map(|l| Some((Values::List(l), false))).map_err(|p| self.error(key, p));
        }
        let Some(text) = value.as_str() else {
            let number = to_quantity(value, dimension).map_err(|p| self.error(key, p))?;
            return Ok(Some((Values::List(vec![number]), false)));
        };
        let text = text.trim();
        let behind = Some(suffix).filter(|s| !s.is_empty()).and_then(|s| text.strip_suffix(s));
        let values = parse_values(behind.unwrap_or(text), dimension);
        values.map(|v| Some((v, behind.is_some()))).map_err(|e| self.error(key, Problem::Said(e.to_string())))
    }

    /// One of some words, or a quantity; `expected` describes both.
    pub fn word_or_quantity(
        &self,
        key: &str,
        words: &[&'static str],
        dimension: Dimension,
        expected: &'static str,
    ) -> Result<Option<WordOr>, FileError> {
        let Some(value) = self.value(key, expected)? else { return Ok(None) };
        if let Some(text) = value.as_str() {
            if let Some(word) = words.iter().find(|w| **w == text.trim()) {
                return Ok(Some(WordOr::Word(word)));
            }
            if !text.trim_start().starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
                let suggestion = nearest(text, words.iter().copied());
                return Err(self.error(key, Problem::Word { suggestion, expected }));
            }
        }
        to_quantity(value, dimension).map(|q| Some(WordOr::Quantity(q))).map_err(|p| self.error(key, p))
    }
}

/// What [`Section::word_or_quantity`] found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WordOr {
    /// One of the words.
    Word(&'static str),
    /// A quantity in the unit used inside.
    Quantity(f64),
}

fn syntax(text: &str, error: &TomlError) -> FileError {
    let message = shortened(error.message());
    let Some(span) = error.span() else {
        return FileError::new(Problem::Said(format!("not valid TOML: {message} in ``")));
    };
    let start = text.get(..span.start).map_or(0, |t| t.rfind('\n').map_or(0, |i| i + 1));
    let line = text.get(start..).and_then(|t| t.lines().next()).unwrap_or("");
    let value = line.split_once('=').map_or("", |(_, v)| v.trim_start());
    let unquoted = value.starts_with(|c: char| c.is_ascii_digit() || c == '-')
        && value.split('#').next().is_some_and(|v| v.contains(char::is_alphabetic) && !v.contains('"'));
    let line = shortened(line);
    let hint = if unquoted { " (write a quantity with a unit in quotes: \"30 mm\")" } else { "" };
    FileError::new(Problem::Said(format!("not valid TOML: {message} in `{line}`{hint}")))
        .at(Some(place(text, span.start)))
}
