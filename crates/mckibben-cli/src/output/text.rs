//! Text for people: aligned, with units, rounded to what is worth reading.

use super::width::fold;
use crate::{Context, clean::line};
use comfy_table::{CellAlignment, Table, presets};
use mckibben_app::print::{Block, Column, Page};
use mckibben_core::joined;
use std::path::Path;

/// The name of a file.
pub fn path_on_one_line(path: &Path) -> String {
    line(&path.display().to_string()).into_owned()
}

/// A text column of a table that is too wide is not made narrower than this.
const NARROW: usize = 24;
const GAP: usize = 2;

/// A table without borders: a header, aligned columns (numbers to the right). One that is wider
/// than the text may be has narrower text columns, or goes on below, with its first column again.
fn table_within(room: usize, list: &[Column]) -> String {
    let columns = Vec::from_iter(list.iter().map(Drawn::new));
    joined(
        parts(room, &columns.iter().collect::<Vec<_>>())
            .iter()
            .map(|columns| table(room, columns)),
        "\n",
    )
}

/// A column of one line a cell.
struct Drawn<'a> {
    heading: &'a str,
    cells: Vec<String>,
    is_numeric: bool,
    width: usize,
    /// The longest word, which is not broken.
    word: usize,
}

impl<'a> Drawn<'a> {
    fn new(column: &'a Column) -> Self {
        let heading = &*column.heading;
        let cells = Vec::from_iter(column.cells.iter().map(|cell| line(cell).into_owned()));
        let number = |c: &str| {
            c.starts_with(|ch: char| ch.is_ascii_digit() || "–-+. ".contains(ch))
                && !c.starts_with("--")
        };
        let mut texts = cells.iter();
        let is_numeric = texts.all(|c| number(c) || matches!(&**c, "" | "slack" | "unknown" | "→"));
        let texts = || cells.iter().map(String::as_str).chain([heading]);
        let longest = |words: &mut dyn Iterator<Item = &str>| {
            words
                .map(|text| text.chars().count())
                .max()
                .unwrap_or_default()
        };
        let width = longest(&mut texts());
        let word = longest(&mut texts().flat_map(|text| text.split(' ')));
        Self {
            width,
            word,
            heading,
            is_numeric,
            cells,
        }
    }

    /// A cell, or the heading; a text has lines of at most so many characters.
    fn folded(&self, text: &str, most: usize) -> String {
        if self.is_numeric {
            text.to_owned()
        } else {
            fold(text, most).join("\n")
        }
    }
}

/// The widest text columns for which a list of columns fits.
fn fits(room: usize, columns: &[&Drawn<'_>]) -> Option<usize> {
    let gaps = GAP * columns.len().saturating_sub(1);
    (NARROW..=room.max(NARROW)).rev().find(|&most| {
        let folded = |c: &Drawn<'_>| c.width.min(most.max(c.word));
        let width = |c: &&Drawn<'_>| if c.is_numeric { c.width } else { folded(c) };
        columns.iter().map(width).sum::<usize>() + gaps <= room
    })
}

/// The columns of each part of a table that is too wide.
fn parts<'a>(room: usize, all: &[&'a Drawn<'a>]) -> Vec<Vec<&'a Drawn<'a>>> {
    if fits(room, all).is_some() {
        return vec![all.to_vec()];
    }
    // Rows are told apart by the first column, or by the first two.
    let mut seen = std::collections::BTreeSet::new();
    let is_key = all[0].cells.iter().all(|cell| seen.insert(cell));
    let (keys, others) = all.split_at(if is_key { 1 } else { 2.min(all.len()) });
    let mut parts = vec![];
    let mut part = keys.to_vec();
    for column in others {
        part.push(column);
        if part.len() > keys.len() + 1 && fits(room, &part).is_none() {
            part.pop();
            parts.push(part);
            part = [keys, &[column]].concat();
        }
    }
    parts.push(part);
    parts
}

