//! Files of parts in TOML: `[[tube]]`, `[[cast]]`, `[[sleeve]]`, and the `[sources]` that their
//! rows name.

use crate::{
    joined,
    muscle::file::{FileError, Source},
    nearest::{meant, nearest},
    sleeve::SleeveRow,
    units::{Positive, typed::Length},
};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A file of parts: those of the program, or of a user's own.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct PartsFile {
    /// Tubes as sold or cast
    pub tube: Vec<TubeRow>,
    /// Tubes of silicone, cast between a rod and a pipe: each bore with each wall
    pub cast: Vec<CastRow>,
    /// Braided sleeves
    pub sleeve: Vec<SleeveRow>,
    /// Where figures come from
    pub sources: Sources,
}

/// A tube.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TubeRow {
    /// Its name
    pub name: String,
    /// Inner diameter
    pub inner: Positive<Length>,
    /// Outer diameter
    pub outer: Positive<Length>,
    /// Name of a rubber, or of a data sheet such as "shore:35A:natural"
    pub rubber: String,
    /// Whether it is cast, not bought
    #[serde(default)]
    pub cast: bool,
    /// Its price, where one was seen
    pub price: Option<String>,
    /// Largest pressure in MPa that its source names
    pub pressure_mpa: Option<Positive<f64>>,
    /// What else one should know
    pub note: Option<String>,
    /// Where the figures come from: a key of `[sources]`, or a text
    pub source: Option<String>,
}

/// Tubes that one can cast.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CastRow {
    /// Bores as rods are sold
    pub bores: Vec<Positive<Length>>,
    /// Walls
    pub walls: Vec<Positive<Length>>,
    /// Names of rubbers
    pub rubbers: Vec<String>,
    /// Where the figures come from: a key of `[sources]`, or a text
    pub source: Option<String>,
}

/// Where figures come from, by the names that rows give.
#[derive(Debug, Default, Deserialize, JsonSchema)]
pub struct Sources(BTreeMap<String, Origin>);

/// A source.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "must be a text, or a table of citation and terms"
)]
enum Origin {
    Text(String),
    WithTerms { citation: String, terms: String },
}

impl Sources {
    /// The source that a row names, or what the row itself says; and the terms of its use.
    pub fn source_and_terms<'s>(&'s self, source: Option<&'s str>) -> (&'s str, &'s str) {
        const NOT_STATED: &str = "not stated";
        let name = source.unwrap_or(NOT_STATED);
        match self.0.get(name) {
            Some(Origin::WithTerms { citation, terms }) => (citation, terms),
            Some(Origin::Text(text)) => (text, NOT_STATED),
            None => (name, NOT_STATED),
        }
    }
}

impl PartsFile {
    /// Reads the text of a file of parts.
    ///
    /// # Errors
    /// [`FileError`] with line, column, key, what stood there and what is expected.
    pub fn parse(text: &str) -> Result<Self, FileError> {
        let source = Source::parse(text)?;
        let file: Self = source.read()?;
        if file.tube.is_empty() && file.cast.is_empty() && file.sleeve.is_empty() {
            return Err(source.error(
                "",
                "there is no row; a row begins with [[tube]] or [[cast]] or [[sleeve]]",
            ));
        }
        Ok(file)
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
    parts
        .iter()
        .find(|part| names(part).0 == sought || names(part).1.contains(&sought))
        .ok_or_else(|| {
            let all = parts.iter().map(&names);
            let spellings = all
                .clone()
                .flat_map(|(name, also)| also.iter().map(String::as_str).chain([name]));
            let known = match nearest(&sought, spellings) {
                None => format!("; known: {}", joined(all.map(|names| names.0), ", ")),
                near => meant(near),
            };
            format!("there is no {kind} named \"{name:.60}\"{known}")
        })
}
