//! Tables in files of other programs.

use crate::{Problem, ProblemKind, Result, TextFile};
use mckibben_io::files::{ReadError, read};
use mckibben_io::table::{MAX_BYTES, read_text};
use std::{io::ErrorKind, path::Path};

impl TextFile {
    /// A table, whatever program wrote it, or the sheet of a workbook: `bench.xlsx#Sheet 2`. Its name also says what it was read from, where that is
    /// not UTF-8. Such files may be long.
    pub fn table(path: &Path) -> Result<Self> {
        let name = path.display().to_string();
        let (file, sheet) = match name.rsplit_once('#') {
            Some((file, sheet)) if !path.exists() => (file, Some(sheet)),
            _ => (&*name, None),
        };
        let unread = |error: ReadError| {
            let hint = match &error {
                ReadError::System(e) if e.kind() != ErrorKind::NotFound => {
                    "the operating system refused to read it; it is not necessarily damaged"
                }
                _ => "",
            };
            Problem::new(ProblemKind::File, format!("{file} {error}"), hint)
        };
        let bytes = read(Path::new(file), MAX_BYTES as u64).map_err(unread)?;
        let (text, from) = read_text(&bytes, sheet).map_err(|error| Problem::of_table(&name, &error))?;
        let from = from.map_or_else(String::new, |from| format!(" ({from})"));
        Ok(Self { name: format!("{file}{from}"), text })
    }
}
