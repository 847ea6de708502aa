//! Why a file is no formula.

use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why a file is no formula, with its name.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{}{problem}", .file.as_ref().map_or_else(String::new, |f| format!("{}: ", f.display())))]
pub struct FormulaError {
    /// The file, where it is one.
    pub file: Option<PathBuf>,
    /// What is wrong.
    pub problem: Problem,
}

/// What is wrong with a formula's file.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Problem {
    /// It cannot be read.
    #[error("cannot be read: {0}")]
    Unreadable(String),
    /// It is no JSON.
    #[error("is no JSON: {0} (JSON knows no NaN; a file that ends early is truncated)")]
    Json(String),
    /// A key is missing.
    #[error("the key `{key}` is missing")]
    Missing {
        /// Which.
        key: String,
    },
    /// A value of another sort.
    #[error("`{key}` must be {expected}, it is {found}")]
    Expected {
        /// Which key.
        key: String,
        /// What it must be.
        expected: String,
        /// What stands there, shortened.
        found: String,
    },
    /// A word that is none of those known.
    #[error("`{key}` says `{given}`, which is none of {known}")]
    Unknown {
        /// Which key.
        key: String,
        /// What stands there.
        given: String,
        /// What may stand there.
        known: String,
    },
    /// A term that stands twice.
    #[error("`{key}`: the term {term} stands there twice")]
    Twice {
        /// Which key.
        key: String,
        /// Which term.
        term: String,
    },
}

impl FormulaError {
    pub(super) fn unreadable(error: &std::io::Error) -> Self {
        Problem::Unreadable(error.to_string()).into()
    }

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
