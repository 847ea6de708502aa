//! Reads a campaign: one file, or a folder of parts.

use super::{
    file::{Opened, chained},
    merge::Parts,
    provenance::Provenance,
};
use crate::{
    campaign::error::{CampaignError, Result},
    columns::PointRow,
};
use std::path::Path;

/// The rows of a campaign one after another; holds one group of them at a time.
pub struct Rows {
    /// Where they come from.
    pub provenance: Provenance,
    rows: Box<dyn Iterator<Item = Result<PointRow>>>,
}

impl Iterator for Rows {
    type Item = Result<PointRow>;

    fn next(&mut self) -> Option<Self::Item> {
        self.rows.next()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (0, usize::try_from(self.provenance.points()).ok())
    }
}

/// Opens a campaign, file or folder of parts, for reading row by row.
pub fn rows(path: impl AsRef<Path>) -> Result<Rows> {
    let path = path.as_ref();
    if path.is_dir() {
        let parts = Parts::gather(&[path.into()])?;
        return Ok(Rows {
            provenance: parts.provenance.clone(),
            rows: Box::new(chained(parts.opened(), Opened::rows)),
        });
    }
    let opened = Opened::file(path)?;
    if opened.part.is_some() {
        let why = "it is one part of a campaign: give the folder".into();
        return Err(CampaignError::NoCampaign(path.into(), why));
    }
    Ok(Rows {
        provenance: opened.provenance.clone(),
        rows: Box::new(opened.rows()),
    })
}
