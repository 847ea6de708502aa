//! Rows as Parquet.

use super::columns::Kind;
use super::rows::{Table, text};
use crate::failure::Failure;
use mckibben_app::ProblemKind;
use mckibben_parquet::{Column, Field, Packing, Sealed, TableError, Text, Writer};
use serde_json::Value;
use std::io::{Cursor, Read, Seek, SeekFrom};
use std::path::Path;

/// A table as the bytes of a Parquet file.
pub fn rows(table: &Table) -> Result<Vec<u8>, Failure> {
    encoded(table).map_err(|e| Failure::input(ProblemKind::Output, format!("cannot make Parquet: {e}"), ""))
}

fn encoded(table: &Table) -> Result<Vec<u8>, TableError> {
    let field = |(name, kind): &(String, Kind)| Field {
        name: name.clone(),
        kind: column(&[], name, *kind),
        packing: Packing::Repeated,
    };
    let fields: Vec<Field> = table.columns.iter().map(field).collect();
    let columns = table.columns.iter().map(|(key, kind)| column(&table.rows, key, *kind));
    let columns: Vec<Column> = columns.collect();
    let mut bytes = Cursor::new(vec![]);
    let program = format!("mckibben {}", env!("CARGO_PKG_VERSION"));
    let mut writer = Writer::new(&mut bytes, "table", &program, &fields, Sealed::No)?;
    writer.group(&columns)?;
    writer.finish()?;
    Ok(bytes.into_inner())
}

/// The values of a column; those that are not there are null.
fn column(list: &[Value], key: &str, kind: Kind) -> Column {
    let cells = list.iter().map(|row| row.get(key).filter(|v| !v.is_null()));
    match kind {
        Kind::Number => Column::Optional(cells.map(|v| v.and_then(Value::as_f64)).collect()),
        Kind::Flag => Column::Flag(cells.map(|v| v.and_then(Value::as_bool)).collect()),
        Kind::Text => {
            Column::OptionalText(cells.map(|v| text(v).map(|text| Text::from(text.as_str()))).collect())
        }
    }
}

/// Whether a file is one of those that [`rows`] gives: its last bytes name the program that made it, and no campaign.
pub fn is_ours(path: &Path) -> bool {
    /// Metadata of tables are not longer; a campaign's name it in its last bytes too.
    const TAIL: u64 = 1 << 20;
    let tail = || -> Result<Vec<u8>, mckibben_files::ReadError> {
        let mut file = mckibben_files::open(path)?;
        let length = file.metadata()?.len();
        file.seek(SeekFrom::Start(length.saturating_sub(TAIL)))?;
        let mut bytes = vec![];
        file.take(TAIL).read_to_end(&mut bytes)?;
        Ok(bytes)
    };
    let has = |tail: &[u8], text: &str| tail.windows(text.len()).any(|w| w == text.as_bytes());
    tail()
        .is_ok_and(|tail| tail.ends_with(b"PAR1") && has(&tail, "mckibben ") && !has(&tail, "mckibben.plan"))
}
