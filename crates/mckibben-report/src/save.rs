//! Writing a figure to a file.

use std::path::Path;

use crate::{Figure, FigureError, Scene};

impl Figure {
    /// Writes the figure to `path`; the ending (`.svg`, `.png`, `.pdf`, `.html`) names the format.
    ///
    /// The content goes to a temporary file in the same folder first and takes the name
    /// only when complete, so a failure leaves an older file as it was.
    ///
    /// # Errors
    /// [`FigureError::UnknownExtension`] for any other ending, [`FigureError::NoFolder`] if
    /// the folder does not exist, [`FigureError::Write`] if the system refuses, and the
    /// errors of drawing.
    pub fn save(&self, path: &Path) -> Result<(), FigureError> {
        whole(path, |ending| match ending {
            "svg" => Some(self.to_svg().map(String::into_bytes)),
            #[cfg(feature = "png")]
            "png" => Some(self.to_png()),
            #[cfg(feature = "png")]
            "pdf" => Some(self.to_pdf()),
            "html" | "htm" => Some(self.to_html().map(String::into_bytes)),
            _ => None,
        })
    }
}

impl Scene {
    /// Writes the picture; the ending (`.svg`, `.png`, `.pdf`) names the format. The file appears whole or not at all.
    pub fn save(&self, path: &Path) -> Result<(), FigureError> {
        whole(path, |ending| match ending {
            "svg" => Some(self.to_svg().map(String::into_bytes)),
            #[cfg(feature = "png")]
            "png" => Some(self.to_png()),
            #[cfg(feature = "png")]
            "pdf" => Some(self.to_pdf()),
            _ => None,
        })
    }
}

/// Writes what `draw` gives for the ending of `path`, whole or not at all.
fn whole(
    path: &Path,
    draw: impl Fn(&str) -> Option<Result<Vec<u8>, FigureError>>,
) -> Result<(), FigureError> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let ending = path.extension().and_then(|e| e.to_str()).map(str::to_ascii_lowercase).unwrap_or_default();
    let known = folder.is_dir().then(|| draw(&ending));
    let bytes = match known {
        None => return Err(FigureError::NoFolder { folder: folder.to_owned() }),
        Some(None) => return Err(FigureError::UnknownExtension { path: path.to_owned() }),
        Some(Some(bytes)) => bytes?,
    };
    mckibben_files::replace(path, &bytes)
        .map_err(|source| FigureError::Write { path: path.to_owned(), source })
}
