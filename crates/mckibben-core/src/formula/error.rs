//! Why a file is no formula.

use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why a file is no formula, with its name.
#[derive(Debug, Clone, Error)]
#[error("{}{problem}", .file.as_ref().map_or_else(String::new, |f| format!("{}: ", f.display())))]
pub struct FormulaError {
    /// The file, where it is one.
    pub file: Option<PathBuf>,
    /// What is wrong.
    pub problem: String,
}

impl FormulaError {
    pub(super) fn new(problem: impl Into<String>) -> Self {
        Self {
            file: None,
            problem: problem.into(),
        }
    }

    /// It is no JSON.
    pub(super) fn json(error: impl std::fmt::Display) -> Self {
        Self::new(format!(
            "is not valid JSON: {error} (JSON has no NaN; a file that ends early is truncated)"
        ))
    }

    pub(super) fn missing(key: &str) -> Self {
        Self::new(format!("the key `{key}` is missing"))
    }

    pub(super) fn unknown(key: &str, given: &str, known: &str) -> Self {
        Self::new(format!("`{key}` is `{given}`; expected one of {known}"))
    }

    pub(super) fn twice(term: &str) -> Self {
        Self::new(format!("`terms`: the term {term} is given twice"))
    }

    /// What serde says of the value at a path.
    pub(super) fn at_path(path: &str, error: &serde_json::Error) -> Self {
        if !error.is_data() {
            return Self::json(error);
        }
        let mut message = error.to_string();
        let missing = message
            .strip_prefix("missing field `")
            .and_then(|rest| rest.split_once('`'));
        if let Some((key, _)) = missing {
            let key = if path == "." {
                key.to_owned()
            } else {
                format!("{path}.{key}")
            };
            return Self::missing(&key);
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
        let key = if path == "." {
            "the file".into()
        } else {
            path.to_owned()
        };
        Self::new(format!("`{key}`: {message}"))
    }
    /// The same error, in a file of this name.
    #[must_use]
    pub fn in_file(mut self, path: &Path) -> Self {
        self.file = Some(path.to_owned());
        self
    }
}
