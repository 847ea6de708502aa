//! Files that users name, read for the application layer.

use crate::failure::Failure;
use mckibben::muscle::file::read_text;
use mckibben::table::{self, TableError};
use mckibben_app::{Model, Problem, ProblemKind, TextFile};
use std::fs::File;
use std::path::Path;

/// A file written by hand: a muscle, a plan.
pub fn text(path: &Path) -> Result<TextFile, Failure> {
    let text = read_text(path).map_err(|e| Problem::from(e.of(path)))?;
    Ok(TextFile { name: path.display().to_string(), text })
}

/// A table, whatever program wrote it. Such files may be long.
pub fn table(path: &Path) -> Result<TextFile, Failure> {
    let meta = std::fs::metadata(path).map_err(|e| Failure::unreadable(path, e))?;
    if !meta.is_file() {
        let message = format!("{} is not a file", path.display());
        return Err(Failure::input(ProblemKind::File, message, "give a CSV file"));
    }
    let file = File::open(path).map_err(|e| Failure::unreadable(path, e))?;
    let text = table::read_text(file).map_err(|error| match error {
        TableError::Io(error) => Failure::unreadable(path, error),
        error => Problem::of_table(&path.display().to_string(), &error).into(),
    })?;
    Ok(TextFile { name: path.display().to_string(), text })
}

/// The formula behind a model's word, where that is the path of one and not the name of a model.
pub fn formula(word: &str) -> Result<Option<TextFile>, Failure> {
    let word = word.trim();
    let path = Path::new(word);
    if word.to_ascii_lowercase().ends_with(".json") || (!Model::is_taken(word) && path.is_file()) {
        let text = std::fs::read_to_string(path)
            .map_err(|e| Failure::input(ProblemKind::Formula, format!("{word}: cannot be read: {e}"), ""))?;
        return Ok(Some(TextFile { name: word.into(), text }));
    }
    Ok(None)
}
