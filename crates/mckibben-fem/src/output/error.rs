//! Why a series could not be written.

use std::path::PathBuf;
use thiserror::Error;

/// Why a series could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum VtuError {
    /// The folder cannot be made.
    #[error("the folder {} cannot be made: {source}; give the name of a new folder or of one that exists", folder.display())]
    Folder {
        /// The folder asked for.
        folder: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A file cannot be written.
    #[error("{} cannot be written: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A number that is none.
    #[error("{file} is not written: its {name} holds a value that is no finite number")]
    NotFinite {
        /// The file that would hold it.
        file: String,
        /// The data.
        name: &'static str,
    },
}
