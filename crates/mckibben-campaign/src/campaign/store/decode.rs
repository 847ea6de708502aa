//! Parquet → tables.

use super::bytes::{Pages, Source, foreign_codec, guarded, rows_of, wrong};
use super::layout::Field;
use super::provenance::{Provenance, Which};
use super::seal::{self, Broken};
use super::table::{Column, Table};
use crate::Row;
use crate::campaign::CampaignError;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl, get_column_reader};
use parquet::data_type::{ByteArray, DataType, DoubleType};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::ParquetMetaData;
use parquet::file::serialized_reader::SerializedPageReader;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The longest text of a cell in bytes: causes are sentences.
const TEXT: usize = 4096;

/// A file of a store whose bytes have been checked.
pub(crate) struct Opened {
    pub(crate) provenance: Provenance,
    pub(crate) which: Which,
    path: PathBuf,
    fields: Arc<[Field]>,
    source: Arc<Source>,
    metadata: ParquetMetaData,
}

impl Opened {
    /// Opens a file; no number in it is believed before its seal was compared.
    ///
    /// # Errors
    /// [`CampaignError::Damaged`], [`CampaignError::NoCampaign`], [`CampaignError::Codec`], [`CampaignError::Read`].
    pub(crate) fn file(path: &Path) -> std::result::Result<Self, CampaignError> {
        let mut file = mckibben_files::open(path).map_err(CampaignError::unread(path))?;
        let io = |e: std::io::Error| CampaignError::unread(path)(e.into());
        let broken = |broken: Broken| match broken {
            Broken::NotParquet => CampaignError::NoCampaign { path: path.into(), why: broken.words().into() },
            _ => CampaignError::damaged(path, broken.words()),
        };
        let foreign = || {
            let why = "it is a Parquet file of something else".into();
            CampaignError::NoCampaign { path: path.into(), why }
        };
        let length = file.metadata().map_err(io)?.len();
        let ends = seal::check_ends(&mut file, length).map_err(io)?;
        let source = Source::File { file: file.try_clone().map_err(io)?, length };
        if matches!(ends, Err(Broken::Cut)) && source.begins_with_a_page() {
            return Err(foreign());
        }
        ends.map_err(broken)?;
        let wrong = |e| failed(e, path);
        let footer = source.footer().map_err(wrong)?;
        if !Provenance::is_in(&footer) {
            return Err(foreign());
        }
        let metadata = source.metadata(&footer).map_err(wrong)?;
        seal::check(&mut file).map_err(io)?.map_err(broken)?;
        Self::new(source, metadata, path)
    }

    /// Opens a part that has not been written yet.
    pub(crate) fn bytes(bytes: Vec<u8>, path: &Path) -> std::result::Result<Self, CampaignError> {
        let source = Source::Memory(bytes.into());
        let metadata = source.footer().and_then(|footer| source.metadata(&footer));
        let metadata = metadata.map_err(|e| failed(e, path))?;
        Self::new(source, metadata, path)
    }

    fn new(
        source: Source,
        metadata: ParquetMetaData,
        path: &Path,
    ) -> std::result::Result<Self, CampaignError> {
        let pairs = metadata.file_metadata().key_value_metadata().cloned().unwrap_or_default();
        let none = |why| CampaignError::NoCampaign { path: path.into(), why };
        let (mut provenance, which) = Provenance::read(&pairs).map_err(none)?;
        if let Some(codec) = foreign_codec(&metadata) {
            return Err(CampaignError::Codec { path: path.into(), codec: codec.to_string() });
        }
        let schema = metadata.file_metadata().schema_descr();
        let names: Vec<&str> = schema.columns().iter().map(|c| c.name()).collect();
        provenance.layout.found(&names).map_err(|name| CampaignError::NoCampaign {
            path: path.into(),
            why: format!("its table lacks the column {name}; run the plan again"),
        })?;
        let (rows, there) = (provenance.rows_of(which), metadata.file_metadata().num_rows());
        if u64::try_from(there) != Ok(rows) {
            return Err(CampaignError::damaged(path, format!("it holds {there} rows instead of {rows}")));
        }
        let fields = provenance.layout.fields().into();
        Ok(Self { provenance, which, path: path.into(), fields, source: source.into(), metadata })
    }

    /// Number of row groups.
    pub(crate) fn groups(&self) -> usize {
        self.metadata.num_row_groups()
    }

    /// The rows of a group.
    ///
    /// # Errors
    /// [`CampaignError::Damaged`], [`CampaignError::Read`].
    pub(crate) fn group(&self, index: usize) -> std::result::Result<Table, CampaignError> {
        guarded(|| self.read(index)).map_err(|e| failed(e, &self.path))
    }

    fn read(&self, index: usize) -> Result<Table> {
        let group = self.metadata.row_group(index);
        let rows = rows_of(group)?;
        let schema = group.schema_descr();
        let mut columns = vec![];
        for field in self.fields.iter() {
            let at = schema.columns().iter().position(|c| c.name() == field.name);
            let at = at.ok_or_else(|| ParquetError::General(format!("no column {}", field.name)))?;
            let pages = SerializedPageReader::new(self.source.clone(), group.column(at), rows, None)?;
            let reader = get_column_reader(schema.column(at), Box::new(Pages { inner: pages, rows }));
            columns.push(column(&Column::new(field), reader, rows)?);
        }
        Ok(Table::of(&self.fields, columns, rows))
    }

    /// A row of a table of this file.
    ///
    /// # Errors
    /// [`CampaignError::Damaged`].
    pub(crate) fn row(&self, table: &Table, i: usize) -> std::result::Result<Row, CampaignError> {
        table.row(i).map_err(|e| CampaignError::damaged(&self.path, e))
    }
}

/// What the system does not read is one thing, and what is not as it was written another.
fn failed(error: ParquetError, path: &Path) -> CampaignError {
    match error {
        ParquetError::External(inner) => match inner.downcast::<std::io::Error>() {
            Ok(source) if source.raw_os_error().is_some() => CampaignError::unread(path)((*source).into()),
            Ok(other) => CampaignError::damaged(path, other),
            Err(other) => CampaignError::damaged(path, other),
        },
        ParquetError::General(why) | ParquetError::EOF(why) => CampaignError::damaged(path, why),
        other => CampaignError::damaged(path, other),
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
