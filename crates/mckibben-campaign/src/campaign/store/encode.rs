//! Rows → Parquet files.

use super::provenance::VERSION;
use super::{Provenance, Table, Which};
use crate::campaign::CampaignError;
use mckibben_io::parquet::{GROUP, TableError, Writer};
use std::fs::File;
use std::io::Write;
use std::path::Path;

/// A file of a campaign that is being written, row group by row group.
struct Encoder<'a> {
    out: Writer<'a>,
    group: Table,
}

impl<'a> Encoder<'a> {
    fn new(
        sink: &'a mut (dyn Write + Send),
        provenance: &Provenance,
        which: Which,
    ) -> Result<Self, TableError> {
        let fields: Vec<_> = provenance.layout.fields().iter().map(|f| f.parquet()).collect();
        let pairs = provenance.write(which);
        let out = Writer::new(sink, "campaign", &format!("mckibben {VERSION}"), &fields, pairs)?;
        Ok(Self { out, group: Table::new(&provenance.layout) })
    }

    /// Adds a table; a group that is full is written, and the next begins.
    fn add(&mut self, table: &Table) -> Result<(), TableError> {
        let mut from = 0;
        while from < table.rows {
            let to = table.rows.min(from + GROUP - self.group.rows);
            self.group.extend(table, from, to);
            from = to;
            if self.group.rows == GROUP {
                self.write()?;
            }
        }
        Ok(())
    }

    fn write(&mut self) -> Result<(), TableError> {
        if self.group.rows > 0 {
            self.out.group(&self.group.columns)?;
            self.group = self.group.emptied();
        }
        Ok(())
    }

    fn finish(mut self) -> Result<(), TableError> {
        self.write()?;
        self.out.finish()
    }
}

/// A part as the bytes of its file.
pub(crate) fn part(provenance: &Provenance, number: u64, table: &Table) -> Result<Vec<u8>, CampaignError> {
    let mut bytes = vec![];
    let mut encode = || {
        let mut encoder = Encoder::new(&mut bytes, provenance, Which::Part(number))?;
        encoder.add(table)?;
        encoder.finish()
    };
    encode().map_err(|error: TableError| CampaignError::Encode(error.to_string()))?;
    Ok(bytes)
}

/// The whole table into an empty file, group by group; how the tables are cut does not matter.
pub(crate) fn whole(
    provenance: &Provenance,
    tables: impl Iterator<Item = Result<Table, CampaignError>>,
    file: &mut File,
    path: &Path,
) -> Result<(), CampaignError> {
    let failed = |error| match error {
        TableError::Io(source) => CampaignError::Write(path.into(), source),
        TableError::Table(why) => CampaignError::Encode(why),
    };
    let mut encoder = Encoder::new(file, provenance, Which::Whole).map_err(failed)?;
    for table in tables {
        encoder.add(&table?).map_err(failed)?;
    }
    encoder.finish().map_err(failed)
}
