//! What is where a result goes: a file of the same kind that this program wrote is replaced, any other only where that was asked for.
//!
//! Formulas, muscle files and Parquet are read; figures, pages, PDFs and decks carry the program's mark. Of what can carry none the beginning is
//! compared with that of the result: the first line of a table, the first key of JSON, the first two words of a text.

use super::target::Target;
use crate::failure::Failure;
use crate::{files, progress};
use mckibben::formula::{self, Document};
use mckibben::muscle::file::read_muscle;
use mckibben_app::ProblemKind;
use std::borrow::Cow;
use std::io::Read;
use std::path::Path;

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Content {
    Muscle,
    Formula,
    /// An answer as JSON, which begins with this key.
    Json {
        key: String,
    },
    /// An answer as Parquet.
    Parquet,
    /// A report as a page.
    Page,
    Pdf,
    Deck,
    Manual,
    /// A file of a build.
    Built,
    /// A file of an export.
    Exported,
    /// A sheet for measured forces.
    EmptySheet,
    /// A figure.
    Figure,
    /// A file for ParaView, in a folder of them.
    Vtk,
    /// A table with this first line.
    Table {
        head: String,
    },
    /// A text that begins with these words.
    Text {
        begins: String,
    },
}

/// A string of a document's title as printed by a browser: UTF-16, in hexadecimal digits.
const PRINTED_TITLE: &str = "<FEFF004D0063004B0069006200620065006E";

impl Content {
    /// An answer as JSON.
    pub fn json(text: &[u8]) -> Self {
        Self::Json { key: first_key(&text_of(text)).unwrap_or_default().to_owned() }
    }

    /// A table by its bytes.
    pub fn table(text: &[u8]) -> Self {
        Self::Table { head: text_of(text).lines().next().unwrap_or_default().to_owned() }
    }

    /// A text by its bytes.
    pub fn text(text: &[u8]) -> Self {
        Self::Text { begins: first_words(&text_of(text)) }
    }

    /// Whether a file may be lost for one of this kind.
    fn replaces(&self, path: &Path) -> bool {
        match self {
            Self::Muscle => read_muscle(path).is_ok(),
            Self::Formula => is_formula(path),
            Self::Json { key } => first_key(&text_of(&head(path))) == Some(key) && !is_formula(path),
            Self::Parquet => super::parquet::is_ours(path),
            Self::Vtk => text_of(&head(path)).contains("<VTKFile"),
            Self::Table { head } => text_of(&self::head(path)).lines().next() == Some(head),
            Self::Text { begins } => first_words(&text_of(&head(path))) == *begins,
            Self::Page => mckibben_report::is_page(&head(path)),
            Self::Figure => mckibben_report::is_figure(&head(path)),
            Self::Pdf => text_of(&head(path)).contains(PRINTED_TITLE),
            Self::Deck => text_of(&head(path)).contains("mm, MPa, N; mckibben "),
            Self::Built => is_built(&head(path)),
            Self::Exported => text_of(&head(path)).contains(mckibben_app::EXPORT_MARK),
            Self::EmptySheet => is_built(&head(path)) && is_empty_sheet(path),
            Self::Manual => text_of(&head(path)).contains("\n.TH mckibben"),
        }
    }

    fn name(&self) -> &'static str {
        match self {
            Self::Muscle => "a muscle file",
            Self::Formula => "a formula",
            Self::Json { .. } => "such an answer in JSON",
            Self::Parquet => "an answer in Parquet",
            Self::Page => "a page that this program wrote",
            Self::Pdf => "a PDF that this program printed",
            Self::Deck => "an input deck that this program wrote",
            Self::Manual => "a manual page that this program wrote",
            Self::Built => "a file that `build` wrote",
            Self::Exported => "a file that `export` wrote",
            Self::EmptySheet => "a test sheet without forces",
            Self::Figure => "a figure that this program drew",
            Self::Vtk => "a file of a series for ParaView",
            Self::Table { .. } => "a table of this kind",
            Self::Text { .. } => "such a text",
        }
    }

    /// Endings of files that hold it; any where there are none.
    fn endings(&self) -> &'static [&'static str] {
        match self {
            Self::Muscle => &["toml"],
            Self::Formula | Self::Json { .. } => &["json"],
            Self::Parquet => &["parquet"],
            Self::Page => &["html", "htm"],
            Self::Pdf => &["pdf"],
            Self::Deck => &["inp"],
            Self::Built | Self::Exported | Self::EmptySheet => &[],
            Self::Figure | Self::Vtk | Self::Manual | Self::Table { .. } | Self::Text { .. } => &[],
        }
    }

    /// Refuses a name whose ending promises something else.
    fn check_ending(&self, path: &Path) -> Result<(), Failure> {
        let (endings, ending) = (self.endings(), ending(path));
        if endings.is_empty() || ending.as_deref().is_none_or(|e| endings.contains(&e)) {
            return Ok(());
        }
        let (name, ending) = (self.name(), ending.unwrap_or_default());
        let message = format!("{} would contain {name}, but its name ends in .{ending}", path.display());
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

/// The first key of an object in JSON.
fn first_key(text: &str) -> Option<&str> {
    let inside = text.trim_start().strip_prefix('{')?.trim_start().strip_prefix('"')?;
    inside.split_once('"').map(|(key, _)| key)
}

/// The first two words.
fn first_words(text: &str) -> String {
    text.split_whitespace().take(2).collect::<Vec<_>>().join(" ")
}

/// Whether a file with these first bytes is one of a build: by its mark, or as a drawing.
fn is_built(head: &[u8]) -> bool {
    text_of(head).contains(mckibben_build::MARK) || mckibben_report::is_figure(head)
}

/// Whether nobody has filled in a test sheet: what was measured must not be lost.
fn is_empty_sheet(path: &Path) -> bool {
    let Ok(text) = mckibben_files::read(path, 1 << 20) else { return false };
    let text = text_of(&text).into_owned();
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.into_iter().all(|row| row.trim().is_empty() || row.split(',').nth(2) == Some(""))
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
    let message = format!("{path} is not {name} and would be overwritten");
    Err(Failure::input(ProblemKind::Output, message, "name another file, or replace it with --overwrite"))
}

/// A result that would take the place of what it was made from.
pub fn of_input(path: &Path) -> Failure {
    let message = format!("{} is an input of this command and would be overwritten", path.display());
    Failure::input(ProblemKind::Output, message, "name another file, or replace it with --overwrite")
}
