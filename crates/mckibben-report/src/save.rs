//! A figure as the bytes of a file.

use crate::figure::{Figure, FigureError, Result};
use std::path::Path;

impl Figure {
    /// The bytes of a file of this name; its ending (`.svg`, `.png`, `.pdf`, `.html`) names the
    /// format.
    ///
    /// # Errors
    /// [`FigureError::UnknownExtension`] for any other ending, and the errors of drawing.
    pub fn bytes(&self, path: &Path) -> Result<Vec<u8>> {
        let ending = path
            .extension()
            .and_then(|e| e.to_str())
            .map(str::to_ascii_lowercase)
            .unwrap_or_default();
        Ok(match &*ending {
            "svg" => self.to_svg()?.into_bytes(),
            #[cfg(feature = "png")]
            "png" => self.to_png()?,
            #[cfg(feature = "png")]
            "pdf" => self.to_pdf()?,
            "html" | "htm" => self.to_html()?.into_bytes(),
            _ => return Err(FigureError::UnknownExtension(path.to_owned())),
        })
    }
}
