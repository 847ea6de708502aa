//! Where results go: standard output, or a file that appears whole or not at all. An existing file is overwritten only with `--overwrite`.

use super::width;
use crate::asked::Asked;
use crate::failure::{Failure, in_flags};
use crate::{clean, progress, shown};
use anstyle::{AnsiColor, Style};
use mckibben::units::short_numbers;
use mckibben::warning::is_of_burst;
use mckibben_app::{BuiltFile, ProblemKind};
use mckibben_io::files::Unfinished;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether existing files are overwritten.
static OVERWRITE: AtomicBool = AtomicBool::new(false);

/// Flags that name files that are written.
const WRITTEN: [&str; 5] = ["output", "plot", "plot_data", "alone", "export_inp"];

pub fn overwrite() -> bool {
    OVERWRITE.load(Ordering::Relaxed)
}

/// Refuses a command line that names an existing file for a result, before any work is done for it. A campaign goes on with its own file.
pub fn check_named(asked: &Asked, command: &str, overwrite: bool) -> Result<(), Failure> {
    OVERWRITE.store(overwrite, Ordering::Relaxed);
    let written = WRITTEN.iter().filter(|flag| **flag != "output" || command != "campaign");
    written.filter_map(|flag| asked.path(flag)).try_for_each(|path| check(&path))
}

/// Refuses to write what is no answer, and to overwrite a file.
pub fn check(path: &Path) -> Result<(), Failure> {
    progress::ended()?;
    // What is no regular file is written in place, or refused when it is written.
    if !path.is_file() {
        return Ok(());
    }
    mckibben_io::files::check_writable(path).map_err(|e| Failure::unwritable(path, &e))?;
    if overwrite() {
        return Ok(());
    }
    let message = format!("{} exists and would be overwritten", path.display());
    Err(Failure::input(ProblemKind::Output, message, "name another file, or replace it with --overwrite"))
}

/// The ending of a name in lower case.
pub fn ending(path: &Path) -> Option<String> {
    path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase())
}

/// Refuses a name whose ending promises another format than the one that is written.
pub fn check_ending(path: Option<&Path>, endings: &[&str]) -> Result<(), Failure> {
    let Some((path, ending)) = path.and_then(|path| Some((path, ending(path)?))) else { return Ok(()) };
    if endings.contains(&ending.as_str()) {
        return Ok(());
    }
    let message = format!("{} ends in .{ending}, which is another format", path.display());
    Err(Failure::input(ProblemKind::Output, message, format!("end it in .{}", endings.join(" or ."))))
}

/// Writes all files of an answer into a folder, or none if one of them exists.
pub fn save_all(files: &[BuiltFile], folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|e| Failure::unwritable(folder, &e))?;
    let at = |file: &BuiltFile| folder.join(&file.name);
    // A file that is there already as it would be written is left.
    let is_there = |file: &&BuiltFile| {
        let limit = file.content.len() as u64;
        mckibben_io::files::read(&at(file), limit).is_ok_and(|there| there == file.content)
    };
    let files: Vec<&BuiltFile> = files.iter().filter(|file| !is_there(file)).collect();
    let paths: Vec<PathBuf> = files.iter().map(|file| at(file)).collect();
    paths.iter().try_for_each(|path| check(path))?;
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
    if path.is_some() {
        return save(path, bytes.as_ref());
    }
    let mut out = std::io::stdout().lock();
    out.write_all(bytes.as_ref()).and_then(|()| out.flush()).map_err(|e| Failure::stdout(&e))
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

/// Writes a file, where one is named.
pub fn save(path: Option<&Path>, bytes: &[u8]) -> Result<(), Failure> {
    let Some(path) = path else { return Ok(()) };
    check(path)?;
    put(path, bytes)
}

/// Writes a file that appears whole or not at all, in the place of an older one.
pub fn put(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    mckibben_io::files::replace(path, bytes).map_err(|e| Failure::unwritable(path, &e))
}
