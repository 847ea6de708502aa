//! Parquet → tables.

use super::layout::Field;
use super::provenance::{Provenance, Which};
use super::seal::{self, Broken};
use super::table::{Column, Table};
use crate::Row;
use crate::campaign::CampaignError;
use bytes::Bytes;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{DataType, DoubleType};
use parquet::errors::{ParquetError, Result};
use parquet::file::reader::{FileReader, SerializedFileReader};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A file of a store whose bytes have been checked.
pub(crate) struct Opened {
    pub(crate) provenance: Provenance,
    pub(crate) which: Which,
    path: PathBuf,
    fields: Arc<[Field]>,
    reader: Box<dyn FileReader>,
}

impl Opened {
    /// Opens a file; nothing in it is believed before its seal was compared.
    ///
    /// # Errors
    /// [`CampaignError::Damaged`], [`CampaignError::NoCampaign`], [`CampaignError::Read`].
    pub(crate) fn file(path: &Path) -> std::result::Result<Self, CampaignError> {
        let mut file = File::open(path).map_err(CampaignError::read(path))?;
        let sealed = seal::check(&mut file).map_err(CampaignError::read(path))?;
        sealed.map_err(|broken| match broken {
            Broken::NotParquet => CampaignError::NoCampaign { path: path.into(), why: broken.words().into() },
            _ => CampaignError::damaged(path, broken.words()),
        })?;
        let reader = SerializedFileReader::new(file).map_err(|e| CampaignError::damaged(path, e))?;
        Self::new(Box::new(reader), path)
    }

    /// Opens a part that has not been written yet.
    pub(crate) fn bytes(bytes: Vec<u8>, path: &Path) -> std::result::Result<Self, CampaignError> {
        let reader =
            SerializedFileReader::new(Bytes::from(bytes)).map_err(|e| CampaignError::damaged(path, e))?;
        Self::new(Box::new(reader), path)
    }

    fn new(reader: Box<dyn FileReader>, path: &Path) -> std::result::Result<Self, CampaignError> {
        let metadata = reader.metadata().file_metadata();
        let pairs = metadata.key_value_metadata().cloned().unwrap_or_default();
        let none = |why| CampaignError::NoCampaign { path: path.into(), why };
        let (mut provenance, which) = Provenance::read(&pairs).map_err(none)?;
        let schema = metadata.schema_descr();
        let names: Vec<&str> = schema.columns().iter().map(|c| c.name()).collect();
        provenance.layout.found(&names).map_err(|name| CampaignError::NoCampaign {
            path: path.into(),
            why: format!("its table lacks the column {name}; run the plan again"),
        })?;
        let rows = provenance.rows_of(which);
        if u64::try_from(metadata.num_rows()) != Ok(rows) {
            let why = format!("it holds {} rows instead of {rows}", metadata.num_rows());
            return Err(CampaignError::damaged(path, why));
        }
        let fields = provenance.layout.fields().into();
        Ok(Self { provenance, which, path: path.into(), fields, reader })
    }

    /// Number of row groups.
    pub(crate) fn groups(&self) -> usize {
        self.reader.num_row_groups()
    }

    /// The rows of a group.
    ///
    /// # Errors
    /// [`CampaignError::Damaged`].
    pub(crate) fn group(&self, index: usize) -> std::result::Result<Table, CampaignError> {
        self.read(index).map_err(|e| CampaignError::damaged(&self.path, e))
    }

    fn read(&self, index: usize) -> Result<Table> {
        let group = self.reader.get_row_group(index)?;
        let rows = usize::try_from(group.metadata().num_rows())
            .map_err(|_| ParquetError::General("a group without rows".into()))?;
        let schema = group.metadata().schema_descr();
        let mut columns = vec![];
        for field in self.fields.iter() {
            let at = schema.columns().iter().position(|c| c.name() == field.name);
            let at = at.ok_or_else(|| ParquetError::General(format!("no column {}", field.name)))?;
            columns.push(column(&Column::new(field), group.get_column_reader(at)?, rows)?);
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

fn column(kind: &Column, reader: ColumnReader, rows: usize) -> Result<Column> {
    Ok(match (kind, reader) {
        (Column::Int64(_), ColumnReader::Int64ColumnReader(r)) => Column::Int64(values(r, rows)?),
        (Column::Int32(_), ColumnReader::Int32ColumnReader(r)) => Column::Int32(values(r, rows)?),
        (Column::Double(_), ColumnReader::DoubleColumnReader(r)) => Column::Double(values(r, rows)?),
        (Column::Text(_), ColumnReader::ByteArrayColumnReader(r)) => Column::Text(values(r, rows)?),
        (Column::Optional(_), ColumnReader::DoubleColumnReader(r)) => Column::Optional(optional(r, rows)?),
        _ => return Err(ParquetError::General("a column is of another kind".into())),
    })
}

fn ended(read: usize, rows: usize) -> Result<()> {
    if read == rows { Ok(()) } else { Err(ParquetError::General(format!("{read} rows instead of {rows}"))) }
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
