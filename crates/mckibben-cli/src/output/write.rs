//! Where results go: standard output, or a file that appears whole or not at all.

use crate::failure::Failure;
use std::io::Write;
use std::path::Path;

/// Writes to `path`, or to standard output.
pub fn emit(text: &str, path: Option<&Path>) -> Result<(), Failure> {
    match path {
        Some(path) => save(path, text.as_bytes()),
        None => {
            let mut out = std::io::stdout().lock();
            out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|e| Failure::stdout(&e))
        }
    }
}

/// A line for the user beside the result; nothing better can be done if nobody can read it.
pub fn warn(message: impl std::fmt::Display) {
    let _ = writeln!(std::io::stderr(), "warning: {message}");
}

/// Writes a file that appears whole or not at all.
pub fn save(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    mckibben_files::replace(path, bytes).map_err(|e| Failure::unwritable(path, &e))
}
