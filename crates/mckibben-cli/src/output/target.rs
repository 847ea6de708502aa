//! Where a result goes.

use std::path::Path;

/// Where a result goes.
#[derive(Debug, Clone, Copy)]
pub struct Target<'a> {
    /// The file; else standard output.
    pub path: Option<&'a Path>,
    /// An existing file is overwritten.
    pub overwrite: bool,
}

impl<'a> Target<'a> {
    pub const STDOUT: Target<'static> = Target { path: None, overwrite: false };

    pub fn file(path: &'a Path, overwrite: bool) -> Self {
        Self { path: Some(path), overwrite }
    }
}
