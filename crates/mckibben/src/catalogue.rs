//! Tables of parts in TOML: `[[rubber]]`, `[[sleeve]]`, `[[tube]]`, `[[valve]]`, and the
//! `[sources]` that their rows name.

use crate::nearest::{meant, nearest};
use thiserror::Error;
use toml_edit::{Array, Document, Item, Table, TableLike, Value};

/// Why a table of parts cannot be read: it is not TOML, or a row lacks a key or has a value that
/// the key may not have.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{0}")]
pub struct CatalogueError(String);

/// A table of parts.
pub struct Catalogue<'t>(Document<&'t str>);

impl<'t> Catalogue<'t> {
    /// A table from its text.
    pub fn parse(text: &'t str) -> Result<Self, CatalogueError> {
        Document::parse(text)
            .map(Self)
            .map_err(|e| CatalogueError(e.to_string()))
    }

    /// Refuses a table without rows of these kinds, and what a row of a kind, or the table beside
    /// its `[sources]`, does not have.
    pub fn check(&self, kinds: &[(&str, &str)]) -> Result<(), CatalogueError> {
        let unknown = |what: &str, key: &str, known: &[&str]| {
            let meant = meant(nearest(key, known.iter().copied()));
            Err(CatalogueError(format!(
                "{what}: unknown key {key}{meant}; known here: {}",
                known.join(", ")
            )))
        };
        let names: Vec<&str> = kinds.iter().map(|k| k.0).chain(["sources"]).collect();
        if let Some((key, _)) = self.0.iter().find(|(key, _)| !names.contains(key)) {
            return unknown("the table", key, &names);
        }
        for (kind, known) in kinds {
            let known: Vec<&str> = known.split_whitespace().collect();
            for row in self.rows(kind) {
                if let Some((key, _)) = row.table.iter().find(|(key, _)| !known.contains(key)) {
                    return unknown(row.optional("name").unwrap_or(kind), key, &known);
                }
            }
        }
        if kinds.iter().all(|(kind, _)| self.rows(kind).is_empty()) {
            let names: Vec<String> = kinds
                .iter()
                .map(|(kind, _)| format!("[[{kind}]]"))
                .collect();
            return Err(CatalogueError(format!(
                "there is no row; a row begins with {}",
                names.join(" or ")
            )));
        }
        Ok(())
    }

    /// The rows of a kind, `[[kind]]`; none where there is no such key.
    pub fn rows(&self, kind: &str) -> Vec<Row<'_>> {
        let tables = self
            .0
            .get(kind)
            .and_then(Item::as_array_of_tables)
            .into_iter()
            .flatten();
        tables.map(|table| self.row(table)).collect()
    }

    fn row<'a>(&'a self, table: &'a dyn TableLike) -> Row<'a> {
        Row {
            table,
            sources: self.0.get("sources").and_then(Item::as_table),
        }
    }
}

/// A name as tables of parts write it: without regard to case; spaces and underscores are as good
/// as hyphens.
pub fn plain(name: &str) -> String {
    name.trim().to_lowercase().replace([' ', '_'], "-")
}

/// The part of a name or alias; else that there is none, with the nearest name or all of them.
pub fn named<'a, T>(
    kind: &str,
    parts: &'a [T],
    names: impl Fn(&'a T) -> (&'a str, &'a [String]),
    name: &str,
) -> Result<&'a T, String> {
    let sought = plain(name);
    let part = parts
        .iter()
        .find(|part| names(part).0 == sought || names(part).1.contains(&sought));
    part.ok_or_else(|| {
        let all = parts.iter().map(&names);
        let spellings = all
            .clone()
            .flat_map(|(name, also)| also.iter().map(String::as_str).chain([name]));
        let given: String = name.chars().take(60).collect();
        let known = match nearest(&sought, spellings) {
            None => format!(
                "; known: {}",
                all.map(|names| names.0).collect::<Vec<_>>().join(", ")
            ),
            near => meant(near),
        };
        format!("there is no {kind} named \"{given}\"{known}")
    })
}

