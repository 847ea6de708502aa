//! The embedded font and the width of texts set in it.

use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider};

use crate::FigureError;

/// Families named in the drawing: the embedded one first, then what readers have at hand
/// (all of them narrower, so nothing overlaps when one of them stands in).
pub(crate) const FAMILY: &str = "DejaVu Sans, Helvetica, Arial, sans-serif";

/// Measures texts in the embedded font.
pub(crate) struct Metrics {
    font: FontRef<'static>,
}

impl Metrics {
    /// Reads the embedded font.
    pub fn new() -> Result<Self, FigureError> {
        let font = FontRef::new(dejavu::sans::regular())
            .map_err(|error| FigureError::Font { reason: error.to_string() })?;
        Ok(Self { font })
    }

    /// Width of a text at a font size, both in units of the drawing.
    pub fn width(&self, text: &str, size: f64) -> f64 {
        let glyphs = self.font.glyph_metrics(Size::new(size as f32), LocationRef::default());
        let map = self.font.charmap();
        text.chars()
            .map(|c| {
                let advance = map.map(c).and_then(|glyph| glyphs.advance_width(glyph));
                advance.map_or(0.7 * size, f64::from)
            })
            .sum()
    }

    /// Breaks a text into lines no wider than `room` where it has blanks.
    pub fn wrap(&self, text: &str, size: f64, room: f64) -> Vec<String> {
        let mut lines = Vec::new();
        for paragraph in text.lines() {
            let mut line = String::new();
            for word in paragraph.split_whitespace() {
                let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
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
