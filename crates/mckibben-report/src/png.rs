//! The figure as pixels: the same SVG, rendered with the embedded font.

use crate::{
    figure::{Figure, FigureError, Result},
    outlines::tree,
};
use resvg::tiny_skia;

/// Pixels for each unit of the drawing (a millimetre has four units): 254 dots per inch.
const SCALE: f32 = 2.5;
const LONGEST: f32 = 8000.0;

impl Figure {
    /// The figure as a PNG image of 10 pixels per millimetre (1600 × 1000 for one panel).
    pub fn to_png(&self) -> Result<Vec<u8>> {
        drawn(&self.to_svg()?)?
            .encode_png()
            .map_err(FigureError::image)
    }
}

/// Pixels of a drawing.
fn drawn(svg: &str) -> Result<tiny_skia::Pixmap> {
    let tree = tree(svg)?;
    // the tree is in CSS pixels (96 to the inch); a unit of the drawing is a quarter millimetre
    let size = tree.size();
    let units = 4.0 * 25.4 / 96.0;
    let scale = (SCALE * units).min(LONGEST / size.width().max(size.height()));
    let width = (size.width() * scale).round().max(1.0) as u32;
    let height = (size.height() * scale).round().max(1.0) as u32;
    let mut pixels = tiny_skia::Pixmap::new(width, height)
        .ok_or_else(|| FigureError::image(format!("{width} × {height} pixels are too many")))?;
    pixels.fill(tiny_skia::Color::WHITE);
    let to = tiny_skia::Transform::from_scale(scale, scale);
    resvg::render(&tree, to, &mut pixels.as_mut());
    Ok(pixels)
}
