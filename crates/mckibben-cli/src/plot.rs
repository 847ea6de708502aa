//! Figures into files.

use crate::failure::Failure;
use crate::files;
use crate::output::{ending, of_input};
use mckibben_app::ProblemKind;
use mckibben_report::{Figure, FigureError};
use std::path::Path;

/// Refuses a figure that could not be written, before any work is done for it.
pub fn check(path: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = path else { return Ok(()) };
    if ending(path).is_some_and(|e| ["svg", "png", "html", "htm"].contains(&e.as_str())) {
        return Ok(());
    }
    Err(FigureError::UnknownExtension { path: path.to_owned() }.into())
}

/// Writes a figure, where there is one and a file is named for it.
pub fn save(figure: Option<Figure>, path: Option<&Path>) -> Result<(), Failure> {
    match (figure, path) {
        (Some(figure), Some(path)) => {
            unread(path)?;
            Ok(figure.save(path)?)
        }
        _ => Ok(()),
    }
}

/// Refuses a file that this command has read, by any name. Other existing files were checked before the work (`overlap`).
pub fn unread(path: &Path) -> Result<(), Failure> {
    if files::was_read(path) { Err(of_input(path)) } else { Ok(()) }
}

impl From<FigureError> for Failure {
    fn from(error: FigureError) -> Self {
        Self::input(ProblemKind::Output, error.to_string(), "")
    }
}
