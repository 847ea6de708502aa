//! What is asked of a key beyond its type, and the error that names it.

use crate::error::MotionError;
use mckibben::muscle::file::{FileError, Problem, Section};
use mckibben::units::Dimension;

pub(super) fn said(section: &Section<'_>, key: &str, text: impl Into<String>) -> FileError {
    section.error(key, Problem::Said(text.into()))
}

/// A quantity above zero.
pub(super) fn above(
    section: &Section<'_>,
    key: &str,
    dimension: Dimension,
) -> Result<Option<f64>, FileError> {
    match section.quantity(key, dimension)? {
        Some(value) if value <= 0.0 => Err(said(section, key, "must be above zero")),
        value => Ok(value),
    }
}

/// What the crate itself says of a number, at its key.
pub(super) fn at<T>(
    section: &Section<'_>,
    key: &str,
    result: Result<T, MotionError>,
) -> Result<T, FileError> {
    result.map_err(|error| said(section, key, format!("is invalid: {error}")))
}
