//! What is wrong with a muscle file, where, and what should stand there.

use crate::muscle::MuscleError;
use crate::nearest::meant;
use crate::units::QuantityError;
use std::borrow::Cow;
use std::fmt;
use std::path::PathBuf;
use thiserror::Error;

/// A position in a text, both counted from 1; columns count characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TextPosition {
    /// Line.
    pub line: usize,
    /// Column.
    pub column: usize,
}

/// Why a text is not a muscle: the file, the place, the key, what stood there, and what is wrong with it.
#[derive(Debug)]
pub struct FileError {
    /// The file, where the text came from one.
    pub file: Option<PathBuf>,
    /// Where it stands.
    pub place: Option<TextPosition>,
    /// Dotted key, such as `tube.wall_thickness`.
    pub key: Option<String>,
    /// What stood there, as written (long texts are cut).
    pub written: Option<String>,
    /// What is wrong.
    pub problem: Box<Problem>,
}

/// What is wrong.
#[derive(Debug, Error)]
pub enum Problem {
    /// The file is not read.
    #[error("{0}")]
    Unread(#[source] mckibben_io::files::ReadError),
    /// A value of another kind.
    #[error("is {found}; expected {expected}")]
    Type {
        /// What it is.
        found: &'static str,
        /// What it should be.
        expected: &'static str,
    },
    /// A text that is not the quantity asked for.
    #[error("{}", without_subject(.0))]
    Quantity(#[source] QuantityError),
    /// Anything else, in a sentence that the key is before.
    #[error("{0}")]
    Said(String),
    /// A word that is not one of those known.
    #[error("is not known{}; expected {expected}", meant(*.suggestion))]
    Word {
        /// The word that was probably meant.
        suggestion: Option<&'static str>,
        /// What may stand here.
        expected: &'static str,
    },
    /// Something that is required together with the given key.
    #[error("{missing} is missing; {needs}")]
    Missing {
        /// Key that is missing.
        missing: String,
        /// Why it is needed.
        needs: Cow<'static, str>,
    },
    /// Parts that make no muscle.
    #[error(
        "{}{}",
        without_key(.error, .key),
        .default.as_ref().map_or_else(String::new, |key| format!("; {key} is not written, so this is its default"))
    )]
    Muscle {
        /// What the muscle says.
        #[source]
        error: MuscleError,
        /// The key it is reported under.
        key: String,
        /// A key that has a part in it and was left out.
        default: Option<String>,
    },
}

/// `"30 bar" is a pressure` → `is a pressure`: the text is in front already.
fn without_subject(error: &QuantityError) -> String {
    let message = error.to_string();
    match error {
        QuantityError::NotANumber { text, .. }
        | QuantityError::Comma { text, .. }
        | QuantityError::NotFinite { text, .. }
        | QuantityError::Beyond { text, .. }
        | QuantityError::WrongDimension { text, .. } => {
            message.strip_prefix(&format!("\"{text}\" ")).unwrap_or(&message).to_string()
        }
        QuantityError::UnknownUnit { text, .. } => message.replacen(&format!(" in \"{text}\""), "", 1),
        QuantityError::Empty { .. } => message,
    }
}

/// `tube.wall_thickness is -3 mm; …` → `is -3 mm; …`: the key, or the table it belongs to, is in front already.
fn without_key(error: &MuscleError, key: &str) -> String {
    let message = error.to_string();
    let table = key.rsplit_once('.').map(|(table, _)| format!("{table}: "));
    let key = [format!("{key} "), format!("{key}: ")];
    let rest = key.iter().chain(&table).find_map(|k| message.strip_prefix(k.as_str()));
    rest.unwrap_or(&message).to_string()
}

impl FileError {
    pub(super) fn new(problem: Problem) -> Self {
        Self { file: None, place: None, key: None, written: None, problem: Box::new(problem) }
    }

    pub(super) fn at(mut self, place: Option<TextPosition>) -> Self {
        self.place = place;
        self
    }

    pub(super) fn under(mut self, key: impl Into<String>, written: Option<String>) -> Self {
        self.key = Some(key.into());
        self.written = written;
        self
    }

    /// The same error with its file.
    pub fn of(mut self, file: &std::path::Path) -> Self {
        self.file = Some(file.into());
        self
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.file, &self.place) {
            (Some(file), Some(p)) => write!(f, "{}:{}:{}: ", file.display(), p.line, p.column)?,
            (Some(file), None) => write!(f, "{}: ", file.display())?,
            (None, Some(p)) => write!(f, "line {}, column {}: ", p.line, p.column)?,
            (None, None) => {}
        }
        match (&self.key, &self.written) {
            (Some(key), Some(written)) => write!(f, "{key} = {written}: ")?,
            (Some(key), None) if !key.is_empty() => write!(f, "{key}: ")?,
            _ => {}
        }
        write!(f, "{}", self.problem)
    }
}

impl std::error::Error for FileError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        std::error::Error::source(self.problem.as_ref())
    }
}
