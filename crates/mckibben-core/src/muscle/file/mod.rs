//! Muscle files: TOML with quantities as people write them.
//!
//! ```
//! use mckibben_core::muscle::file::{parse_muscle, to_toml};
//! let muscle = parse_muscle("[tube]\nouter_diameter = \"50 mm\"\nwall_thickness = 1\n")?;
//! assert_eq!(muscle.wall_mm(), 1.0);
//! assert_eq!(parse_muscle(&to_toml(&muscle))?, muscle);
//! let error = parse_muscle("[tube]\nwall_thickness = \"-3 mm\"\n").unwrap_err();
//! assert_eq!(
//!     error.to_string(),
//!     "line 2, column 18: tube.wall_thickness = \"-3 mm\": is -3\u{a0}mm; it must be above zero and finite"
//! );
//! # Ok::<(), mckibben_core::muscle::file::FileError>(())
//! ```
//!
//! Whatever is omitted is that of [`Muscle::prototype`]. Unknown keys are errors: a mistyped key
//! must not turn into a default.

mod bench;
mod error;
mod keys;
mod material;
mod read;
mod said;
mod source;
mod table;
mod text;
mod with;
mod write;

#[cfg(test)]
mod bad_files;
#[cfg(test)]
mod tests;

pub use error::{FileError, TextPosition};
pub use keys::{Keys, schema_of};
pub use material::named;
pub use read::{MuscleFile, parse_muscle};
pub use source::{MAX_BYTES, Source};
pub use with::with_keys;
pub use write::to_toml;

use super::Muscle;
use std::{fmt, path::Path, str::FromStr};

/// Reads a muscle file.
///
/// # Errors
/// [`FileError`] with the file's name: what [`parse_muscle`] finds, and whatever keeps the file
/// from being read: it is missing, not a regular file, longer than [`MAX_BYTES`], or not UTF-8.
pub fn read_muscle(path: impl AsRef<Path>) -> Result<Muscle, FileError> {
    let path = path.as_ref();
    read_text(path)
        .and_then(|text| parse_muscle(&text))
        .map_err(|e| e.in_file(path))
}

/// As [`parse_muscle`] reads it.
impl FromStr for Muscle {
    type Err = FileError;

    fn from_str(text: &str) -> Result<Self, FileError> {
        parse_muscle(text)
    }
}

/// The text of its file, as [`to_toml`] writes it.
impl fmt::Display for Muscle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&to_toml(self))
    }
}

/// The text of a file written by hand.
///
/// # Errors
/// [`FileError`], as [`read_muscle`], without the file's name.
pub fn read_text(path: &Path) -> Result<String, FileError> {
    let bytes =
        mckibben_units::read(path, MAX_BYTES as u64).map_err(|e| FileError::new(e.to_string()))?;
    String::from_utf8(bytes).map_err(|e| {
        let offset = e.utf8_error().valid_up_to();
        let bytes = e.as_bytes();
        let utf16 = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
        let place = std::str::from_utf8(&bytes[..offset])
            .ok()
            .map(|t| source::position_at(t, offset));
        let hint = if utf16 {
            " (this looks like UTF-16: save it as UTF-8)"
        } else {
            ""
        };
        let problem = format!("the byte at offset {offset} is not UTF-8 text{hint}");
        FileError {
            place,
            ..FileError::new(problem)
        }
    })
}
