//! What is wrong with a file, where, and what is expected there.

use crate::muscle::MuscleError;
use std::{fmt, path::PathBuf};

/// A position in a text, both counted from 1; columns count characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TextPosition {
    /// Line.
    pub line: usize,
    /// Column.
    pub column: usize,
}

/// Why a text is not such a file: the file, the place, the key, what stood there, and what is wrong
/// with it.
#[derive(Debug, Default)]
pub struct FileError {
    /// The file, where the text came from one.
    pub file: Option<PathBuf>,
    /// Its place.
    #[doc(hidden)]
    pub place: Option<TextPosition>,
    /// Dotted key, such as `tube.wall_thickness`.
    pub key: Option<String>,
    /// What stood there, as written (long texts are cut).
    pub written: Option<String>,
    /// What is wrong, in a sentence that the key is before.
    pub problem: String,
}

/// `tube.wall_thickness is -3 mm; …` → `is -3 mm; …`: the key, or the table it belongs to, is in
/// front already.
pub fn without_key(error: &MuscleError, key: &str) -> String {
    let message = error.to_string();
    let table = key.rsplit_once('.').map(|(table, _)| format!("{table}: "));
    [format!("{key} "), format!("{key}: ")]
        .iter()
        .chain(&table)
        .find_map(|k| message.strip_prefix(k.as_str()))
        .unwrap_or(&message)
        .to_string()
}

impl FileError {
    pub(super) fn new(problem: impl Into<String>) -> Self {
        Self {
            problem: problem.into(),
            ..Self::default()
        }
    }

    /// The same error with its file.
    #[must_use]
    pub fn in_file(mut self, file: &std::path::Path) -> Self {
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
        f.write_str(&self.problem)
    }
}

impl std::error::Error for FileError {}
