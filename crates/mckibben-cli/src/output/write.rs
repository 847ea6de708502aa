//! Where results go: standard output, or a file that appears whole or not at all. An existing file
//! is overwritten only with `--overwrite`.

use super::width;
use crate::{
    Problem, clean, display_units, progress,
    typed::{self, in_flags},
};
use anstyle::{AnsiColor, Style};
use mckibben_app::{BuiltFile, ProblemKind};
use mckibben_core::{units::short_numbers, warning::is_of_burst};
use mckibben_io::files::{check_free, put, put_all};
use std::{
    io::{Error, ErrorKind, Write},
    path::Path,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
};

/// Whether existing files are overwritten.
static OVERWRITE: AtomicBool = AtomicBool::new(false);

/// Flags that name files that are written.
const WRITTEN: [&str; 4] = ["--output", "--plot", "--report", "--export-inp"];

pub fn overwrite() -> bool {
    OVERWRITE.load(Ordering::Relaxed)
}

/// Refuses a command line that names an existing file for a result, before any work is done for it.
/// A campaign continues its file.
pub fn check_named(continues: bool, overwrite: bool) -> Result<(), Problem> {
    OVERWRITE.store(overwrite, Ordering::Relaxed);
    let written = typed::flags()
        .iter()
        .filter(|flag| WRITTEN.contains(&&*flag.name) && !(continues && flag.name == "--output"));
    let mut paths = written.flat_map(|flag| &flag.texts);
    paths.try_for_each(|(_, path)| check(Path::new(path)))
}

/// Refuses to write what is no answer, and to overwrite a file.
pub fn check(path: &Path) -> Result<(), Problem> {
    progress::ended()?;
    check_free(path, overwrite()).map_err(|e| unwritten(path, &e))
}

/// A result that is not written, for it would overwrite something or because the system refuses.
fn unwritten(path: &Path, error: &Error) -> Problem {
    let path = path.display();
    let (message, hint) = match error.kind() {
        ErrorKind::AlreadyExists => (
            format!("{path} exists and would be overwritten"),
            "name another file, or replace it with --overwrite",
        ),
        _ => (
            format!("cannot write {path}: {error}"),
            "nothing was written; an existing file is as it was",
        ),
    };
    Problem::new(ProblemKind::Output, message, hint)
}

/// The ending of a name in lower case.
pub fn ending(path: &Path) -> Option<String> {
    path.extension()
        .map(|e| e.to_string_lossy().to_ascii_lowercase())
}

/// Refuses a name whose ending promises another format than the one that is written.
pub fn check_ending(path: Option<&Path>, endings: &[&str]) -> Result<(), Problem> {
    let Some((path, ending)) = path.and_then(|path| Some((path, ending(path)?))) else {
        return Ok(());
    };
    if endings.contains(&ending.as_str()) {
        return Ok(());
    }
    let message = format!(
        "{} ends in .{ending}, which is another format",
        path.display()
    );
    Err(Problem::new(
        ProblemKind::Output,
        message,
        format!("end it in .{}", endings.join(" or .")),
    ))
}

/// Writes all files of an answer into a folder, or none if one of them exists.
pub fn save_all(files: &[BuiltFile], folder: &Path) -> Result<(), Problem> {
    // A file with the same content is not written again.
    let is_there = |file: &&BuiltFile| {
        let limit = file.content.len() as u64;
        mckibben_io::files::read(&folder.join(&file.name), limit)
            .is_ok_and(|there| there == file.content)
    };
    let files = files.iter().filter(|file| !is_there(file));
    save_inside(
        folder,
        files.map(|file| (&file.name, &file.content)),
        overwrite(),
    )
}

/// Writes files into a folder, which is made where it is missing; a link in it is not followed.
pub fn save_inside<N: AsRef<Path>, B: AsRef<[u8]>>(
    folder: &Path,
    files: impl IntoIterator<Item = (N, B)>,
    overwrite: bool,
) -> Result<(), Problem> {
    progress::ended()?;
    put_all(folder, files, overwrite).map_err(|(path, e)| unwritten(&path, &e))
}

/// Writes to `path`, or to standard output.
pub fn emit(bytes: impl AsRef<[u8]>, path: Option<&Path>) -> Result<(), Problem> {
    if path.is_some() {
        return save(path, bytes.as_ref());
    }
    let mut out = std::io::stdout().lock();
    out.write_all(bytes.as_ref())
        .and_then(|()| out.flush())
        .map_err(|e| crate::unprinted(&e))
}

/// Style of the word before an error, a warning, a hint.
const ERROR: Style = AnsiColor::Red.on_default().bold();
const WARNING: Style = AnsiColor::Yellow.on_default().bold();
const HINT: Style = AnsiColor::Cyan.on_default();

/// A line for the user beside the result, in the units that he reads; nothing better can be done if
/// nobody can read it.
pub fn warn(message: impl std::fmt::Display) {
    let message = in_flags(&message.to_string());
    let text = display_units::sentence(&message);
    let text = short_numbers(&text);
    let text = width::broken_aside(&format!("warning: {}", clean::line(&text)));
    let text = text.strip_prefix("warning:").unwrap_or(&text);
    let _ = writeln!(anstream::stderr(), "{WARNING}warning:{WARNING:#}{text}");
}

/// Warnings that are printed behind the text.
static BEHIND: Mutex<Vec<String>> = Mutex::new(vec![]);

/// Prints what was left for behind the text.
pub fn warn_behind() {
    let mut list = BEHIND.lock().unwrap_or_else(PoisonError::into_inner);
    list.drain(..).for_each(warn);
}

/// Warnings in the place where they are read: those of the burst pressure as the first lines of the
/// text, which come back, with the others behind it; without them the others before it.
pub fn burst_first(warnings: &[impl std::fmt::Display]) -> String {
    let all = warnings.iter().map(ToString::to_string);
    let (first, others): (Vec<String>, Vec<String>) = all.partition(|w| is_of_burst(w));
    if first.is_empty() {
        others.into_iter().for_each(warn);
        return String::new();
    }
    BEHIND
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
        .extend(others);
    display_units::sentence(&first.join("\n")) + "\n\n"
}

/// What went wrong, in colour where the terminal shows it and `NO_COLOR` is not set.
pub fn complain(text: &str) {
    let styled = |text: String, word: &str, style: Style| {
        text.replacen(word, &format!("{style}{word}{style:#}"), 1)
    };
    let text = styled(width::broken_aside(text), "error:", ERROR);
    let _ = writeln!(anstream::stderr(), "{}", styled(text, "\n  hint:", HINT));
}

/// Writes a file, where one is named.
pub fn save(path: Option<&Path>, bytes: &[u8]) -> Result<(), Problem> {
    let Some(path) = path else { return Ok(()) };
    progress::ended()?;
    put(path, bytes, overwrite()).map_err(|e| unwritten(path, &e))
}
