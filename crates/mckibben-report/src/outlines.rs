//! Texts of a drawing as outlines: for programs that have no fonts.

use std::fmt::Write as _;

use resvg::usvg::roxmltree::{Document, Node};

use crate::Result;
use crate::font::Metrics;
use crate::png::raster;

/// A drawing of [`crate::Figure::to_svg`] or [`crate::Sheet::to_svg`] with each `text` element replaced by a `path`: the outlines of its
/// characters in the embedded font. The n-th one, from 0, has the id `text-n`.
pub fn texts_as_outlines(svg: &str) -> Result<String> {
    let metrics = Metrics::new()?;
    let document = Document::parse(svg).map_err(raster)?;
    let texts =
        document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")));
    let (mut out, mut copied) = (String::with_capacity(2 * svg.len()), 0);
    for (i, text) in texts.enumerate() {
        let range = text.range();
        out.push_str(&svg[copied..range.start]);
        copied = range.end;
        path(&mut out, i, text, &metrics)?;
    }
    out.push_str(&svg[copied..]);
    Ok(out)
}

fn path(out: &mut String, number: usize, text: Node<'_, '_>, metrics: &Metrics) -> Result<()> {
    let number_of = |name: &str| {
        let value = text.attribute(name).and_then(|v| v.parse::<f64>().ok());
        value.ok_or_else(|| raster(format!("a text has no {name}")))
    };
    let (x, y, size) = (number_of("x")?, number_of("y")?, number_of("font-size")?);
    let words = text.text().unwrap_or_default();
    let width = metrics.width(words, size);
    let start = match text.attribute("text-anchor") {
        Some("middle") => x - 0.5 * width,
        Some("end") => x - width,
        _ => x,
    };
    // Writing into a string does not fail.
    let _ = write!(out, "<path id=\"text-{number}\" d=\"{}\"", metrics.outlines(words, size, (start, y)));
    for attribute in text.attributes() {
        if !matches!(attribute.name(), "x" | "y" | "font-size" | "text-anchor" | "aria-hidden") {
            let _ = write!(out, " {}=\"{}\"", attribute.name(), attribute.value());
        }
    }
    out.push_str("/>");
    Ok(())
}
