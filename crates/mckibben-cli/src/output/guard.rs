//! What stands where a result goes: a file of the same kind is replaced, any other only where that was asked for.

use super::Target;
use crate::failure::Failure;
use mckibben::formula::{self, Document};
use mckibben::muscle::file::read_muscle;
use mckibben_app::ProblemKind;
use std::path::Path;

/// What is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    /// A table or a text.
    Other,
}

impl Content {
    /// Whether a file may be lost for one of this kind.
    fn replaces(self, path: &Path) -> bool {
        match self {
            Self::Muscle => read_muscle(path).is_ok(),
            Self::Formula => is_formula(path),
            Self::Json => !is_formula(path),
            Self::Parquet => super::parquet::is_ours(path),
            Self::Page | Self::Pdf | Self::Deck | Self::Latex | Self::Other => true,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Muscle => "a muscle file",
            Self::Formula => "a formula",
            Self::Json => "an answer in JSON",
            Self::Parquet => "an answer in Parquet",
            Self::Page => "a page in HTML",
            Self::Pdf => "a PDF",
            Self::Deck => "an input deck",
            Self::Latex => "an equation in LaTeX",
            Self::Other => "a file",
        }
    }

    /// Endings of files that hold it; any where there are none.
    fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Muscle => &["toml"],
            Self::Formula | Self::Json => &["json"],
            Self::Parquet => &["parquet"],
            Self::Page => &["html", "htm"],
            Self::Pdf => &["pdf"],
            Self::Deck => &["inp"],
            Self::Latex => &["tex", "txt", "md"],
            Self::Other => &[],
        }
    }

    /// Refuses a name whose ending promises something else.
    fn check_ending(self, path: &Path) -> Result<(), Failure> {
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

fn is_formula(path: &Path) -> bool {
    formula::read_text(path).is_ok_and(|text| Document::parse(&text).is_ok())
}

/// Refuses to write where something would be lost, or under a name that promises something else, best before any work is done for it.
pub fn check(target: Target<'_>, content: Content) -> Result<(), Failure> {
    let Some(path) = target.path else { return Ok(()) };
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
