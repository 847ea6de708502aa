//! What every file of a formula has: its format and its kind.

use crate::formula::error::FormulaError;
use serde::{
    Deserialize, Serialize,
    de::{DeserializeOwned, IgnoredAny},
};

#[derive(Serialize, Deserialize, schemars::JsonSchema)]
pub enum Format {
    #[serde(rename = "mckibben formula 1")]
    One,
}

#[derive(Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    Paper,
    Global,
    Universal,
}

/// What every file has.
#[derive(Deserialize)]
#[serde(expecting = "an object")]
struct Head {
    format: Format,
    kind: Kind,
    /// Whatever else there is; with it a list is not taken for an object.
    #[serde(flatten)]
    _rest: IgnoredAny,
}

/// What is read, or why it is no formula.
pub type Read<T> = Result<T, FormulaError>;

/// Reads a text to its end.
pub fn read<T: DeserializeOwned>(text: &str) -> Read<T> {
    let mut source = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut source).map_err(|e| {
        let path = e.path().to_string();
        FormulaError::at_path(&path, e.inner())
    })?;
    source.end().map_err(FormulaError::json)?;
    Ok(value)
}

pub fn kind(text: &str) -> Read<Kind> {
    let Head {
        format: Format::One,
        kind,
        ..
    } = read(text)?;
    Ok(kind)
}
