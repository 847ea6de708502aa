//! What can go wrong when a figure is drawn or saved.

use std::path::PathBuf;

/// Why a figure could not be drawn or saved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// The figure holds no panel, so there is nothing to draw.
    #[error("the figure \"{title}\" has no panel to draw")]
    NoPanels {
        /// Title of the figure.
        title: String,
    },
    /// The range asked for an axis is not an interval of finite numbers with a length.
    #[error("axis \"{axis}\": {low} to {high} is not a range that can be drawn")]
    AxisRange {
        /// Label of the axis.
        axis: String,
        /// Lower end asked for, in the unit of the axis.
        low: f64,
        /// Upper end asked for, in the unit of the axis.
        high: f64,
    },
    /// The paper size is not usable (each side must be between 20 mm and 2000 mm).
    #[error("a figure of {width_mm} mm × {height_mm} mm cannot be drawn (20 to 2000 mm a side)")]
    PaperSize {
        /// Width asked for, mm.
        width_mm: f64,
        /// Height asked for, mm.
        height_mm: f64,
    },
    /// The panels do not fit on the paper with readable text.
    #[error(
        "panel {panel} of the figure \"{title}\" would be only {width_mm:.0} mm × {height_mm:.0} mm; \
         make the figure larger or use fewer columns"
    )]
    PanelTooSmall {
        /// Title of the figure.
        title: String,
        /// Number of the panel, counted from 1.
        panel: usize,
        /// Width left for its data, mm.
        width_mm: f64,
        /// Height left for its data, mm.
        height_mm: f64,
    },
    /// A drawing with places that are no numbers.
    #[error("a place of the drawing \"{title}\" is not a finite number")]
    NotFinite {
        /// Title of the drawing.
        title: String,
    },
    /// The embedded font could not be read (a fault of this build, not of the figure).
    #[error("the embedded font cannot be read: {reason}")]
    Font {
        /// What the font reader said.
        reason: String,
    },
    /// The drawing could not be turned into pixels.
    #[error("the figure cannot be turned into an image: {reason}")]
    Raster {
        /// What the renderer said.
        reason: String,
    },
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
