//! Formulas as JSON: the types that a file is read into and written from. Keys carry their unit.

pub(super) mod check;
mod section;
mod universal;

use super::error::{FormulaError, Problem};
use super::{Document, Formula, SealState, UniversalFormula, seal};
use section::{GlobalTerm, PaperTerm, SectionFile, global, paper};
use serde::de::{DeserializeOwned, IgnoredAny};
use serde::{Deserialize, Serialize};
use universal::{UniversalFile, universal};

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
enum Format {
    #[serde(rename = "mckibben formula 1")]
    One,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
enum Kind {
    Paper,
    Global,
    Universal,
}

/// What every file has.
#[derive(Debug, Deserialize)]
#[serde(expecting = "an object")]
struct Head {
    format: Format,
    kind: Kind,
    /// Whatever else there is; with it a list is not taken for an object.
    #[serde(flatten)]
    _rest: IgnoredAny,
}

/// A formula's file.
#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) enum File {
    Paper(SectionFile<PaperTerm>),
    Global(SectionFile<GlobalTerm>),
    Universal(UniversalFile),
}

/// The seal of a file that is as it was written.
fn sealed(state: SealState, file: &impl Serialize, check: Option<seal::CheckPoint>) -> Option<seal::Seal> {
    (state == SealState::Sealed).then(|| seal::Seal::of(file, check)).flatten()
}

/// The text of a file, with a newline at the end.
fn text(file: &impl Serialize) -> String {
    // Numbers, texts, lists and objects with texts as keys: nothing that JSON has not.
    serde_json::to_string_pretty(file).unwrap_or_default() + "\n"
}

type Read<T> = Result<T, FormulaError>;

fn read<T: DeserializeOwned>(text: &str) -> Read<T> {
    let mut source = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut source).map_err(|e| {
        let path = e.path().to_string();
        Problem::of(&path, e.inner())
    })?;
    source.end().map_err(|e| Problem::Json(e.to_string()))?;
    Ok(value)
}

fn kind(text: &str) -> Read<Kind> {
    let Head { format: Format::One, kind, .. } = read(text)?;
    Ok(kind)
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Document {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Formula".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        File::json_schema(generator)
    }
}

impl Document {
    /// Reads a text.
    ///
    /// # Errors
    /// [`FormulaError`] names the key.
    pub fn parse(text: &str) -> Read<Self> {
        let mut read = match kind(text)? {
            Kind::Paper => Self::Section(paper(text)?),
            Kind::Global => Self::Section(global(text)?),
            Kind::Universal => Self::Universal(universal(text)?),
        };
        seal::check(text, &mut read)?;
        Ok(read)
    }
}

impl Formula {
    /// Reads a text.
    ///
    /// # Errors
    /// [`FormulaError`] names the key.
    pub fn parse(text: &str) -> Read<Self> {
        match Document::parse(text)? {
            Document::Section(formula) => Ok(formula),
            Document::Universal(_) => Err(other_kind("universal", "paper, global")),
        }
    }

    /// The formula as its file holds it, with a newline at the end. Reading it back gives the same formula to the bit.
    pub fn to_json(&self) -> String {
        text(self)
    }
}

impl UniversalFormula {
    /// A text of our own, whose seal a test compares.
    pub(super) fn built_in(text: &str) -> Read<Self> {
        universal::built_in(text)
    }

    /// Reads a text.
    ///
    /// # Errors
    /// [`FormulaError`] names the key.
    pub fn parse(text: &str) -> Read<Self> {
        match Document::parse(text)? {
            Document::Universal(formula) => Ok(formula),
            Document::Section(f) => Err(other_kind(f.kind(), "universal")),
        }
    }

    /// The formula as its file holds it, with a newline at the end. Reading it back gives the same formula to the bit.
    pub fn to_json(&self) -> String {
        text(self)
    }
}

fn other_kind(given: &str, known: &str) -> FormulaError {
    Problem::Unknown { key: "kind".into(), given: given.into(), known: known.into() }.into()
}
