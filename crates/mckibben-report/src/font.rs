//! The embedded font: the width of texts set in it, and their outlines.

#[cfg(feature = "png")]
use std::fmt::Write as _;

use ttf_parser::Face;
#[cfg(feature = "png")]
use ttf_parser::{GlyphId, OutlineBuilder};

use crate::{FigureError, Result};

/// Families named in the drawing: the embedded one first, then what readers have at hand
/// (all of them narrower, so nothing overlaps when one of them is taken).
pub(crate) const FAMILY: &str = "DejaVu Sans, Helvetica, Arial, sans-serif";

/// Measures texts in the embedded font.
pub(crate) struct Metrics {
    font: Face<'static>,
}

impl Metrics {
    /// Reads the embedded font.
    pub fn new() -> Result<Self> {
        let font = Face::parse(dejavu::sans::regular(), 0)
            .map_err(|error| FigureError::Drawing(format!("the embedded font cannot be read: {error}")))?;
        Ok(Self { font })
    }

    /// Width of a text at a font size, both in units of the drawing.
    pub fn width(&self, text: &str, size: f64) -> f64 {
        text.chars().map(|c| self.advance(c, size)).sum()
    }

    /// How far a character moves the pen; one that the font lacks takes 0.7 of the size.
    fn advance(&self, c: char, size: f64) -> f64 {
        let advance = self.font.glyph_index(c).and_then(|glyph| self.font.glyph_hor_advance(glyph));
        advance.map_or(0.7 * size, |units| f64::from(units) * self.scale(size))
    }

    fn scale(&self, size: f64) -> f64 {
        size / f64::from(self.font.units_per_em())
    }

    /// The outlines of a text that starts at `at` on its base line, as the data of an SVG path.
    #[cfg(feature = "png")]
    pub fn outlines(&self, text: &str, size: f64, at: (f64, f64)) -> String {
        let mut pen = Pen { out: String::new(), x: at.0, y: at.1, scale: self.scale(size) };
        for c in text.chars() {
            // A character that the font lacks is its empty box, glyph 0.
            let glyph = self.font.glyph_index(c).unwrap_or(GlyphId(0));
            self.font.outline_glyph(glyph, &mut pen);
            pen.x += self.advance(c, size);
        }
        pen.out
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

/// Writes outlines, which have their y upwards, from where the pen is.
#[cfg(feature = "png")]
struct Pen {
    out: String,
    x: f64,
    y: f64,
    scale: f64,
}

#[cfg(feature = "png")]
impl Pen {
    fn command(&mut self, letter: char, points: &[(f32, f32)]) {
        self.out.push(letter);
        for (i, (x, y)) in points.iter().enumerate() {
            let (x, y) = (self.x + f64::from(*x) * self.scale, self.y - f64::from(*y) * self.scale);
            // Writing into a string does not fail.
            let _ = write!(self.out, "{}{x:.3} {y:.3}", if i > 0 { " " } else { "" });
        }
    }
}

#[cfg(feature = "png")]
impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.command('M', &[(x, y)]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.command('L', &[(x, y)]);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.command('Q', &[(x1, y1), (x, y)]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.command('C', &[(x1, y1), (x2, y2), (x, y)]);
    }

    fn close(&mut self) {
        self.out.push('Z');
    }
}
