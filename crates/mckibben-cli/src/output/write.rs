//! Where results go: standard output, or a file that appears whole or not at all.

use crate::failure::Failure;
use anstyle::{AnsiColor, Style};
use std::io::Write;
use std::path::Path;

/// Writes to `path`, or to standard output.
pub fn emit(bytes: impl AsRef<[u8]>, path: Option<&Path>) -> Result<(), Failure> {
    match path {
        Some(path) => save(path, bytes.as_ref()),
        None => {
            let mut out = std::io::stdout().lock();
            out.write_all(bytes.as_ref()).and_then(|()| out.flush()).map_err(|e| Failure::stdout(&e))
        }
    }
}

/// Style of the word before an error, a warning, a hint.
const ERROR: Style = AnsiColor::Red.on_default().bold();
const WARNING: Style = AnsiColor::Yellow.on_default().bold();
const HINT: Style = AnsiColor::Cyan.on_default();

/// A line for the user beside the result; nothing better can be done if nobody can read it.
pub fn warn(message: impl std::fmt::Display) {
    let _ = writeln!(anstream::stderr(), "{WARNING}warning:{WARNING:#} {message}");
}

/// What went wrong, in colour where the terminal shows it and nobody asked for none (`NO_COLOR`).
pub fn complain(text: &str) {
    let styled =
        |text: String, word: &str, style: Style| text.replacen(word, &format!("{style}{word}{style:#}"), 1);
    let text = styled(text.to_owned(), "error:", ERROR);
    let _ = writeln!(anstream::stderr(), "{}", styled(text, "\n  hint:", HINT));
}

/// Whether standard output shows colours.
pub fn colour() -> bool {
    anstream::AutoStream::choice(&std::io::stdout()) != anstream::ColorChoice::Never
}

/// Writes a file that appears whole or not at all.
pub fn save(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    mckibben_files::replace(path, bytes).map_err(|e| Failure::unwritable(path, &e))
}
