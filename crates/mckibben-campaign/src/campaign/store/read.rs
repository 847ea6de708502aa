//! Reads a campaign: one file, or a folder of parts.

use super::merge::gather;
use super::{Opened, PartSource, Provenance, Which, flat};
use crate::PointRow;
use crate::campaign::{CampaignError, Result};
use std::path::{Path, PathBuf};

/// The rows of a campaign one after another; holds one group of them at a time. An error is the
/// last of them.
pub struct Rows {
    /// Where they come from.
    pub provenance: Provenance,
    rows: Box<dyn Iterator<Item = Result<PointRow>>>,
}

impl Iterator for Rows {
    type Item = Result<PointRow>;

    fn next(&mut self) -> Option<Self::Item> {
        let row = self.rows.next();
        if let Some(Err(_)) = row {
            self.rows = Box::new(std::iter::empty());
        }
        row
    }
}

/// Opens a campaign, file or folder of parts, for reading row by row.
pub fn rows(path: impl AsRef<Path>) -> Result<Rows> {
    let path = path.as_ref();
    let (provenance, files): (_, Box<dyn Iterator<Item = Result<Opened>>>) = if path.is_dir() {
        let (provenance, parts) = gather(&[path.into()])?;
        let expected = provenance.clone();
        let open =
            move |(number, path): (u64, PathBuf)| PartSource::File(path).open(number, &expected);
        (provenance, Box::new(parts.into_iter().map(open)))
    } else {
        let opened = Opened::file(path)?;
        if opened.which != Which::Whole {
            let why = "it is one part of a campaign: give the folder".into();
            return Err(CampaignError::NoCampaign(path.into(), why));
        }
        (
            opened.provenance.clone(),
            Box::new(std::iter::once(Ok(opened))),
        )
    };
    Ok(Rows {
        provenance,
        rows: Box::new(flat(files, Opened::rows)),
    })
}

/// All rows of a campaign, file or folder of parts.
pub fn read(path: impl AsRef<Path>) -> Result<Vec<PointRow>> {
    rows(path)?.collect()
}
