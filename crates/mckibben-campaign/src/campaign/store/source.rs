//! Where a part is before it is merged.

use super::{Opened, part_name};
use crate::campaign::CampaignError;
use std::path::{Path, PathBuf};

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
