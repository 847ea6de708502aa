//! What stands where a result goes: a file of the same kind is replaced, any other only where that was asked for.

use super::Target;
use crate::failure::Failure;
use crate::{files, progress};
use mckibben::formula::{self, Document};
use mckibben::muscle::file::read_muscle;
use mckibben_app::ProblemKind;
use std::borrow::Cow;
use std::io::Read;
use std::path::Path;

/// What is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Content {
    /// A muscle file.
    Muscle,
    /// A formula.
    Formula,
    /// An answer as JSON.
    Json,
    /// An answer as Parquet.
    Parquet,
    /// A report as a page.
    Page,
    /// A report, printed.
    Pdf,
    /// An input deck.
    Deck,
    /// An equation.
    Latex,
    /// A figure or a picture.
    Figure,
    /// A file for ParaView, in a folder of them.
    Vtk,
    /// A table in a folder of them, with this first line.
    Table {
        /// The first line.
        head: String,
    },
    /// A table or a text.
    Other,
}

impl Content {
    /// Whether a file may be lost for one of this kind.
    fn replaces(&self, path: &Path) -> bool {
        match self {
            Self::Muscle => read_muscle(path).is_ok(),
            Self::Formula => is_formula(path),
            Self::Json => !is_formula(path),
            Self::Parquet => super::parquet::is_ours(path),
            Self::Vtk => text_of(&head(path)).contains("<VTKFile"),
            Self::Table { head } => text_of(&self::head(path)).lines().next() == Some(head),
            Self::Page | Self::Pdf | Self::Deck | Self::Latex | Self::Figure | Self::Other => true,
        }
    }

    fn name(&self) -> &'static str {
        match self {
            Self::Muscle => "a muscle file",
            Self::Formula => "a formula",
            Self::Json => "an answer in JSON",
            Self::Parquet => "an answer in Parquet",
            Self::Page => "a page in HTML",
            Self::Pdf => "a PDF",
            Self::Deck => "an input deck",
            Self::Latex => "an equation in LaTeX",
            Self::Figure => "a figure",
            Self::Vtk => "a file of a series for ParaView",
            Self::Table { .. } => "a table of this kind",
            Self::Other => "a file",
        }
    }

    /// Endings of files that hold it; any where there are none.
    fn endings(&self) -> &'static [&'static str] {
        match self {
            Self::Muscle => &["toml"],
            Self::Formula | Self::Json => &["json"],
            Self::Parquet => &["parquet"],
            Self::Page => &["html", "htm"],
            Self::Pdf => &["pdf"],
            Self::Deck => &["inp"],
            Self::Latex => &["tex", "txt", "md"],
            Self::Figure | Self::Vtk | Self::Table { .. } | Self::Other => &[],
        }
    }

    /// Refuses a name whose ending promises something else.
    fn check_ending(&self, path: &Path) -> Result<(), Failure> {
        let (endings, ending) = (self.endings(), ending(path));
        if endings.is_empty() || ending.as_deref().is_none_or(|e| endings.contains(&e)) {
            return Ok(());
        }
        let (name, ending) = (self.name(), ending.unwrap_or_default());
        let message = format!("{} would hold {name}, and its name ends in .{ending}", path.display());
        let list: Vec<String> = endings.iter().map(|e| format!(".{e}")).collect();
        Err(Failure::input(ProblemKind::Output, message, format!("end it in {}", list.join(" or "))))
    }
}

/// The ending of a name in lower case.
pub fn ending(path: &Path) -> Option<String> {
    path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase())
}

/// The first bytes of a file, as many as tell what it is.
fn head(path: &Path) -> Vec<u8> {
    let mut bytes = vec![];
    if let Ok(file) = mckibben_files::open(path) {
        // What cannot be read is none of ours.
        let _ = file.take(4096).read_to_end(&mut bytes);
    }
    bytes
}

fn text_of(bytes: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(bytes)
}

fn is_formula(path: &Path) -> bool {
    formula::read_text(path).is_ok_and(|text| Document::parse(&text).is_ok())
}

/// Refuses to write what is no answer, what was read for it, where something would be lost, and under a name that promises something else, best before any work is done for it.
pub fn check(target: Target<'_>, content: &Content) -> Result<(), Failure> {
    progress::ended()?;
    let Some(path) = target.path else { return Ok(()) };
    if !target.overwrite && files::was_read(path) {
        return Err(of_input(path));
    }
    content.check_ending(path)?;
    // What is no regular file is written in place, or refused when it is written.
    let Ok(there) = std::fs::metadata(path) else { return Ok(()) };
    if !there.is_file() {
        return Ok(());
    }
    mckibben_files::check_writable(path).map_err(|e| Failure::unwritable(path, &e))?;
    if target.overwrite || there.len() == 0 || content.replaces(path) {
        return Ok(());
    }
    let (path, name) = (path.display(), content.name());
    let message = format!("{path} is not {name}, and would be lost");
    Err(Failure::input(ProblemKind::Output, message, "name another file, or replace it with --overwrite"))
}

/// A result that would take the place of what it was made from.
pub fn of_input(path: &Path) -> Failure {
    let message = format!("{} is an input of this command, and would be lost", path.display());
    Failure::input(ProblemKind::Output, message, "name another file, or replace it with --overwrite")
}
