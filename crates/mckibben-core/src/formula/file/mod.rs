//! Formulas as JSON: the types that a file is read into and written from. Keys carry their unit.

pub mod check;
mod head;
mod section;
mod universal;

pub use section::powers;

use super::{Body, Document, Formula, UniversalFormula, error::FormulaError};
use crate::hash;
use head::{Kind, Read, kind};
use section::{GlobalTerm, PaperTerm, SectionFile, global, global_list, paper, paper_list};
use serde::Serialize;
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

/// What stands before the digest of a file, its last key.
const DIGEST: &str = ",\n  \"digest\": \"";

/// The text of a file, with its digest and a newline at the end.
fn text(file: &impl Serialize) -> String {
    // Numbers, texts, lists and objects with texts as keys: nothing that JSON has not.
    let text = serde_json::to_string_pretty(file).unwrap_or_default();
    let text = text.trim_end_matches("\n}");
    format!("{text}{DIGEST}{}\"\n}}\n", hash::hex(text))
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
            Kind::Paper => Self::Section(paper(text)?.into()),
            Kind::Global => Self::Section(global(text)?.into()),
            Kind::Universal => Self::Universal(universal(text)?.into()),
        };
        // A file that was laid out anew has been edited.
        match text.split_once(DIGEST) {
            Some((text, rest)) if !rest.starts_with(&hash::hex(text)) => Err(FormulaError::new(
                "was changed since it was written; if on purpose, leave out its `digest`",
            )),
            _ => Ok(read),
        }
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
