//! Tables → Parquet.

use super::{
    column::{Column, Field, Packing},
    error::TableError,
};
use parquet::{
    basic::{Compression, Encoding},
    column::writer::ColumnWriter,
    errors::{ParquetError, Result},
    file::{
        metadata::KeyValue,
        properties::{EnabledStatistics, WriterProperties},
        writer::SerializedFileWriter,
    },
    schema::{parser::parse_message_type, types::ColumnPath},
};
use std::{io::Write, sync::Arc};

/// Most rows of a row group.
pub const GROUP: usize = 1 << 16;
/// How columns are compressed; in Rust alone, so that no compiler of C is needed.
const CODEC: Compression = Compression::LZ4_RAW;

/// Writes a file of Parquet by groups of rows.
pub struct Writer<'a> {
    out: SerializedFileWriter<&'a mut (dyn Write + Send)>,
}

impl<'a> Writer<'a> {
    /// Begins the file of a table; `program` is noted as what made it, with keys and values of
    /// metadata.
    pub fn new(
        sink: &'a mut (dyn Write + Send),
        table: &str,
        program: &str,
        fields: &[Field],
        pairs: Vec<(String, String)>,
    ) -> std::result::Result<Self, TableError> {
        let mut properties = WriterProperties::builder()
            .set_created_by(program.into())
            .set_compression(CODEC);
        for field in fields.iter().filter(|f| f.packing == Packing::Distinct) {
            let path = ColumnPath::from(field.name.as_str());
            properties = properties.set_column_dictionary_enabled(path.clone(), false);
            if matches!(field.kind, Column::Double(_) | Column::Optional(_)) {
                properties = properties.set_column_encoding(path, Encoding::BYTE_STREAM_SPLIT);
            }
        }
        let pairs = pairs
            .into_iter()
            .map(|(key, value)| KeyValue::new(key, value))
            .collect();
        properties = properties
            .set_statistics_enabled(EnabledStatistics::Page)
            .set_key_value_metadata(Some(pairs));
        let line = |f: &Field| {
            let (before, behind) = f.kind.schema();
            format!("  {before} {}{behind};\n", f.name)
        };
        let lines: String = fields.iter().map(line).collect();
        let schema = parse_message_type(&format!("message {table} {{\n{lines}}}"))?;
        Ok(Self {
            out: SerializedFileWriter::new(sink, Arc::new(schema), Arc::new(properties.build()))?,
        })
    }

    /// Writes rows as a group.
    pub fn group(&mut self, columns: &[Column]) -> std::result::Result<(), TableError> {
        let mut group = self.out.next_row_group()?;
        for column in columns {
            let Some(mut writer) = group.next_column()? else {
                break;
            };
            write_column(column, writer.untyped())?;
            writer.close()?;
        }
        group.close()?;
        Ok(())
    }

    /// Writes the end of the file.
    ///
    /// # Errors
    /// [`TableError`] where the file cannot be written.
    pub fn finish(self) -> std::result::Result<(), TableError> {
        self.out.into_inner()?.flush().map_err(TableError::Io)
    }
}

/// The values that are there.
fn there<T: Copy>(values: &[Option<T>]) -> Vec<T> {
    values.iter().flatten().copied().collect()
}

/// Whether each is there.
fn levels<T>(values: &[Option<T>]) -> Vec<i16> {
    values.iter().map(|v| i16::from(v.is_some())).collect()
}

fn write_column(column: &Column, to: &mut ColumnWriter<'_>) -> Result<()> {
    match (column, to) {
        (Column::Int64(v), ColumnWriter::Int64ColumnWriter(w)) => w.write_batch(v, None, None)?,
        (Column::Int32(v), ColumnWriter::Int32ColumnWriter(w)) => w.write_batch(v, None, None)?,
        (Column::Double(v), ColumnWriter::DoubleColumnWriter(w)) => w.write_batch(v, None, None)?,
        (Column::Text(v), ColumnWriter::ByteArrayColumnWriter(w)) => {
            w.write_batch(v, None, None)?
        }
        (Column::Optional(v), ColumnWriter::DoubleColumnWriter(w)) => {
            w.write_batch(&there(v), Some(&levels(v)), None)?
        }
        (Column::Flag(v), ColumnWriter::BoolColumnWriter(w)) => {
            w.write_batch(&there(v), Some(&levels(v)), None)?
        }
        _ => return Err(ParquetError::General("a column of another kind".into())),
    };
    Ok(())
}
