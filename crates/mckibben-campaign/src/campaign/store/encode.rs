//! Rows → Parquet files.

use super::provenance::VERSION;
use super::{Provenance, Table, Which, part_name};
use crate::campaign::{CampaignError, Result};
use mckibben_io::parquet::{GROUP, TableError, Writer};
use std::io::Write;
use std::path::Path;

/// A part as the bytes of its file.
pub(crate) fn part(provenance: &Provenance, number: u64, table: Table) -> Result<Vec<u8>> {
    let mut bytes = vec![];
    let (which, name) = (Which::Part(number), part_name(number));
    write(
        provenance,
        which,
        std::iter::once(Ok(table)),
        &mut bytes,
        Path::new(&name),
    )?;
    Ok(bytes)
}

/// Tables into an empty file, row group by row group; how the tables are cut does not matter.
pub(crate) fn write(
    provenance: &Provenance,
    which: Which,
    tables: impl Iterator<Item = Result<Table>>,
    file: &mut (dyn Write + Send),
    path: &Path,
) -> Result<()> {
    let failed = |error| match error {
        TableError::Io(source) => CampaignError::Write(path.into(), source),
        TableError::Table(why) => CampaignError::Write(path.into(), std::io::Error::other(why)),
    };
    let fields: Vec<_> = provenance
        .layout
        .fields()
        .iter()
        .map(|f| f.parquet())
        .collect();
    let (pairs, program) = (provenance.write(which), format!("mckibben {VERSION}"));
    let mut out = Writer::new(file, "campaign", &program, &fields, pairs).map_err(failed)?;
    let mut group = Table::new(provenance.layout.fields());
    for table in tables {
        let (table, mut from) = (table?, 0);
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
    out.finish().map_err(failed)
}
