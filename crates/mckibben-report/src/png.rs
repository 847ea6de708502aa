//! The figure as pixels: the same SVG, rendered with the embedded font.

use resvg::{tiny_skia, usvg};

use crate::mark::PNG_TEXT;
use crate::{Figure, FigureError, Scene, texts_as_outlines};

/// Pixels for each unit of the drawing (a millimetre has four units): 254 dots per inch.
const SCALE: f32 = 2.5;
/// Longest side, pixels.
const LONGEST: f32 = 8000.0;

impl Figure {
    /// The figure as a PNG image of 10 pixels per millimetre (1600 × 1000 for one panel).
    ///
    /// # Errors
    /// The errors of [`Figure::to_svg`]; [`FigureError::Raster`] if the renderer fails.
    pub fn to_png(&self) -> Result<Vec<u8>, FigureError> {
        render(&self.to_svg()?)
    }
}

impl Scene {
    /// The same as PNG, 10 pixels a millimetre.
    ///
    /// # Errors
    /// Those of [`Scene::to_svg`]; [`FigureError::Raster`] if the renderer fails.
    pub fn to_png(&self) -> Result<Vec<u8>, FigureError> {
        render(&self.to_svg()?)
    }
}

/// Pixels of a drawing.
fn render(svg: &str) -> Result<Vec<u8>, FigureError> {
    let raster = |reason: String| FigureError::Raster { reason };
    let tree = usvg::Tree::from_str(&texts_as_outlines(svg)?, &usvg::Options::default())
        .map_err(|e| raster(e.to_string()))?;
    // the tree is in CSS pixels (96 to the inch); a unit of the drawing is a quarter millimetre
    let size = tree.size();
    let units = 4.0 * 25.4 / 96.0;
    let scale = (SCALE * units).min(LONGEST / size.width().max(size.height()));
    let width = (size.width() * scale).round().max(1.0) as u32;
    let height = (size.height() * scale).round().max(1.0) as u32;
    let mut pixels = tiny_skia::Pixmap::new(width, height)
        .ok_or_else(|| raster(format!("{width} × {height} pixels are too many")))?;
    pixels.fill(tiny_skia::Color::WHITE);
    let to = tiny_skia::Transform::from_scale(scale, scale);
    resvg::render(&tree, to, &mut pixels.as_mut());
    let mut png = pixels.encode_png().map_err(|e| raster(e.to_string()))?;
    // Behind the signature and the first chunk, which have a fixed length.
    let place = 33.min(png.len());
    png.splice(place..place, PNG_TEXT.iter().copied());
    Ok(png)
}
