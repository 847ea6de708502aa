//! The table of rubbers, from TOML.

use super::{entry::RubberEntry, error::LibraryError};
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Deserialize)]
struct Table {
    sources: BTreeMap<String, Origin>,
    rubber: Vec<RubberEntry>,
}

/// A row of `[sources]`.
#[derive(Deserialize)]
struct Origin {
    citation: String,
    terms: String,
}

pub fn table(text: &str) -> Result<Vec<RubberEntry>, LibraryError> {
    let Table {
        sources,
        mut rubber,
    } = toml_edit::de::from_str(text).map_err(LibraryError::damaged)?;
    for entry in &mut rubber {
        let wrong = |problem: String| LibraryError::damaged(format!("{}: {problem}", entry.name));
        let origin = sources
            .get(&entry.source)
            .ok_or_else(|| wrong(format!("unknown source {}", entry.source)))?;
        if entry.fits.is_empty() {
            return Err(wrong("no fits".into()));
        }
        for fit in &entry.fits {
            fit.law
                .clone()
                .validated()
                .map_err(|e| wrong(e.to_string()))?;
        }
        (entry.source, entry.terms) = (origin.citation.clone(), origin.terms.clone());
    }
    Ok(rubber)
}
