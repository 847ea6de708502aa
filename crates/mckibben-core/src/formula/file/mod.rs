//! Formulas as JSON: the types that a file is read into and written from. Keys carry their unit.

pub mod check;
mod head;
mod section;
mod universal;

use super::{Body, Document, Formula, UniversalFormula, error::FormulaError};
use head::{Kind, Read, kind};
use section::{GlobalTerm, PaperTerm, SectionFile, global, global_list, paper, paper_list};
use serde::Serialize;
use serde_json::{Map, Value};
use sha2::{Digest, Sha256};
use universal::{UniversalFile, universal};

/// A formula's file.
#[derive(Serialize, schemars::JsonSchema)]
#[serde(untagged)]
pub enum File {
    Paper(SectionFile<PaperTerm>),
    Global(SectionFile<GlobalTerm>),
    Universal(UniversalFile),
}

impl From<Formula> for File {
    fn from(formula: Formula) -> Self {
        match &formula.body {
            Body::Paper(c) => {
                let terms = paper_list(c);
                Self::Paper(formula.file(Kind::Paper, None, terms))
            }
            Body::Global(t) => {
                let scales = Some(t.scales);
                let terms = global_list(t);
                Self::Global(formula.file(Kind::Global, scales, terms))
            }
        }
    }
}

impl From<UniversalFormula> for File {
    fn from(formula: UniversalFormula) -> Self {
        Self::Universal(formula.into())
    }
}

/// The key of the digest of all else in a file.
const DIGEST: &str = "digest";

/// The SHA-256 of what a file holds, however it is laid out.
fn digest(file: &Map<String, Value>) -> String {
    let text = serde_json::to_string(file).unwrap_or_default();
    let bytes = Sha256::digest(text.as_bytes());
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The text of a file, with its digest and a newline at the end.
fn text(file: &impl Serialize) -> String {
    // Numbers, texts, lists and objects with texts as keys: nothing that JSON has not.
    let mut file = serde_json::to_value(file).unwrap_or_default();
    if let Value::Object(keys) = &mut file {
        keys.insert(DIGEST.into(), digest(keys).into());
    }
    format!("{file:#}\n")
}

/// Refuses a file that was changed since it was written and does not say so.
fn check_digest(text: &str) -> Read<()> {
    let Ok(mut keys) = serde_json::from_str::<Map<String, Value>>(text) else {
        return Ok(());
    };
    match keys.shift_remove(DIGEST) {
        Some(given) if given != digest(&keys) => Err(FormulaError::changed(DIGEST)),
        _ => Ok(()),
    }
}

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
    pub fn parse(text: &str) -> Read<Self> {
        let read = match kind(text)? {
            Kind::Paper => Self::Section(paper(text)?),
            Kind::Global => Self::Section(global(text)?),
            Kind::Universal => Self::Universal(universal(text)?),
        };
        check_digest(text)?;
        Ok(read)
    }
}

impl Formula {
    /// The formula as its file holds it, with a newline at the end. Reading it back gives the same
    /// formula to the bit.
    pub fn to_json(&self) -> String {
        text(self)
    }
}

impl UniversalFormula {
    /// A built-in text.
    pub(super) fn built_in(text: &str) -> Read<Self> {
        universal::built_in(text)
    }

    /// The formula as its file holds it, with a newline at the end. Reading it back gives the same
    /// formula to the bit.
    pub fn to_json(&self) -> String {
        text(self)
    }
}
