//! Tables of answers by their keys ([`mckibben_app::rows`]).

use super::text::{Units, aligned, columns};
use mckibben_app::rows::Key;
pub use mckibben_app::rows::{listed, said, value};
use serde::Serialize;
use serde_json::Value;

/// A table with a row for each value of a list; columns of which there is nothing are left out.
pub fn tabled(list: impl IntoIterator<Item = impl Serialize>, keys: &str, u: &Units) -> String {
    let rows: Vec<Value> = list.into_iter().map(|row| value(&row)).collect();
    if rows.is_empty() {
        return String::new();
    }
    let keys = keys.split_whitespace().map(|token| Key::parse(token, u));
    columns(keys.filter_map(|key| column(&key, &rows)))
}

/// The same behind a line with its heading; nothing where there is no row.
pub fn headed(
    head: &str,
    list: impl IntoIterator<Item = impl Serialize>,
    keys: &str,
    u: &Units,
) -> String {
    let table = tabled(list, keys, u);
    if table.is_empty() {
        table
    } else {
        format!("\n{head}\n{table}")
    }
}

fn column(key: &Key<'_>, rows: &[Value]) -> Option<(String, Vec<String>)> {
    let numbers: Vec<Option<f64>> = rows.iter().map(|row| key.number(row, key.path)).collect();
    let is_plain = key.half.is_none() && key.is_aligned;
    let percent = if key.unit == "%" { " %" } else { "" };
    let cells = rows.iter().zip(&numbers).zip(aligned(&numbers, key.digits));
    let cells = cells.map(|((row, number), aligned)| match number {
        Some(_) if is_plain => Some(aligned + percent),
        Some(_) => key.bare(row).map(|text| text + percent),
        None => key.bare(row),
    });
    let cells: Vec<Option<String>> = cells.collect();
    let heading = match &*key.unit {
        "" | "%" => key.label.clone(),
        unit => format!("{} [{unit}]", key.label),
    };
    let is_known = cells.iter().flatten().any(|cell| !cell.is_empty());
    is_known.then(|| {
        (
            heading,
            cells
                .into_iter()
                .map(|c| c.unwrap_or_else(|| "–".into()))
                .collect(),
        )
    })
}
