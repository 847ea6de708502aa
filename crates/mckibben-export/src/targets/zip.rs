//! ZIP archives: the same files make the same bytes.

use crate::{ExportError, Result};
use std::io::{Cursor, Write as _};
use zip::{CompressionMethod, DateTime, ZipWriter, write::SimpleFileOptions};

/// The bytes of an archive with these files, whose date is the first of 1980.
pub fn zip(files: impl Iterator<Item = (String, Vec<u8>)>) -> Result<Vec<u8>> {
    let fails = |error: &dyn std::fmt::Display| {
        ExportError::Host(format!("the archive cannot be made: {error}"))
    };
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default())
        .unix_permissions(0o644);
    let mut archive = ZipWriter::new(Cursor::new(vec![]));
    for (name, data) in files {
        archive.start_file(name, options).map_err(|e| fails(&e))?;
        archive.write_all(&data).map_err(|e| fails(&e))?;
    }
    Ok(archive.finish().map_err(|e| fails(&e))?.into_inner())
}
