//! Parquet → tables.

use crate::TableError;
use crate::bytes::{Pages, Source, foreign_codec, guarded, rows_of, wrong};
use crate::column::Column;
use crate::seal::{self, Broken};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl, get_column_reader};
use parquet::data_type::{ByteArray, DataType, DoubleType};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::ParquetMetaData;
use parquet::file::serialized_reader::SerializedPageReader;
use std::fs::File;
use std::sync::Arc;
use thiserror::Error;

/// The longest text of a cell in bytes: causes are sentences.
const TEXT: usize = 4096;

/// Why a file is not opened.
#[derive(Debug, Error)]
pub enum OpenError {
    /// The system.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// A Parquet file of something else.
    #[error("it is a Parquet file of something else")]
    Foreign,
    /// Not as it was written.
    #[error("{}", .0.words())]
    Broken(Broken),
    /// Its metadata.
    #[error(transparent)]
    Table(#[from] TableError),
}

/// A file whose bytes have been checked.
pub struct Reader {
    source: Arc<Source>,
    metadata: ParquetMetaData,
}

impl Reader {
    /// Opens a sealed file whose metadata are `ours`; no number in it is believed before its seal was compared.
    pub fn sealed(mut file: File, ours: impl Fn(&[u8]) -> bool) -> std::result::Result<Self, OpenError> {
        let length = file.metadata()?.len();
        let ends = seal::check_ends(&mut file, length)?;
        let source = Source::File { file: file.try_clone()?, length };
        if matches!(ends, Err(Broken::Cut)) && source.begins_with_a_page() {
            return Err(OpenError::Foreign);
        }
        ends.map_err(OpenError::Broken)?;
        let footer = source.footer().map_err(TableError::from)?;
        if !ours(&footer) {
            return Err(OpenError::Foreign);
        }
        let metadata = source.metadata(&footer).map_err(TableError::from)?;
        seal::check(&mut file)?.map_err(OpenError::Broken)?;
        Ok(Self { source: source.into(), metadata })
    }

    /// Opens what was just written to memory.
    pub fn bytes(bytes: Vec<u8>) -> std::result::Result<Self, TableError> {
        let source = Source::Memory(bytes.into());
        let footer = source.footer()?;
        let metadata = source.metadata(&footer)?;
        Ok(Self { source: source.into(), metadata })
    }

    /// Keys and values of its metadata.
    pub fn pairs(&self) -> Vec<(String, String)> {
        let pairs = self.metadata.file_metadata().key_value_metadata().into_iter().flatten();
        pairs.filter_map(|pair| Some((pair.key.clone(), pair.value.clone()?))).collect()
    }

    /// A codec that is not built in, of some column.
    pub fn foreign_codec(&self) -> Option<String> {
        foreign_codec(&self.metadata).map(|codec| codec.to_string())
    }

    /// Names of its columns.
    pub fn names(&self) -> Vec<&str> {
        self.metadata.file_metadata().schema_descr().columns().iter().map(|c| c.name()).collect()
    }

    /// Number of rows, as the metadata say.
    pub fn rows(&self) -> i64 {
        self.metadata.file_metadata().num_rows()
    }

    /// Number of row groups.
    pub fn groups(&self) -> usize {
        self.metadata.num_row_groups()
    }

    /// Columns of a group, and its number of rows.
    pub fn group<'n>(
        &self,
        index: usize,
        columns: impl Iterator<Item = (&'n str, Column)>,
    ) -> std::result::Result<(Vec<Column>, usize), TableError> {
        Ok(guarded(|| {
            let group = self.metadata.row_group(index);
            let rows = rows_of(group)?;
            let schema = group.schema_descr();
            let mut out = vec![];
            for (name, kind) in columns {
                let at = schema.columns().iter().position(|c| c.name() == name);
                let at = at.ok_or_else(|| ParquetError::General(format!("no column {name}")))?;
                let pages = SerializedPageReader::new(self.source.clone(), group.column(at), rows, None)?;
                let reader = get_column_reader(schema.column(at), Box::new(Pages { inner: pages, rows }));
                out.push(column(&kind, reader, rows)?);
            }
            Ok((out, rows))
        })?)
    }
}

fn column(kind: &Column, reader: ColumnReader, rows: usize) -> Result<Column> {
    Ok(match (kind, reader) {
        (Column::Int64(_), ColumnReader::Int64ColumnReader(r)) => Column::Int64(values(r, rows)?),
        (Column::Int32(_), ColumnReader::Int32ColumnReader(r)) => Column::Int32(values(r, rows)?),
        (Column::Double(_), ColumnReader::DoubleColumnReader(r)) => Column::Double(values(r, rows)?),
        (Column::Text(_), ColumnReader::ByteArrayColumnReader(r)) => Column::Text(texts(values(r, rows)?)?),
        (Column::Optional(_), ColumnReader::DoubleColumnReader(r)) => Column::Optional(optional(r, rows)?),
        _ => return wrong("a column is of another kind"),
    })
}

fn texts(list: Vec<ByteArray>) -> Result<Vec<ByteArray>> {
    match list.iter().map(ByteArray::len).max() {
        Some(longest) if longest > TEXT => wrong(format!("a text of {longest} bytes in a cell")),
        _ => Ok(list),
    }
}

fn ended(read: usize, rows: usize) -> Result<()> {
    if read == rows { Ok(()) } else { wrong(format!("{read} rows instead of {rows}")) }
}

fn values<T: DataType>(mut reader: ColumnReaderImpl<T>, rows: usize) -> Result<Vec<T::T>> {
    let mut out = Vec::with_capacity(rows);
    while out.len() < rows {
        if reader.read_records(rows - out.len(), None, None, &mut out)?.0 == 0 {
            break;
        }
    }
    ended(out.len(), rows)?;
    Ok(out)
}

fn optional(mut reader: ColumnReaderImpl<DoubleType>, rows: usize) -> Result<Vec<Option<f64>>> {
    let (mut there, mut out) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
    while there.len() < rows {
        if reader.read_records(rows - there.len(), Some(&mut there), None, &mut out)?.0 == 0 {
            break;
        }
    }
    ended(there.len(), rows)?;
    let mut left = out.into_iter();
    Ok(there.into_iter().map(|d| if d == 1 { left.next() } else { None }).collect())
}
