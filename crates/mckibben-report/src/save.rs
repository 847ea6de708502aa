//! Writing a figure to a file.

use std::path::Path;

use crate::{Figure, FigureError};

impl Figure {
    /// Writes the figure to `path` ([`Self::bytes`]), in the place of an older file.
    ///
    /// The content goes to a temporary file in the same folder first and takes the name
    /// only when complete, so a failure leaves an older file as it was.
    ///
    /// # Errors
    /// [`FigureError::NoFolder`] if the folder does not exist, [`FigureError::Write`] if the system refuses, and
    /// those of [`Self::bytes`].
    pub fn save(&self, path: &Path) -> Result<(), FigureError> {
        let folder = match path.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        if !folder.is_dir() {
            return Err(FigureError::NoFolder(folder.to_owned()));
        }
        mckibben_io::files::put(path, &self.bytes(path)?, true)
            .map_err(|source| FigureError::Write(path.to_owned(), source))
    }

    /// What a file of this name has in it; its ending (`.svg`, `.png`, `.pdf`, `.html`) names the format.
    ///
    /// # Errors
    /// [`FigureError::UnknownExtension`] for any other ending, and the errors of drawing.
    pub fn bytes(&self, path: &Path) -> Result<Vec<u8>, FigureError> {
        let ending =
            path.extension().and_then(|e| e.to_str()).map(str::to_ascii_lowercase).unwrap_or_default();
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
