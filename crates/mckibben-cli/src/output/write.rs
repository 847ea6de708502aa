//! Where results go: standard output, or a file that appears whole or not at all. An existing file
//! is overwritten only with `--overwrite`.

use super::width;
use crate::{Context, Problem, Result, clean, progress};
use anstyle::{AnsiColor, Style};
use mckibben_app::{BuiltFile, ProblemKind};
use mckibben_core::units::short_numbers;
use mckibben_io::files::{check_free, put, put_all};
use std::{
    fmt::Display,
    io::{Error, ErrorKind, Write},
    path::Path,
};

/// Flags that name files that are written.
const WRITTEN: [&str; 4] = ["--output", "--plot", "--report", "--export-inp"];

impl Context {
    /// Refuses a command line that names an existing file for a result, before any work is done for
    /// it. A campaign continues its file.
    pub fn check_named(&self, continues: bool) -> Result<()> {
        let is_written = |name: &str| WRITTEN.contains(&name) && !(continues && name == "--output");
        self.flags
            .iter()
            .filter(|flag| is_written(&flag.name))
            .flat_map(|flag| &flag.texts)
            .try_for_each(|(_, path)| self.check(Path::new(path)))
    }

    /// Refuses to write what is no answer, and to overwrite a file.
    pub fn check(&self, path: &Path) -> Result<()> {
        progress::ended()?;
        check_free(path, self.overwrite).map_err(|e| unwritten(path, &e))
    }

    /// Writes all files of an answer into a folder, or none if one of them exists.
    pub fn save_all(&self, files: &[BuiltFile], folder: &Path) -> Result<()> {
        // A file with the same content is not written again.
        let is_there = |file: &&BuiltFile| {
            let limit = file.content.len() as u64;
            mckibben_io::files::read(&folder.join(&file.name), limit)
                .is_ok_and(|there| there == file.content)
        };
        let files = files.iter().filter(|file| !is_there(file));
        self.save_inside(folder, files.map(|file| (&file.name, &file.content)))
    }

    /// Writes files into a folder, which is made where it is missing; a link in it is not followed.
    pub fn save_inside<N: AsRef<Path>, B: AsRef<[u8]>>(
        &self,
        folder: &Path,
        files: impl IntoIterator<Item = (N, B)>,
    ) -> Result<()> {
        progress::ended()?;
        put_all(folder, files, self.overwrite).map_err(|(path, e)| unwritten(&path, &e))
    }

    /// Writes a file, where one is named.
    pub fn save(&self, target: Option<&Path>, bytes: impl AsRef<[u8]>) -> Result<()> {
        let Some(path) = target else { return Ok(()) };
        progress::ended()?;
        put(path, bytes.as_ref(), self.overwrite).map_err(|e| unwritten(path, &e))
    }

    /// Writes to a file, or to standard output.
    pub fn emit(&self, bytes: impl AsRef<[u8]>, target: Option<&Path>) -> Result<()> {
        if target.is_some() {
            return self.save(target, bytes);
        }
        let mut out = std::io::stdout().lock();
        out.write_all(bytes.as_ref())
            .and_then(|()| out.flush())
            .map_err(|e| crate::unprinted(&e))
    }

    /// A line for the user beside the result, in the units that he reads; nothing better can be
    /// done if nobody can read it.
    pub fn warn(&self, message: impl Display) {
        let text = format!(
            "warning: {}",
            clean::line(&short_numbers(
                &self.units.sentence(&self.in_flags(&message.to_string()))
            ))
        );
        let text = width::broken(&text, width::aside());
        let text = text.strip_prefix("warning:").unwrap_or(&text);
        let _ = writeln!(anstream::stderr(), "{WARNING}warning:{WARNING:#}{text}");
    }
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
pub fn check_ending(path: Option<&Path>, endings: &[&str]) -> Result<()> {
    let Some((path, ending)) = path.and_then(|path| Some((path, ending(path)?))) else {
        return Ok(());
    };
    if endings.contains(&ending.as_str()) {
        return Ok(());
    }
    Err(Problem::new(
        ProblemKind::Output,
        format!(
            "{} ends in .{ending}, which is another format",
            path.display()
        ),
        format!("end it in .{}", endings.join(" or .")),
    ))
}

/// Style of the word before an error, a warning, a hint.
const ERROR: Style = AnsiColor::Red.on_default().bold();
const WARNING: Style = AnsiColor::Yellow.on_default().bold();
const HINT: Style = AnsiColor::Cyan.on_default();

/// What went wrong, in colour where the terminal shows it and `NO_COLOR` is not set.
pub fn complain(text: &str) {
    let styled = |text: String, word: &str, style: Style| {
        text.replacen(word, &format!("{style}{word}{style:#}"), 1)
    };
    let text = styled(width::broken(text, width::aside()), "error:", ERROR);
    let _ = writeln!(anstream::stderr(), "{}", styled(text, "\n  hint:", HINT));
}