/// Columns side by side.
fn table(room: usize, columns: &[&Drawn<'_>]) -> String {
    let most = fits(room, columns).unwrap_or(NARROW);
    let mut table = Table::new();
    table
        .load_preset(presets::NOTHING)
        .set_header(columns.iter().map(|c| c.folded(c.heading, most)));
    for row in 0..columns.first().map_or(0, |c| c.cells.len()) {
        let cell = |c: &&Drawn<'_>| c.cells.get(row).map(|cell| c.folded(cell, most));
        table.add_row(columns.iter().map(|c| cell(c).unwrap_or_default()));
    }
    for (i, (column, drawn)) in table.column_iter_mut().zip(columns).enumerate() {
        column.set_cell_alignment(if drawn.is_numeric {
            CellAlignment::Right
        } else {
            CellAlignment::Left
        });
        let is_last = i + 1 == columns.len();
        column.set_padding((0, if is_last { 0 } else { GAP as u16 }));
    }
    joined(table.lines().map(|l| l.trim_end().to_owned()), "\n") + "\n"
}

impl Context {
    /// A page of an answer, whose tables are as wide.
    pub fn laid_out(&self, page: &Page, room: usize) -> String {
        let block = |block: &Block| match block {
            Block::Text(text) => self.in_flags(text) + "\n",
            Block::Rows(rows) => self.pairs_within(room, rows),
            Block::Table(columns) => table_within(room, columns),
        };
        page.blocks.iter().map(block).collect()
    }

    /// Aligned `name   value` lines; a long value goes on below.
    fn pairs_within(&self, room: usize, list: &[(String, String)]) -> String {
        let width = list
            .iter()
            .map(|(name, _)| name.chars().count())
            .max()
            .unwrap_or_default();
        let room = room.saturating_sub(width + 5).max(NARROW);
        let one = |(name, value): &(String, String)| {
            let value =
                fold(&self.in_flags(&line(value)), room).join(&format!("\n{:1$}", "", width + 5));
            format!("  {name:<width$}   {value}\n")
        };
        list.iter().map(one).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns(header: &[&str], rows: &[Vec<String>]) -> Vec<Column> {
        let column = |(i, heading): (usize, &&str)| Column {
            heading: (*heading).into(),
            cells: rows.iter().map(|row| row[i].clone()).collect(),
        };
        header.iter().enumerate().map(column).collect()
    }

    fn rows() -> Vec<Vec<String>> {
        let row = |i: usize| {
            let numbers = (0..6).map(|j| format!("{i}{j}.5"));
            std::iter::once(format!("{i}."))
                .chain(numbers)
                .chain(["a few words of text".to_owned()])
                .collect()
        };
        (1..3).map(row).collect()
    }

    #[test]
    fn a_wide_table_goes_on_below_with_its_first_column_again() {
        let header = ["", "one", "two", "three", "four", "five", "six", "what"];
        let whole = table_within(80, &columns(&header, &rows()));
        assert_eq!(whole.lines().count(), 3, "{whole}");
        let narrow = table_within(40, &columns(&header, &rows()));
        assert!(narrow.lines().all(|l| l.chars().count() <= 40), "{narrow}");
        assert_eq!(
            narrow.lines().filter(|l| l.starts_with("1.")).count(),
            2,
            "{narrow}"
        );
        assert!(narrow.contains("\n\n"), "{narrow}");
        // Every cell is there once.
        for cell in rows().iter().flat_map(|row| &row[1..7]) {
            assert_eq!(narrow.matches(cell.as_str()).count(), 1, "{cell}: {narrow}");
        }
    }

    #[test]
    fn a_table_of_texts_has_narrower_columns() {
        let long = "words and words and words and words and words and words and words and words"
            .to_owned();
        let text = table_within(60, &columns(&["n", "case"], &[vec!["1".into(), long]]));
        assert!(
            text.lines().count() > 2 && text.lines().all(|l| l.chars().count() <= 60),
            "{text}"
        );
    }

    #[test]
    fn a_long_value_goes_on_below_its_beginning() {
        let text = Context::default().pairs_within(
            40,
            &[(
                "name".into(),
                "value and value and value and value and value".into(),
            )],
        );
        assert_eq!(
            text,
            "  name   value and value and value and\n         value and value\n"
        );
    }
}
