//! Parquet files → rows.

use super::resume::belongs;
use super::{Field, Provenance, Table, Which, part_name};
use crate::PointRow;
use crate::campaign::{CampaignError, Result};
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
    pub(crate) fn file(path: &Path) -> Result<Self> {
        let file = mckibben_io::files::open(path).map_err(CampaignError::unread(path))?;
        if file.metadata().map_err(CampaignError::read(path))?.len() > MAX_BYTES {
            return Err(CampaignError::unread(path)(ReadError::TooLarge {
                limit: MAX_BYTES,
            }));
        }
        Self::new(
            Reader::file(file).map_err(|error| failed(error, path))?,
            path,
        )
    }

    /// Opens a part that has not been written yet.
    pub(crate) fn bytes(bytes: Vec<u8>, path: &Path) -> Result<Self> {
        Self::new(
            Reader::bytes(bytes).map_err(|error| failed(error, path))?,
            path,
        )
    }

    fn new(reader: Reader, path: &Path) -> Result<Self> {
        let none = |why| CampaignError::NoCampaign(path.into(), why);
        let (provenance, which) = Provenance::read(&reader.pairs()).map_err(none)?;
        if let Some(name) = provenance.layout.lacks(&reader.names()) {
            return Err(none(format!(
                "its table lacks the column {name}; run the plan again"
            )));
        }
        let (rows, actual) = (provenance.rows_of(which), reader.rows());
        if u64::try_from(actual) != Ok(rows) {
            return Err(CampaignError::damaged(
                path,
                format!("it has {actual} rows instead of {rows}"),
            ));
        }
        let fields = provenance.layout.fields();
        Ok(Self {
            provenance,
            which,
            path: path.into(),
            fields,
            reader,
        })
    }

    /// The same, if all its groups are read without an error.
    pub(crate) fn checked(self) -> Result<Self> {
        (0..self.reader.groups()).try_for_each(|index| self.group(index).map(drop))?;
        Ok(self)
    }

    /// The same, if it is this share of a campaign.
    pub(crate) fn expect(self, which: Which, of: &Provenance) -> Result<Self> {
        belongs(&self.provenance, of, &self.path)?;
        let why = match which {
            Which::Whole => "it contains only a part of the campaign",
            Which::Part(_) => "it contains a different part from its name",
        };
        if self.which == which {
            Ok(self)
        } else {
            Err(CampaignError::damaged(&self.path, why))
        }
    }

    /// Its tables, one for each group of rows.
    pub(crate) fn tables(self) -> impl Iterator<Item = Result<Table>> {
        (0..self.reader.groups()).map(move |index| self.group(index))
    }

    pub(crate) fn rows(self) -> impl Iterator<Item = Result<PointRow>> {
        let path = self.path.clone();
        flat(self.tables(), move |table| {
            let path = path.clone();
            (0..table.rows).map(move |i| {
                table
                    .row(i)
                    .map_err(|error| CampaignError::damaged(&path, error))
            })
        })
    }

    fn group(&self, index: usize) -> Result<Table> {
        let columns = self
            .fields
            .iter()
            .map(|field| (field.name.as_str(), field.kind()));
        let (columns, rows) = self
            .reader
            .group(index, columns)
            .map_err(|error| failed(error, &self.path))?;
        Ok(Table {
            fields: self.fields.clone(),
            columns,
            rows,
        })
    }
}

/// The parts of each, one after another; an error stays one.
pub(in crate::campaign) fn flat<A, B, Parts: Iterator<Item = Result<B>>>(
    wholes: impl Iterator<Item = Result<A>>,
    parts: impl Fn(A) -> Parts,
) -> impl Iterator<Item = Result<B>> {
    wholes.flat_map(move |whole| {
        let (whole, error) =
            whole.map_or_else(|error| (None, Some(error)), |whole| (Some(whole), None));
        whole
            .map(&parts)
            .into_iter()
            .flatten()
            .chain(error.map(Err))
    })
}

/// A file that the system does not read, or one that is not as it was written.
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
    pub(in crate::campaign) fn open(self, number: u64, of: &Provenance) -> Result<Opened> {
        let opened = match self {
            PartSource::File(path) => Opened::file(&path),
            PartSource::Memory(bytes) => Opened::bytes(bytes, Path::new(&part_name(number))),
        };
        opened?.expect(Which::Part(number), of)
    }
}
