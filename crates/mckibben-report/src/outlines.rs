//! Texts of a drawing as outlines: for programs that have no fonts.

use crate::{
    figure::{FigureError, Result},
    font::Metrics,
};
use resvg::usvg::{
    Options, Tree,
    roxmltree::{Document, Node},
};
use std::fmt::Write as _;
use ttf_parser::{GlyphId, OutlineBuilder};

/// A drawing of [`crate::Figure::to_svg`] or [`crate::Sheet::to_svg`] with each `text` element
/// replaced by a `path`: the outlines of its characters in the embedded font. The n-th one, from 0,
/// has the id `text-n`.
pub fn texts_as_outlines(svg: &str) -> Result<String> {
    let metrics = Metrics::new()?;
    let document = Document::parse(svg).map_err(FigureError::image)?;
    let texts = document
        .descendants()
        .filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")));
    let mut out = String::with_capacity(2 * svg.len());
    let mut copied = 0;
    for (i, text) in texts.enumerate() {
        let range = text.range();
        out.push_str(&svg[copied..range.start]);
        copied = range.end;
        path(&mut out, i, text, &metrics)?;
    }
    out.push_str(&svg[copied..]);
    Ok(out)
}

/// The paths of a drawing.
pub fn tree(svg: &str) -> Result<Tree> {
    Tree::from_str(&texts_as_outlines(svg)?, &Options::default()).map_err(FigureError::image)
}

fn path(out: &mut String, number: usize, text: Node<'_, '_>, metrics: &Metrics) -> Result<()> {
    let number_of = |name: &str| {
        text.attribute(name)
            .and_then(|v| v.parse::<f64>().ok())
            .ok_or_else(|| FigureError::image(format!("a text has no {name}")))
    };
    let x = number_of("x")?;
    let y = number_of("y")?;
    let size = number_of("font-size")?;
    let words = text.text().unwrap_or_default();
    let width = metrics.width(words, size);
    let start = match text.attribute("text-anchor") {
        Some("middle") => x - 0.5 * width,
        Some("end") => x - width,
        _ => x,
    };
    // Writing into a string does not fail.
    let _ = write!(
        out,
        "<path id=\"text-{number}\" d=\"{}\"",
        metrics.outlines(words, size, (start, y))
    );
    for attribute in text.attributes() {
        if !matches!(
            attribute.name(),
            "x" | "y" | "font-size" | "text-anchor" | "aria-hidden"
        ) {
            let _ = write!(out, " {}=\"{}\"", attribute.name(), attribute.value());
        }
    }
    out.push_str("/>");
    Ok(())
}

impl Metrics {
    /// The outlines of a text that starts at `at` on its base line, as the data of an SVG path.
    pub fn outlines(&self, text: &str, size: f64, at: (f64, f64)) -> String {
        let mut pen = Pen {
            out: String::new(),
            x: at.0,
            y: at.1,
            scale: self.scale(size),
        };
        for c in text.chars() {
            // A character that the font lacks is its empty box, glyph 0.
            let glyph = self.font.glyph_index(c).unwrap_or(GlyphId(0));
            self.font.outline_glyph(glyph, &mut pen);
            pen.x += self.advance(c, size);
        }
        pen.out
    }
}

/// Writes outlines, which have their y upwards, from where the pen is.
struct Pen {
    out: String,
    x: f64,
    y: f64,
    scale: f64,
}

impl Pen {
    fn command(&mut self, letter: char, points: &[(f32, f32)]) {
        self.out.push(letter);
        for (i, (x, y)) in points.iter().enumerate() {
            let x = self.x + f64::from(*x) * self.scale;
            let y = self.y - f64::from(*y) * self.scale;
            // Writing into a string does not fail.
            let _ = write!(self.out, "{}{x:.3} {y:.3}", if i > 0 { " " } else { "" });
        }
    }
}

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
