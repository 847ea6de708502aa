//! Parquet files → rows.

use super::{Field, Provenance, Table, Which, part_name};
use crate::PointRow;
use crate::campaign::CampaignError;
use mckibben_io::files::ReadError;
use mckibben_io::parquet::{Reader, TableError};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The longest file of a campaign in bytes.
const MAX_BYTES: u64 = 64 << 30;

/// A file of a store whose metadata are read.
pub(crate) struct Opened {
    pub(crate) provenance: Provenance,
    pub(crate) which: Which,
    path: PathBuf,
    fields: Arc<[Field]>,
    reader: Reader,
}

impl Opened {
    pub(crate) fn file(path: &Path) -> Result<Self, CampaignError> {
        let file = mckibben_io::files::open(path).map_err(CampaignError::unread(path))?;
        if file.metadata().map_err(CampaignError::read(path))?.len() > MAX_BYTES {
            return Err(CampaignError::unread(path)(ReadError::TooLarge { limit: MAX_BYTES }));
        }
        Self::new(Reader::file(file).map_err(|error| failed(error, path))?, path)
    }

    /// Opens a part that has not been written yet.
    pub(crate) fn bytes(bytes: Vec<u8>, path: &Path) -> Result<Self, CampaignError> {
        Self::new(Reader::bytes(bytes).map_err(|error| failed(error, path))?, path)
    }

    fn new(reader: Reader, path: &Path) -> Result<Self, CampaignError> {
        let none = |why| CampaignError::NoCampaign(path.into(), why);
        let (provenance, which) = Provenance::read(&reader.pairs()).map_err(none)?;
        if let Some(name) = provenance.layout.lacks(&reader.names()) {
            return Err(none(format!("its table lacks the column {name}; run the plan again")));
        }
        let (rows, there) = (provenance.rows_of(which), reader.rows());
        if u64::try_from(there) != Ok(rows) {
            return Err(CampaignError::damaged(path, format!("it has {there} rows instead of {rows}")));
        }
        let fields = provenance.layout.fields().into();
        Ok(Self { provenance, which, path: path.into(), fields, reader })
    }

    /// The same, if all its groups are read without an error.
    pub(crate) fn checked(self) -> Result<Self, CampaignError> {
        (0..self.groups()).try_for_each(|index| self.group(index).map(drop))?;
        Ok(self)
    }

    /// Number of row groups.
    pub(crate) fn groups(&self) -> usize {
        self.reader.groups()
    }

    /// The rows of a group.
    pub(crate) fn group(&self, index: usize) -> Result<Table, CampaignError> {
        let columns = self.fields.iter().map(|field| (field.name.as_str(), field.kind()));
        let (columns, rows) = self.reader.group(index, columns).map_err(|error| failed(error, &self.path))?;
        Ok(Table::of(&self.fields, columns, rows))
    }

    /// A row of a table of this file.
    pub(crate) fn row(&self, table: &Table, i: usize) -> Result<PointRow, CampaignError> {
        table.row(i).map_err(|e| CampaignError::damaged(&self.path, e))
    }
}

/// What the system does not read is one thing, and what is not as it was written another.
fn failed(error: TableError, path: &Path) -> CampaignError {
    match error {
        TableError::Io(source) if source.raw_os_error().is_some() => {
            CampaignError::unread(path)(source.into())
        }
        other => CampaignError::damaged(path, other),
    }
}

#[derive(Debug)]
pub(in crate::campaign) enum PartSource {
    File(PathBuf),
    /// In memory, as the bytes of its file.
    Memory(Vec<u8>),
}

impl PartSource {
    pub(in crate::campaign) fn open(self, number: u64) -> Result<Opened, CampaignError> {
        match self {
            PartSource::File(path) => Opened::file(&path),
            PartSource::Memory(bytes) => Opened::bytes(bytes, Path::new(&part_name(number))),
        }
    }
}
