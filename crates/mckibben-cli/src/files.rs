//! Files that users name, read for the application layer.

use mckibben_app::{Model, Problem, TextFile};
use std::path::Path;

/// The formula behind a model's word, where that is the path of one and not the name of a model.
pub fn formula(word: &str) -> Result<Option<TextFile>, Problem> {
    let word = word.trim();
    let path = Path::new(word);
    let is_file =
        word.to_ascii_lowercase().ends_with(".json") || (!Model::is_taken(word) && path.is_file());
    is_file.then(|| TextFile::formula(path)).transpose()
}
