//! Rows as Parquet.

use super::columns::Kind;
use super::rows::{Table, text};
use crate::failure::Failure;
use mckibben_app::ProblemKind;
use parquet::basic::Compression;
use parquet::column::writer::ColumnWriter;
use parquet::errors::{ParquetError, Result};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use serde_json::Value;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::Arc;

/// What the values of a column are; those that are not there are null.
#[derive(Debug)]
enum Column {
    Number(Vec<Option<f64>>),
    Flag(Vec<Option<bool>>),
    Text(Vec<Option<String>>),
}

impl Column {
    fn of(list: &[Value], key: &str, kind: Kind) -> Self {
        let cells = list.iter().map(|row| row.get(key).filter(|v| !v.is_null()));
        match kind {
            Kind::Number => Self::Number(cells.map(|v| v.and_then(Value::as_f64)).collect()),
            Kind::Flag => Self::Flag(cells.map(|v| v.and_then(Value::as_bool)).collect()),
            Kind::Text => Self::Text(cells.map(text).collect()),
        }
    }

    /// Its line of a Parquet schema.
    fn schema(&self, name: &str) -> String {
        match self {
            Self::Number(_) => format!("optional double {name};"),
            Self::Flag(_) => format!("optional boolean {name};"),
            Self::Text(_) => format!("optional binary {name} (STRING);"),
        }
    }

    fn write(&self, to: &mut ColumnWriter<'_>) -> Result<()> {
        match (self, to) {
            (Self::Number(v), ColumnWriter::DoubleColumnWriter(w)) => {
                w.write_batch(&known(v), Some(&definition_levels(v)), None)?
            }
            (Self::Flag(v), ColumnWriter::BoolColumnWriter(w)) => {
                w.write_batch(&known(v), Some(&definition_levels(v)), None)?
            }
            (Self::Text(v), ColumnWriter::ByteArrayColumnWriter(w)) => {
                let bytes: Vec<_> = v.iter().flatten().map(|text| text.as_str().into()).collect();
                w.write_batch(&bytes, Some(&definition_levels(v)), None)?
            }
            _ => return Err(ParquetError::General("a column of another kind".into())),
        };
        Ok(())
    }
}

fn known<T: Copy>(values: &[Option<T>]) -> Vec<T> {
    values.iter().copied().flatten().collect()
}

fn definition_levels<T>(values: &[Option<T>]) -> Vec<i16> {
    values.iter().map(|v| i16::from(v.is_some())).collect()
}

/// A table as the bytes of a Parquet file.
pub fn rows(table: &Table) -> std::result::Result<Vec<u8>, Failure> {
    encoded(table).map_err(|e| Failure::input(ProblemKind::Output, format!("cannot make Parquet: {e}"), ""))
}

/// Whether a file is one of those that [`rows`] gives: its last bytes name the program that made it, and no campaign.
pub fn is_ours(path: &Path) -> bool {
    /// Metadata of tables are not longer; a campaign's name it in its last bytes too.
    const TAIL: u64 = 1 << 20;
    let tail = || -> std::result::Result<Vec<u8>, mckibben_files::ReadError> {
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

fn encoded(table: &Table) -> Result<Vec<u8>> {
    let of = |(name, kind): &(String, Kind)| Column::of(&table.rows, name, *kind);
    let columns: Vec<Column> = table.columns.iter().map(of).collect();
    let lines: Vec<String> =
        columns.iter().zip(&table.columns).map(|(c, named)| c.schema(&named.0)).collect();
    let schema = parse_message_type(&format!("message table {{\n{}\n}}", lines.join("\n")))?;
    let properties = WriterProperties::builder()
        .set_created_by(format!("mckibben {}", env!("CARGO_PKG_VERSION")))
        .set_compression(Compression::LZ4_RAW);
    let mut out = SerializedFileWriter::new(vec![], Arc::new(schema), Arc::new(properties.build()))?;
    let mut group = out.next_row_group()?;
    for column in &columns {
        let Some(mut writer) = group.next_column()? else { break };
        column.write(writer.untyped())?;
        writer.close()?;
    }
    group.close()?;
    out.into_inner()
}

#[cfg(test)]
mod tests {
    use super::super::columns::with_others;
    use super::*;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;
    use serde_json::json;

    #[test]
    fn what_is_written_is_read_again() {
        let list = vec![json!({"force_n": 1.5, "slack": false, "status": "ok"}), json!({"status": "failed"})];
        let table = Table { columns: with_others(vec![], &list), rows: list };
        let reader = SerializedFileReader::new(bytes::Bytes::from(rows(&table).unwrap())).unwrap();
        let rows: Vec<_> = reader.get_row_iter(None).unwrap().map(Result::unwrap).collect();
        let cells = |i: usize| rows[i].get_column_iter().map(|c| c.1.clone()).collect::<Vec<_>>();
        assert_eq!(cells(0), [Field::Double(1.5), Field::Bool(false), Field::Str("ok".into())]);
        assert_eq!(cells(1), [Field::Null, Field::Null, Field::Str("failed".into())]);
    }
}
