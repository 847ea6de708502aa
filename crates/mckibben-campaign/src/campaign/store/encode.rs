//! Tables → Parquet.

use super::layout::Field;
use super::provenance::{Provenance, VERSION, Which};
use super::seal::{SEAL, Sealing};
use super::table::{Column, Table};
use crate::campaign::CampaignError;
use crate::columns::Role;
use parquet::basic::{Compression, Encoding};
use parquet::column::writer::ColumnWriter;
use parquet::errors::{ParquetError, Result};
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;
use parquet::schema::types::{ColumnPath, TypePtr};
use std::fs::File;
use std::io::{Cursor, Seek, Write};
use std::path::Path;
use std::sync::Arc;

/// Rows of a row group, save the last.
pub(super) const GROUP: usize = 1 << 16;
/// How columns are compressed; in Rust alone, so that no compiler of C is needed.
pub(super) const CODEC: Compression = Compression::LZ4_RAW;

fn writer<W: Write + Send>(
    inner: W,
    provenance: &Provenance,
    which: Which,
) -> Result<SerializedFileWriter<Sealing<W>>> {
    let fields = provenance.layout.fields();
    let mut properties = WriterProperties::builder()
        .set_created_by(format!("mckibben {VERSION}"))
        .set_compression(CODEC)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_offset_index_disabled(true)
        .set_key_value_metadata(Some(provenance.write(which)));
    // What was asked repeats few values, so that a dictionary of them is worth its bytes. Answers differ; sorted into streams of
    // first, second, … bytes they have something to compress.
    for field in fields.iter().filter(|f| f.column.role == Role::Answer) {
        let path = ColumnPath::from(field.name.as_str());
        properties = properties.set_column_dictionary_enabled(path.clone(), false);
        if matches!(Column::new(field), Column::Double(_) | Column::Optional(_)) {
            properties = properties.set_column_encoding(path, Encoding::BYTE_STREAM_SPLIT);
        }
    }
    let properties = Arc::new(properties.build());
    let mut out = SerializedFileWriter::new(Sealing::new(inner), schema(&fields)?, properties)?;
    out.write_all(&[0; SEAL])?;
    Ok(out)
}

/// The columns as a schema of Parquet.
fn schema(fields: &[Field]) -> Result<TypePtr> {
    let line = |f: &Field| {
        let (before, behind) = Column::new(f).schema();
        format!("  {before} {}{behind};\n", f.name)
    };
    let lines: String = fields.iter().map(line).collect();
    parse_message_type(&format!("message campaign {{\n{lines}}}")).map(Arc::new)
}

fn write_column(column: &Column, to: &mut ColumnWriter<'_>) -> Result<()> {
    let unsuited = || ParquetError::General("a column of another kind".into());
    match (column, to) {
        (Column::Int64(v), ColumnWriter::Int64ColumnWriter(w)) => w.write_batch(v, None, None)?,
        (Column::Int32(v), ColumnWriter::Int32ColumnWriter(w)) => w.write_batch(v, None, None)?,
        (Column::Double(v), ColumnWriter::DoubleColumnWriter(w)) => w.write_batch(v, None, None)?,
        (Column::Text(v), ColumnWriter::ByteArrayColumnWriter(w)) => w.write_batch(v, None, None)?,
        (Column::Optional(v), ColumnWriter::DoubleColumnWriter(w)) => {
            let values: Vec<f64> = v.iter().copied().flatten().collect();
            let there: Vec<i16> = v.iter().map(|x| i16::from(x.is_some())).collect();
            w.write_batch(&values, Some(&there), None)?
        }
        _ => return Err(unsuited()),
    };
    Ok(())
}

fn write_group<W: Write + Send>(out: &mut SerializedFileWriter<W>, table: &Table) -> Result<()> {
    if table.rows == 0 {
        return Ok(());
    }
    let mut group: SerializedRowGroupWriter<'_, W> = out.next_row_group()?;
    for column in &table.columns {
        let Some(mut writer) = group.next_column()? else { break };
        write_column(column, writer.untyped())?;
        writer.close()?;
    }
    group.close().map(drop)
}

fn finish<W: Write + Send + Seek>(out: SerializedFileWriter<Sealing<W>>) -> Result<W> {
    out.into_inner()?.seal().map_err(ParquetError::from)
}

/// Adds a table to a group; a group that is full is written, and the next begins.
fn add<W: Write + Send>(
    out: &mut SerializedFileWriter<W>,
    group: &mut Table,
    table: &Table,
    provenance: &Provenance,
) -> Result<()> {
    let mut from = 0;
    while from < table.rows {
        let to = table.rows.min(from + GROUP - group.rows);
        group.extend(table, from, to);
        from = to;
        if group.rows == GROUP {
            write_group(out, group)?;
            *group = Table::new(&provenance.layout);
        }
    }
    Ok(())
}

/// A part as the bytes of its file.
pub(crate) fn part(
    provenance: &Provenance,
    number: u64,
    table: &Table,
) -> std::result::Result<Vec<u8>, CampaignError> {
    let bytes = || {
        let mut out = writer(Cursor::new(vec![]), provenance, Which::Part(number))?;
        let mut group = Table::new(&provenance.layout);
        add(&mut out, &mut group, table, provenance)?;
        write_group(&mut out, &group)?;
        finish(out).map(Cursor::into_inner)
    };
    bytes().map_err(|e| CampaignError::Encode(e.to_string()))
}

/// The whole table into an empty file, group by group; how the tables are cut does not matter.
pub(crate) fn whole(
    provenance: &Provenance,
    tables: impl Iterator<Item = std::result::Result<Table, CampaignError>>,
    file: &mut File,
    path: &Path,
) -> std::result::Result<(), CampaignError> {
    let failed = |e: ParquetError| unwritten(e, path);
    let mut out = writer(file, provenance, Which::Whole).map_err(failed)?;
    let mut group = Table::new(&provenance.layout);
    for table in tables {
        add(&mut out, &mut group, &table?, provenance).map_err(failed)?;
    }
    write_group(&mut out, &group).map_err(failed)?;
    finish(out).map(drop).map_err(failed)
}

/// The error of the file system behind one of Parquet.
fn unwritten(error: ParquetError, path: &Path) -> CampaignError {
    match error {
        ParquetError::External(inner) => match inner.downcast::<std::io::Error>() {
            Ok(source) => CampaignError::Write { path: path.into(), source: *source },
            Err(other) => CampaignError::Encode(other.to_string()),
        },
        other => CampaignError::Encode(other.to_string()),
    }
}
