//! Where results go: standard output, or a file that appears whole or not at all.

use super::guard::{Content, check};
use super::target::Target;
use super::width;
use crate::clean;
use crate::failure::{Failure, in_flags};
use crate::shown;
use anstyle::{AnsiColor, Style};
use mckibben::units::short_numbers;
use mckibben::warning::is_of_burst;
use mckibben_app::BuiltFile;
use mckibben_files::Unfinished;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Writes all files of an answer into a folder, or none if one of them would be lost for it. `content` says by the name of a file what it is.
pub fn save_all(
    files: &[BuiltFile],
    folder: &Path,
    overwrite: bool,
    content: impl Fn(&str) -> Content,
) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|e| Failure::unwritable(folder, &e))?;
    let paths: Vec<PathBuf> = files.iter().map(|file| folder.join(&file.name)).collect();
    for (file, path) in files.iter().zip(&paths) {
        check(Target::file(path, overwrite), &content(&file.name))?;
    }
    let mut whole = vec![];
    for (file, path) in files.iter().zip(&paths) {
        let written = Unfinished::beside(path).and_then(|mut beside| {
            beside.file().write_all(&file.content)?;
            Ok(beside)
        });
        whole.push(written.map_err(|e| Failure::unwritable(path, &e))?);
    }
    let put =
        |(file, path): (Unfinished, &PathBuf)| file.put(true).map_err(|e| Failure::unwritable(path, &e));
    whole.into_iter().zip(&paths).try_for_each(put)
}

/// Writes to `path`, or to standard output.
pub fn emit(bytes: impl AsRef<[u8]>, path: Option<&Path>) -> Result<(), Failure> {
    match path {
        Some(path) => put(path, bytes.as_ref()),
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

/// A line for the user beside the result, in the units that he reads; nothing better can be done if nobody can read it.
pub fn warn(message: impl std::fmt::Display) {
    let message = in_flags(&message.to_string());
    let text = shown::sentence(&message);
    let text = short_numbers(&text);
    let text = width::broken_aside(&format!("warning: {}", clean::line(&text)));
    let text = text.strip_prefix("warning:").unwrap_or(&text);
    let _ = writeln!(anstream::stderr(), "{WARNING}warning:{WARNING:#}{text}");
}

/// Warnings that are printed behind the text.
static BEHIND: Mutex<Vec<String>> = Mutex::new(vec![]);

/// Prints what was left for behind the text.
pub fn warn_behind() {
    let mut list = BEHIND.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    list.drain(..).for_each(warn);
}

/// Warnings in the place where they are read: those of the burst pressure as the first lines of the text, which come back, with the others
/// behind it; without them the others before it.
pub fn burst_first(warnings: &[impl std::fmt::Display]) -> String {
    let all = warnings.iter().map(ToString::to_string);
    let (first, others): (Vec<String>, Vec<String>) = all.partition(|w| is_of_burst(w));
    if first.is_empty() {
        others.into_iter().for_each(warn);
        return String::new();
    }
    BEHIND.lock().unwrap_or_else(std::sync::PoisonError::into_inner).extend(others);
    shown::sentence(&first.join("\n")).into_owned() + "\n\n"
}

/// What went wrong, in colour where the terminal shows it and nobody asked for none (`NO_COLOR`).
pub fn complain(text: &str) {
    let styled =
        |text: String, word: &str, style: Style| text.replacen(word, &format!("{style}{word}{style:#}"), 1);
    let text = styled(width::broken_aside(text), "error:", ERROR);
    let _ = writeln!(anstream::stderr(), "{}", styled(text, "\n  hint:", HINT));
}

/// Writes a file of some content in the place of one that may be lost.
pub fn save(target: Target<'_>, content: Content, bytes: &[u8]) -> Result<(), Failure> {
    check(target, &content)?;
    target.path.map_or(Ok(()), |path| put(path, bytes))
}

/// Writes a file that appears whole or not at all.
fn put(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    mckibben_files::replace(path, bytes).map_err(|e| Failure::unwritable(path, &e))
}
