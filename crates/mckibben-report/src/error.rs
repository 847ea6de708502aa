//! What can go wrong when a figure is drawn or saved.

use std::path::PathBuf;

/// Why a figure could not be drawn or saved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// Refused, or not drawn: what, its value, and what it must be.
    #[error("{0}")]
    Drawing(String),
    /// The file name ends in something no writer is known for.
    #[error("unknown format of {}: use a name ending in .svg, .png, .pdf or .html", path.display())]
    UnknownExtension {
        /// The path asked for.
        path: PathBuf,
    },
    /// The folder the file should go to does not exist.
    #[error("the folder {} does not exist", folder.display())]
    NoFolder {
        /// The missing folder.
        folder: PathBuf,
    },
    /// The operating system refused to write the file.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The path asked for.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
}
