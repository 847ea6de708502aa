//! Files that users name, read for the application layer.

use mckibben::muscle::file;
use mckibben_app::{Model, PAPER, Problem, TextFile};
use mckibben_fit::validation::library;
use std::path::Path;

/// A file written by hand: a joint, a plan.
pub fn text(path: &Path) -> Result<TextFile, Problem> {
    let text = file::read_text(path).map_err(|e| Problem::from(e.in_file(path)))?;
    Ok(TextFile { name: path.display().to_string(), text })
}

/// A muscle file. `paper` is the paper's muscle, and `lib:NAME` one of the library, where no file has that name.
pub fn muscle(path: &Path) -> Result<TextFile, Problem> {
    let named = path == Path::new(PAPER) || path.to_str().and_then(library::named).is_some();
    if named && !path.exists() {
        return Ok(TextFile { name: path.display().to_string(), text: String::new() });
    }
    text(path)
}

/// A muscle file that another file names: relative to that file, or of the library.
pub fn muscle_beside(folder: &Path, name: &str) -> Result<TextFile, Problem> {
    if library::named(name).is_some() { muscle(Path::new(name)) } else { muscle(&folder.join(name)) }
}

/// The formula behind a model's word, where that is the path of one and not the name of a model.
pub fn formula(word: &str) -> Result<Option<TextFile>, Problem> {
    let word = word.trim();
    let path = Path::new(word);
    if word.to_ascii_lowercase().ends_with(".json") || (!Model::is_taken(word) && path.is_file()) {
        let text = mckibben::formula::read_text(path).map_err(|e| Problem::from(e.in_file(path)))?;
        return Ok(Some(TextFile { name: word.into(), text }));
    }
    Ok(None)
}
