//! Figures for papers and pages.
//!
//! A [`Figure`] describes panels with axes, series and marks. It is plain data (serde), so that a
//! page or another language can draw it; the crate turns it into SVG ([`Figure::to_svg`]) or a
//! self-contained HTML page ([`Figure::to_html`]). It knows nothing about muscles: quantities and
//! units are texts of the caller. The same description gives the same bytes on every machine; the
//! font (DejaVu Sans) is part of the program.
//!
//! The feature `png`, on by default, adds `to_png` and `to_pdf`. Without it the crate builds for
//! `wasm32-unknown-unknown`.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod axes;
mod curve;
mod data;
mod document;
mod draw;
mod drawing;
mod figure;
mod font;
mod labels;
mod layout;
mod legend;
mod line_labels;
#[cfg(feature = "png")]
mod pages;
mod palette;
#[cfg(feature = "png")]
mod pdf;
#[cfg(feature = "png")]
mod png;
mod rect;
mod room;
mod sheet;
#[doc(hidden)]
pub mod smooth;
mod svg;
#[doc(hidden)]
pub mod ticks;

#[doc(hidden)]
pub use axes::extents;
pub use document::{Document, Part};
pub use drawing::Anchor;
pub use figure::{Axis, Figure, FigureError, Mark, Palette, Panel, Series, Style};
pub use sheet::{DrawingSheet, Pen};