/// A row of a table of parts.
#[derive(Clone, Copy)]
pub struct Row<'a> {
    table: &'a dyn TableLike,
    sources: Option<&'a Table>,
}

impl<'a> Row<'a> {
    /// What is wrong with this row.
    pub fn wrong(&self, problem: impl Into<String>) -> CatalogueError {
        let name = self.optional("name").unwrap_or("a row without a name");
        CatalogueError(format!("{name}: {}", problem.into()))
    }

    /// A text that must be there.
    pub fn text(&self, key: &str) -> Result<&'a str, CatalogueError> {
        self.optional(key)
            .ok_or_else(|| self.wrong(format!("`{key}` is missing or not a text")))
    }

    /// A text, where the key is there.
    pub fn optional(&self, key: &str) -> Option<&'a str> {
        self.table.get(key).and_then(Item::as_str)
    }

    /// The same, for a record that keeps it.
    pub fn owned(&self, key: &str) -> Option<String> {
        self.optional(key).map(str::to_owned)
    }

    /// Whether a key says `true`.
    pub fn flag(&self, key: &str) -> bool {
        self.table.get(key).and_then(Item::as_bool).unwrap_or(false)
    }

    /// A number above zero, where the key is there.
    pub fn number(&self, key: &str) -> Result<Option<f64>, CatalogueError> {
        let Some(item) = self.table.get(key) else {
            return Ok(None);
        };
        let value = item.as_value().and_then(above_zero);
        value
            .map(Some)
            .ok_or_else(|| self.wrong(format!("`{key}` must be a number above zero")))
    }

    /// A number above zero that must be there.
    pub fn needed(&self, key: &str) -> Result<f64, CatalogueError> {
        self.number(key)?
            .ok_or_else(|| self.wrong(format!("`{key}` is missing")))
    }

    /// A count above zero, where the key is there.
    pub fn count(&self, key: &str) -> Result<Option<u32>, CatalogueError> {
        let Some(item) = self.table.get(key) else {
            return Ok(None);
        };
        let value = item
            .as_integer()
            .and_then(|i| u32::try_from(i).ok())
            .filter(|n| *n > 0);
        value
            .map(Some)
            .ok_or_else(|| self.wrong(format!("`{key}` must be a count above zero")))
    }

    /// A list; empty where there is none.
    pub fn list(&self, key: &str) -> impl Iterator<Item = &'a Value> + use<'a> {
        self.table
            .get(key)
            .and_then(Item::as_array)
            .map(Array::iter)
            .into_iter()
            .flatten()
    }

    /// The texts of a list.
    pub fn texts(&self, key: &str) -> Vec<String> {
        self.list(key)
            .filter_map(Value::as_str)
            .map(str::to_owned)
            .collect()
    }

    /// The numbers above zero of a list.
    pub fn numbers(&self, key: &str) -> Result<Vec<f64>, CatalogueError> {
        let one = |v| {
            above_zero(v).ok_or_else(|| self.wrong(format!("`{key}` must be numbers above zero")))
        };
        self.list(key).map(one).collect()
    }

    /// The row of `[sources]` that this row names.
    pub fn source(&self) -> Result<Row<'a>, CatalogueError> {
        let key = self.text("source")?;
        let table = self
            .sources
            .and_then(|s| s.get(key))
            .and_then(Item::as_table_like);
        let table = table.ok_or_else(|| self.wrong(format!("unknown source {key}")))?;
        Ok(Row {
            table,
            sources: self.sources,
        })
    }

    /// Where `[sources]` are texts: that which this row names, or what the row itself says.
    pub fn source_text(&self) -> &'a str {
        let key = self.optional("source").unwrap_or("not stated");
        self.sources
            .and_then(|s| s.get(key)?.as_str())
            .unwrap_or(key)
    }
}

fn above_zero(value: &Value) -> Option<f64> {
    let number = value
        .as_float()
        .or_else(|| value.as_integer().map(|i| i as f64));
    number.filter(|v| v.is_finite() && *v > 0.0)
}
