//! One file of a store, the whole table or one part of it: tables of rows → Parquet → tables of
//! rows.

use super::{
    folder::part_name,
    layout::Field,
    provenance::{Provenance, VERSION},
    seal::{checksum, seal},
    table::Table,
};
use crate::{
    campaign::error::{CampaignError, Result},
    columns::PointRow,
};
use mckibben_io::{
    files::{ReadError, open},
    parquet::{GROUP, Reader, TableError, Writer},
};
use std::{
    io::{Cursor, Read, Seek, Write},
    path::{Path, PathBuf},
    sync::Arc,
};

/// The longest file of a campaign in bytes.
const MAX_BYTES: u64 = 64 << 30;

/// A file of a store whose metadata are read.
pub struct Opened {
    pub provenance: Provenance,
    /// The part that it holds; `None` of the whole table.
    pub part: Option<u64>,
    path: PathBuf,
    fields: Arc<[Field]>,
    reader: Reader,
    pub checksum: String,
}

impl Opened {
    /// A file whose bytes are those that were written.
    pub fn file(path: &Path) -> Result<Self> {
        let mut file = open(path).map_err(CampaignError::read(path))?;
        if file.metadata().map_err(CampaignError::read(path))?.len() > MAX_BYTES {
            return Err(CampaignError::read(path)(ReadError::TooLarge {
                limit: MAX_BYTES,
            }));
        }
        let found = checksum(&mut file).map_err(CampaignError::read(path))?;
        let changed = || CampaignError::damaged(path, "its checksum does not match");
        if matches!(found, Some((_, _, false))) {
            return Err(changed());
        }
        let reader = Reader::new(file).map_err(|error| undecoded(error, path))?;
        let none = |why| CampaignError::NoCampaign(path.into(), why);
        let (provenance, part) = Provenance::read(&reader.pairs()).map_err(none)?;
        let (_, checksum, _) = found.ok_or_else(changed)?;
        let fields = provenance.layout.fields();
        let (rows, actual) = (provenance.rows_of(part), reader.rows());
        if u64::try_from(actual) != Ok(rows) {
            return Err(CampaignError::damaged(
                path,
                format!("it has {actual} rows instead of {rows}"),
            ));
        }
        Ok(Self {
            provenance,
            part,
            path: path.into(),
            fields,
            reader,
            checksum,
        })
    }

    /// The same, if it is this share of a campaign.
    pub fn expect(self, part: Option<u64>, of: &Provenance) -> Result<Self> {
        of.check_same(&self.provenance, &self.path)?;
        let why = match part {
            None => "it contains only a part of the campaign",
            Some(_) => "it contains a different part from its name",
        };
        if self.part == part {
            Ok(self)
        } else {
            Err(CampaignError::damaged(&self.path, why))
        }
    }

    /// Its tables, one for each group of rows.
    pub fn tables(self) -> impl Iterator<Item = Result<Table>> {
        (0..self.reader.groups()).map(move |index| self.group(index))
    }

    pub fn rows(self) -> impl Iterator<Item = Result<PointRow>> {
        let path: Arc<Path> = self.path.as_path().into();
        chained(self.tables(), move |table| {
            let path = path.clone();
            let damaged = move |error| CampaignError::damaged(&path, error);
            (0..table.rows).map(move |i| table.row(i).map_err(&damaged))
        })
    }

    fn group(&self, index: usize) -> Result<Table> {
        let columns = self.fields.iter().map(|f| (f.name.as_str(), f.kind()));
        let (columns, rows) = self
            .reader
            .group(index, columns)
            .map_err(|error| undecoded(error, &self.path))?;
        Ok(Table {
            fields: self.fields.clone(),
            columns,
            rows,
        })
    }
}

/// The parts of each, one after another; an error stays one.
pub fn chained<A, B, Parts: Iterator<Item = Result<B>>>(
    wholes: impl Iterator<Item = Result<A>>,
    parts: impl Fn(A) -> Parts,
) -> impl Iterator<Item = Result<B>> {
    wholes.flat_map(move |whole| {
        let (parts, error) = match whole {
            Ok(whole) => (Some(parts(whole)), None),
            Err(error) => (None, Some(Err(error))),
        };
        parts.into_iter().flatten().chain(error)
    })
}

/// A file that the system does not read, or one that is not as it was written.
fn undecoded(error: TableError, path: &Path) -> CampaignError {
    match error {
        TableError::Io(source) if source.raw_os_error().is_some() => {
            CampaignError::read(path)(source)
        }
        TableError::Foreign(why) => CampaignError::NoCampaign(path.into(), why),
        other => CampaignError::damaged(path, other),
    }
}

/// A part as the bytes of its file.
pub fn part(provenance: &Provenance, number: u64, table: Table) -> Result<Vec<u8>> {
    let mut bytes = Cursor::new(vec![]);
    let name = part_name(number);
    let tables = std::iter::once(Ok(table));
    write(provenance, Some(number), tables, &mut bytes, name.as_ref())?;
    Ok(bytes.into_inner())
}

/// Tables into an empty file, row group by row group; how the tables are cut does not matter.
pub fn write(
    provenance: &Provenance,
    part: Option<u64>,
    tables: impl Iterator<Item = Result<Table>>,
    file: &mut (impl Read + Write + Seek + Send),
    path: &Path,
) -> Result<()> {
    let failed = |error| match error {
        TableError::Io(source) => CampaignError::Write(path.into(), source),
        other => CampaignError::Write(path.into(), std::io::Error::other(other.to_string())),
    };
    let mut group = Table::new(provenance.layout.fields());
    let fields: Vec<_> = group.fields.iter().map(Field::parquet).collect();
    let pairs = provenance
        .write(part)
        .map_err(|e| failed(TableError::Io(e.into())))?;
    let program = format!("mckibben {VERSION}");
    let mut out = Writer::new(file, "campaign", &program, &fields, pairs).map_err(failed)?;
    for table in tables {
        let table = table?;
        let mut from = 0;
        while from < table.rows {
            let to = table.rows.min(from + GROUP - group.rows);
            group.extend(&table, from, to);
            from = to;
            if group.rows == GROUP {
                out.group(&group.columns).map_err(failed)?;
                group = Table::new(group.fields);
            }
        }
    }
    if group.rows > 0 {
        out.group(&group.columns).map_err(failed)?;
    }
    out.finish().map_err(failed)?;
    seal(file).map_err(|error| failed(TableError::Io(error)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Error, ErrorKind};

    /// A damaged part is computed again and may be overwritten; one that the system does not read
    /// (errno 5, EIO) may be whole.
    #[test]
    fn what_the_system_does_not_read_is_not_called_damaged() {
        let path = Path::new("part-000003.parquet");
        let unread = undecoded(TableError::Io(Error::from_raw_os_error(5)), path);
        assert!(matches!(unread, CampaignError::Read { .. }), "{unread}");
        assert!(unread.hint().contains("not necessarily damaged"));
        for error in [
            TableError::Table("a column is of another kind".into()),
            // Of the decoder, not of the system.
            TableError::Io(Error::new(ErrorKind::UnexpectedEof, "the end is missing")),
        ] {
            let damaged = undecoded(error, path);
            assert!(
                matches!(damaged, CampaignError::Damaged { .. }),
                "{damaged}"
            );
        }
    }
}
