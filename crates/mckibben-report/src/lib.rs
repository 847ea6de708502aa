//! Figures for papers, pages and the terminal.
//!
//! A [`Figure`] describes panels with axes, series and marks; the crate turns it into
//! SVG ([`Figure::to_svg`]), PNG ([`Figure::to_png`]), a self-contained HTML page
//! ([`Figure::to_html`]) or a chart of characters ([`Figure::to_text`]), or writes it to a
//! file ([`Figure::save`]). It knows nothing about muscles: quantities and units are texts
//! of the caller. The same description gives the same bytes on every machine; the font
//! (DejaVu Sans) is part of the program.

mod axes;
mod curve;
mod error;
mod figure;
mod font;
mod html;
mod labels;
mod layout;
mod legend;
mod line_labels;
mod palette;
mod png;
mod room;
mod save;
mod scene;
mod strokes;
mod svg;
mod text;
mod text_chart;
mod text_legend;
mod text_lines;
mod ticks;
mod xml;

pub use error::FigureError;
pub use figure::{Axis, Figure, Mark, Palette, Panel, Series, Style};
pub use scene::{Face, Scene, Thread, View};
