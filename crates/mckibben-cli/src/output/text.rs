//! Text for people: aligned, with units, rounded to what is worth reading.

use super::width::{self, fold};
use crate::{clean::line, typed::in_flags};
use comfy_table::{CellAlignment, Table, presets};
use mckibben_app::print::{Block, Column, Page};
use std::path::Path;

/// The name of a file.
pub fn place(path: &Path) -> String {
    line(&path.display().to_string()).into_owned()
}

/// A text column of a table that is too wide is not made narrower than this.
const NARROW: usize = 24;
const GAP: usize = 2;

/// A table without borders: a header, aligned columns (numbers to the right). One that is wider
/// than the text may be has narrower text columns, or goes on below, with its first column again.
fn table_within(room: usize, list: &[Column]) -> String {
    let header = |i: usize| &*list[i].heading;
    let all_cells = list.iter().map(|column| {
        let cells = column.cells.iter().map(|cell| line(cell).into_owned());
        cells.collect()
    });
    let all_cells: Vec<Vec<String>> = all_cells.collect();
    let cells = |i: usize| all_cells[i].iter();
    let numeric = |i: usize| {
        let number = |c: &String| {
            c.starts_with(|ch: char| ch.is_ascii_digit() || "–-+. ".contains(ch))
                && !c.starts_with("--")
        };
        cells(i).all(|c| c.is_empty() || number(c) || c == "slack" || c == "unknown" || c == "→")
    };
    let numeric: Vec<bool> = (0..list.len()).map(numeric).collect();
    let length = |text: &str| text.chars().count();
    let widths: Vec<usize> = (0..list.len())
        .map(|i| {
            cells(i)
                .map(|cell| length(cell))
                .chain([length(header(i))])
                .max()
                .unwrap_or(0)
        })
        .collect();
    let wide = |columns: &[usize], most: usize| {
        let one = |&i: &usize| {
            if numeric[i] {
                widths[i]
            } else {
                widths[i].min(most)
            }
        };
        columns.iter().map(one).sum::<usize>() + GAP * columns.len().saturating_sub(1)
    };
    let all: Vec<usize> = (0..list.len()).collect();
    // The widest text columns for which a list of columns fits.
    let fits = |columns: &[usize]| {
        (NARROW..=room.max(NARROW))
            .rev()
            .find(|&most| wide(columns, most) <= room)
    };
    let mut blocks: Vec<(Vec<usize>, usize)> = vec![];
    if wide(&all, usize::MAX) <= room {
        blocks.push((all, usize::MAX));
    } else if let Some(most) = fits(&all) {
        blocks.push((all, most));
    } else {
        // Rows are told apart by the first column, or by the first two.
        let mut seen = std::collections::BTreeSet::new();
        let keys = if cells(0).all(|cell| seen.insert(cell)) {
            1
        } else {
            2
        };
        let (keys, others) = all.split_at(keys.min(all.len()));
        let mut block = keys.to_vec();
        let end = |block: &[usize]| (block.to_vec(), fits(block).unwrap_or(NARROW));
        for &i in others {
            block.push(i);
            if block.len() > keys.len() + 1 && fits(&block).is_none() {
                block.pop();
                blocks.push(end(&block));
                block = [keys, &[i]].concat();
            }
        }
        blocks.push(end(&block));
    }
    let drawn = blocks.into_iter().map(|(columns, most)| {
        let cut = |text: &str, i: usize| {
            if numeric[i] {
                text.to_owned()
            } else {
                fold(text, most).join("\n")
            }
        };
        let mut table = Table::new();
        table
            .load_preset(presets::NOTHING)
            .set_header(columns.iter().map(|&i| cut(header(i), i)));
        for at in 0..all_cells.first().map_or(0, Vec::len) {
            let cell = |&i: &usize| all_cells[i].get(at).map_or_else(String::new, |c| cut(c, i));
            table.add_row(columns.iter().map(cell));
        }
        let last = columns.len().saturating_sub(1);
        for (at, column) in table.column_iter_mut().enumerate() {
            let right = numeric[columns[at]];
            column.set_cell_alignment(if right {
                CellAlignment::Right
            } else {
                CellAlignment::Left
            });
            column.set_padding((0, if at == last { 0 } else { GAP as u16 }));
        }
        let text: Vec<String> = table.lines().map(|l| l.trim_end().to_owned()).collect();
        text.join("\n") + "\n"
    });
    drawn.collect::<Vec<_>>().join("\n")
}

/// A page of an answer.
pub fn laid_out(page: &Page) -> String {
    let block = |block: &Block| match block {
        Block::Text(text) => in_flags(text) + "\n",
        Block::Rows(rows) => pairs_within(width::of_tables(), rows),
        Block::Table(columns) => table_within(width::of_tables(), columns),
    };
    page.blocks.iter().map(block).collect()
}

/// Aligned `name   value` lines; a long value goes on below.
fn pairs_within(room: usize, list: &[(String, String)]) -> String {
    let width = list
        .iter()
        .map(|(name, _)| name.chars().count())
        .max()
        .unwrap_or(0);
    let room = room.saturating_sub(width + 5).max(NARROW);
    let one = |(name, value): &(String, String)| {
        let value = fold(&in_flags(&line(value)), room).join(&format!("\n{:1$}", "", width + 5));
        format!("  {name:<width$}   {value}\n")
    };
    list.iter().map(one).collect()
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
        let text = pairs_within(
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
