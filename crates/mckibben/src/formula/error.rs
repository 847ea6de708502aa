//! Why a file is no formula.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use thiserror::Error;

/// Why a file is no formula, with its name.
#[derive(Debug, Clone, Error)]
#[error("{}{problem}", .file.as_ref().map_or_else(String::new, |f| format!("{}: ", f.display())))]
pub struct FormulaError {
    /// The file, where it is one.
    pub file: Option<PathBuf>,
    /// What is wrong.
    pub problem: Problem,
}

/// What is wrong with a formula's file.
#[derive(Debug, Clone, Error)]
pub enum Problem {
    /// It is not read.
    #[error("{0}")]
    Unread(Arc<mckibben_io::files::ReadError>),
    /// It is no JSON.
    #[error("is not valid JSON: {0} (JSON has no NaN; a file that ends early is truncated)")]
    Json(String),
    /// A key is missing.
    #[error("the key `{key}` is missing")]
    Missing {
        /// Which.
        key: String,
    },
    /// A value that is not what belongs there.
    #[error("`{key}`: {message}")]
    Wrong {
        /// Which key.
        key: String,
        /// What is wrong, and where in the text.
        message: String,
    },
    /// A word that is none of those known.
    #[error("`{key}` is `{given}`; expected one of {known}")]
    Unknown {
        /// Which key.
        key: String,
        /// The value in the file.
        given: String,
        /// What may stand there.
        known: String,
    },
    /// A term that stands twice.
    #[error("`terms`: the term {term} is given twice")]
    Twice {
        /// Which term.
        term: String,
    },
}

impl Problem {
    /// What serde says of the value at a path.
    pub(super) fn of(path: &str, error: &serde_json::Error) -> Self {
        if !error.is_data() {
            return Self::Json(error.to_string());
        }
        let mut message = error.to_string();
        let missing = message.strip_prefix("missing field `").and_then(|rest| rest.split_once('`'));
        if let Some((key, _)) = missing {
            let key = if path == "." { key.to_owned() } else { format!("{path}.{key}") };
            return Self::Missing { key };
        }
        // Words of the language this is written in, in those of its users.
        for (theirs, ours) in [
            ("f64", "a number"),
            ("usize", "a whole number"),
            ("u64", "a whole number"),
            ("u8", "a whole number"),
        ] {
            message = message.replace(&format!("expected {theirs}"), &format!("expected {ours}"));
        }
        let key = if path == "." { "the file".into() } else { path.to_owned() };
        Self::Wrong { key, message }
    }
}

impl FormulaError {
    /// The same error, in a file of this name.
    pub fn in_file(mut self, path: &Path) -> Self {
        self.file = Some(path.to_owned());
        self
    }
}

impl From<Problem> for FormulaError {
    fn from(problem: Problem) -> Self {
        Self { file: None, problem }
    }
}
