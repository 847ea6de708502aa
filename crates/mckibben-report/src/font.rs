//! The embedded font: the width of texts set in it.

use crate::figure::{FigureError, Result};
use ttf_parser::Face;
#[cfg(feature = "png")]
use {
    crate::{drawing::Text, rect::Spot},
    ttf_parser::GlyphId,
};

/// Families named in the drawing: the embedded one first, then what readers have at hand
/// (all of them narrower, so nothing overlaps when one of them is taken).
pub const FAMILY: &str = "DejaVu Sans, Helvetica, Arial, sans-serif";

/// Font sizes of title, panel title and caption.
pub const TITLE: f64 = 14.0;
pub const PANEL_TITLE: f64 = 11.5;
pub const CAPTION: f64 = 8.8;

/// Measures texts in the embedded font.
pub struct Metrics {
    pub font: Face<'static>,
}

impl Metrics {
    /// Reads DejaVu Sans 2.37, of which `pyftsubset` left Latin, Greek, Cyrillic and signs, without
    /// hints and features: a fifth of the bytes.
    pub fn new() -> Result<Self> {
        let font = Face::parse(include_bytes!("../data/DejaVuSans.ttf"), 0).map_err(|error| {
            FigureError::Drawing(format!("the embedded font cannot be read: {error}"))
        })?;
        Ok(Self { font })
    }

    /// Width of a text at a font size, both in units of the drawing.
    pub fn width(&self, text: &str, size: f64) -> f64 {
        text.chars().map(|c| self.advance(c, size)).sum()
    }

    /// Width of the widest of some texts.
    pub fn widest(&self, texts: &[String], size: f64) -> f64 {
        texts
            .iter()
            .map(|text| self.width(text, size))
            .fold(0.0, f64::max)
    }

    /// How far a character moves the pen; one that the font lacks takes 0.7 of the size.
    pub fn advance(&self, c: char, size: f64) -> f64 {
        self.font
            .glyph_index(c)
            .and_then(|glyph| self.font.glyph_hor_advance(glyph))
            .map_or(0.7 * size, |units| f64::from(units) * self.scale(size))
    }

    /// Where a text begins.
    #[cfg(feature = "png")]
    pub fn start(&self, text: &Text) -> Spot {
        let before = f64::from(text.anchor as u8) / 2.0;
        let (x, y) = text.at;
        (x - before * self.width(&text.words, text.size), y)
    }

    /// The glyph of a character; of one that the font lacks it is an empty box.
    #[cfg(feature = "png")]
    pub fn glyph(&self, c: char) -> GlyphId {
        self.font.glyph_index(c).unwrap_or(GlyphId(0))
    }

    pub fn scale(&self, size: f64) -> f64 {
        size / f64::from(self.font.units_per_em())
    }

    /// Breaks a text into lines no wider than `room` where it has blanks.
    pub fn wrap(&self, text: &str, size: f64, room: f64) -> Vec<String> {
        let mut lines = Vec::new();
        for paragraph in text.lines() {
            let mut line = String::new();
            for word in paragraph.split_whitespace() {
                let longer = if line.is_empty() {
                    word.to_owned()
                } else {
                    format!("{line} {word}")
                };
                if line.is_empty() || self.width(&longer, size) <= room {
                    line = longer;
                } else {
                    lines.push(std::mem::replace(&mut line, word.to_owned()));
                }
            }
            if !line.is_empty() {
                lines.push(line);
            }
        }
        lines
    }

    /// Shortens a text with an ellipsis until it fits into `room`.
    pub fn fit(&self, text: &str, size: f64, room: f64) -> String {
        if self.width(text, size) <= room {
            return text.to_owned();
        }
        let mut kept: Vec<char> = text.chars().collect();
        while kept.pop().is_some() {
            let short: String = kept.iter().collect::<String>().trim_end().to_owned() + "…";
            if self.width(&short, size) <= room {
                return short;
            }
        }
        String::new()
    }
}
