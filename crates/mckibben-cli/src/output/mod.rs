//! Results as text, JSON and CSV, and where they go.

mod table;
pub mod text;
mod width;
mod write;

use crate::{Context, Format, Problem, Result, clean, unprinted};
use mckibben_app::{
    ProblemKind, Units,
    print::{Page, Show},
};
use mckibben_core::{joined, warning::Warning};
use serde::Serialize;
use serde_json::Value;
use std::{
    io::{BufWriter, Error, Write},
    path::{Path, PathBuf},
};
use table::CsvTable;
pub use write::{check_ending, complain, ending};

pub fn json<T: Serialize>(answer: &T) -> Result<Value> {
    serde_json::to_value(answer)
        .map_err(|e| ProblemKind::Output.problem(format!("cannot make JSON: {e}")))
}

/// A text with plain spaces in the place of those that join a quantity to its unit.
pub fn plain(text: String) -> String {
    text.replace('\u{a0}', " ")
}

/// The same of what is written, text after text.
struct Plain<W>(W);

impl<W: Write> Write for Plain<W> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match std::str::from_utf8(bytes) {
            Ok(text) if text.contains('\u{a0}') => {
                self.0.write_all(plain(text.into()).as_bytes())?
            }
            _ => self.0.write_all(bytes)?,
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.0.flush()
    }
}

/// Units that are shown.
#[derive(clap::Args)]
#[command(next_help_heading = "Output")]
pub struct ShownUnits {
    /// Units that are shown: bar, or psi,lbf,in
    ///
    /// Of text and figures: a unit of pressure, force or length, or several. Without it those of
    /// your flags, else MPa, N and mm.
    #[arg(long, value_name = "UNIT,…")]
    // `Context` has it.
    #[allow(dead_code)]
    units: Option<Units>,
}

/// Where the result goes, and in which units it is shown.
#[derive(clap::Args)]
#[command(next_help_heading = "Output")]
pub struct Output {
    #[command(flatten)]
    pub units: ShownUnits,
    /// Write the result to a file
    ///
    /// Instead of standard output. The ending selects the format: .txt, .json, .csv.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

impl Output {
    /// Prints an answer where `--output` says.
    pub fn print<T: Show>(&self, context: &Context, answer: &T) -> Result<u8> {
        context.print(answer, |_| (), self.output.as_deref())?;
        Ok(0)
    }
}

/// The file that a result goes to; else standard output.
pub type Target<'a> = Option<&'a Path>;

impl Context {
    /// Prints an answer in the requested form: as text for people with what `add` adds, as JSON, or
    /// as a table.
    pub fn print<T: Show>(
        &self,
        answer: &T,
        add: impl FnOnce(&mut Page),
        target: Target<'_>,
    ) -> Result<()> {
        let page = |u: &Units| {
            let mut page = answer.page(u);
            add(&mut page);
            page
        };
        self.print_page(answer, page, target)
    }

    /// The same with a page of its own.
    pub fn print_page<T: Show>(
        &self,
        answer: &T,
        page: impl FnOnce(&Units) -> Page,
        target: Target<'_>,
    ) -> Result<()> {
        match form(target, self.format)? {
            Format::Text => self.print_text(answer.warnings(), || page(&self.units), target),
            Format::Json => self.emit(plain(format!("{:#}\n", json(answer)?)), target),
            Format::Csv => {
                let csv = answer.csv();
                answer
                    .warnings()
                    .iter()
                    .chain(&csv.warnings)
                    .filter(|w| w.is_of_burst())
                    .for_each(|w| self.warn(w));
                // What has no rows says why.
                if csv.rows.as_ref().is_ok_and(Vec::is_empty) {
                    let text = self.laid_out(&page(&self.units), width::STABLE);
                    complain(clean::lines(&plain(text)).trim());
                }
                self.emit(table::csv(&CsvTable::of(csv)?)?, target)
            }
        }
    }

    /// Prints a text and its warnings: those of the burst pressure as its first lines, with the
    /// others behind the text; without them the others before it.
    fn print_text(
        &self,
        warnings: Vec<Warning>,
        page: impl FnOnce() -> Page,
        target: Target<'_>,
    ) -> Result<()> {
        self.unit_note.iter().for_each(|note| self.warn(note));
        let (first, mut others): (Vec<_>, Vec<_>) =
            warnings.into_iter().partition(Warning::is_of_burst);
        let mut text = String::new();
        if first.is_empty() {
            others.drain(..).for_each(|w| self.warn(w));
        } else {
            text = self
                .units
                .sentence(&joined(first.iter().map(ToString::to_string), "\n"))
                + "\n\n";
        }
        let width = width::of_result(target);
        text += &self.laid_out(&page(), width.unwrap_or(width::STABLE));
        self.emit(width::broken(&clean::lines(&plain(text)), width), target)?;
        others.into_iter().for_each(|w| self.warn(w));
        Ok(())
    }

    /// Prints an answer of many points as JSON: straight to standard output, or into a file, which
    /// appears whole.
    pub fn emit_json<T: Serialize>(&self, answer: &T, target: Target<'_>) -> Result<()> {
        if target.is_some() {
            return self.emit(plain(format!("{:#}\n", json(answer)?)), target);
        }
        let mut out = BufWriter::new(std::io::stdout().lock());
        serde_json::to_writer_pretty(Plain(&mut out), answer)
            .map_err(Error::from)
            .and_then(|()| writeln!(out))
            .and_then(|()| out.flush())
            .map_err(|error| unprinted(&error))
    }
}

/// The format of a file by its ending; without one, or for standard output, that of `--format`.
pub fn form(path: Option<&Path>, format: Format) -> Result<Format> {
    let Some(ending) = path.and_then(ending) else {
        return Ok(format);
    };
    let by_ending = match ending.as_str() {
        "txt" | "md" => Format::Text,
        "json" => Format::Json,
        "csv" => Format::Csv,
        other => {
            return Err(Problem::new(
                ProblemKind::Output,
                format!("--output: .{other} is not a supported file ending"),
                "the endings are .txt, .json and .csv",
            ));
        }
    };
    if format == Format::Text || format == by_ending {
        return Ok(by_ending);
    }
    Err(Problem::new(
        ProblemKind::Output,
        "--output and --format name two formats",
        "leave out --format: the file ending selects the format",
    ))
}
