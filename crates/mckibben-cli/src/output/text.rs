//! Text for people: aligned, with units, rounded to what is worth reading.

use crate::clean::line;
use comfy_table::{CellAlignment, Table, presets};
use mckibben_app::UnderstoodTable;
pub use mckibben_app::units::Units;
pub use mckibben_app::words::{aligned, law_text, number, percent};
use std::path::Path;

/// The name of a file.
pub fn place(path: &Path) -> String {
    line(&path.display().to_string()).into_owned()
}

/// A number or a dash.
pub fn or_dash<T>(v: Option<T>, show: impl Fn(T) -> String) -> String {
    v.map_or_else(|| "–".into(), show)
}

/// A table without borders: a header, aligned columns (numbers to the right).
pub fn table(header: &[&str], rows: Vec<Vec<String>>) -> String {
    let numeric = |i: usize| {
        let cells = rows.iter().filter_map(|row| row.get(i));
        let number = |c: &String| {
            c.starts_with(|ch: char| ch.is_ascii_digit() || "–-+. ".contains(ch)) && !c.starts_with("--")
        };
        cells.clone().all(|c| c.is_empty() || number(c) || c == "slack" || c == "unknown" || c == "→")
    };
    let numeric: Vec<bool> = (0..header.len()).map(numeric).collect();
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_header(header.iter().copied());
    for row in rows {
        table.add_row(row.iter().map(|cell| line(cell)));
    }
    let last = header.len().saturating_sub(1);
    for (i, column) in table.column_iter_mut().enumerate() {
        column.set_cell_alignment(if numeric[i] { CellAlignment::Right } else { CellAlignment::Left });
        column.set_padding((0, if i == last { 0 } else { 2 }));
    }
    let text: Vec<String> = table.lines().map(|l| l.trim_end().to_owned()).collect();
    text.join("\n") + "\n"
}

/// Aligned `name   value` lines.
pub fn pairs(list: &[(&str, String)]) -> String {
    let width = list.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    list.iter().map(|(name, value)| format!("  {name:<width$}   {}\n", line(value))).collect()
}

/// What was understood of tables, a line each.
pub fn understood(tables: &[UnderstoodTable]) -> String {
    tables.iter().map(|table| line(&table.line()).into_owned() + "\n").collect()
}

/// A percentage a row, with their points aligned.
pub fn percents(ratios: impl IntoIterator<Item = Option<f64>>, digits: usize) -> Vec<String> {
    let hundredfold: Vec<Option<f64>> = ratios.into_iter().map(|v| v.map(|v| 100.0 * v)).collect();
    let column = aligned(&hundredfold, digits).into_iter();
    column.map(|cell| if cell == "–" { cell } else { cell + " %" }).collect()
}

/// A table of columns, each with its heading.
pub fn columns(list: impl IntoIterator<Item = (String, Vec<String>)>) -> String {
    let (header, columns): (Vec<String>, Vec<Vec<String>>) = list.into_iter().unzip();
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let count = columns.first().map_or(0, Vec::len);
    let row = |i: usize| columns.iter().map(|c| c.get(i).cloned().unwrap_or_default()).collect();
    table(&header, (0..count).map(row).collect())
}
