//! Reads a campaign: one file, or a folder of parts.

use super::CampaignError;
use super::merge::{gather, tables};
use super::store::{Opened, PartSource, Provenance, Table, Which};
use crate::PointRow;
use std::path::{Path, PathBuf};

/// The rows of a campaign one after another; holds one group of them at a time.
pub struct Rows {
    /// Where they come from.
    provenance: Provenance,
    path: PathBuf,
    tables: Box<dyn Iterator<Item = Result<Table, CampaignError>>>,
    table: Option<Table>,
    at: usize,
    failed: bool,
}

impl std::fmt::Debug for Rows {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Rows").field("provenance", &self.provenance).finish_non_exhaustive()
    }
}

impl Rows {
    /// Where they come from.
    pub fn provenance(&self) -> &Provenance {
        &self.provenance
    }
}

impl Iterator for Rows {
    type Item = Result<PointRow, CampaignError>;

    fn next(&mut self) -> Option<Self::Item> {
        while !self.failed {
            if let Some(table) = self.table.as_ref().filter(|t| self.at < t.rows) {
                self.at += 1;
                let row = table.row(self.at - 1).map_err(|e| CampaignError::damaged(&self.path, e));
                self.failed = row.is_err();
                return Some(row);
            }
            match self.tables.next()? {
                Ok(table) => (self.table, self.at) = (Some(table), 0),
                Err(error) => {
                    self.failed = true;
                    return Some(Err(error));
                }
            }
        }
        None
    }
}

/// Opens a campaign, file or folder of parts, for reading row by row.
pub fn rows(path: impl AsRef<Path>) -> Result<Rows, CampaignError> {
    let path = path.as_ref();
    let (provenance, tables): (_, Box<dyn Iterator<Item = _>>) = if path.is_dir() {
        let (provenance, found) = gather(&[PathBuf::from(path)])?;
        let of = provenance.clone();
        let mut parts = found.into_iter();
        let next = move || parts.next().map(|(n, path)| part_tables(&of, n, path));
        (provenance, Box::new(std::iter::from_fn(next).flatten()))
    } else {
        let opened = Opened::file(path)?;
        if opened.which != Which::Whole {
            let why = "it is one part of a campaign: give the folder".into();
            return Err(CampaignError::NoCampaign(path.into(), why));
        }
        (opened.provenance.clone(), Box::new((0..opened.groups()).map(move |g| opened.group(g))))
    };
    Ok(Rows { provenance, path: path.into(), tables, table: None, at: 0, failed: false })
}

fn part_tables(of: &Provenance, number: u64, path: PathBuf) -> Vec<Result<Table, CampaignError>> {
    tables(of, std::iter::once((number, PartSource::File(path)))).collect()
}

/// All rows of a campaign, file or folder of parts.
pub fn read(path: impl AsRef<Path>) -> Result<Vec<PointRow>, CampaignError> {
    rows(path)?.collect()
}
