//! The figure as pixels: the same SVG, rendered with the embedded font.

use resvg::{tiny_skia, usvg};

use crate::{Figure, FigureError, Scene, texts_as_outlines};

/// Pixels for each unit of the drawing (a millimetre has four units): 254 dots per inch.
const SCALE: f32 = 2.5;
/// The same of a picture within a page: 127 dots per inch.
const IN_A_PAGE: f32 = 1.25;
const LONGEST: f32 = 8000.0;

impl Figure {
    /// The figure as a PNG image of 10 pixels per millimetre (1600 × 1000 for one panel).
    pub fn to_png(&self) -> Result<Vec<u8>, FigureError> {
        render(&self.to_svg()?, SCALE)
    }
}

impl Scene {
    /// The same as PNG, 10 pixels a millimetre.
    pub fn to_png(&self) -> Result<Vec<u8>, FigureError> {
        render(&self.to_svg()?, SCALE)
    }

    /// The same as an image of an HTML page: a tenth of the bytes of the drawing.
    pub(crate) fn to_img(&self) -> Result<String, FigureError> {
        use base64::Engine as _;
        let mut pixels = drawn(&self.to_svg()?, IN_A_PAGE)?;
        // Five bits a channel: the eye sees no difference, and the file has half the bytes.
        for (_, byte) in pixels.data_mut().iter_mut().enumerate().filter(|(i, _)| i % 4 != 3) {
            *byte |= 0x07;
        }
        let data = base64::engine::general_purpose::STANDARD.encode(encoded(&pixels)?);
        let (alt, width) = (crate::xml::escape(&self.title), self.width_mm);
        Ok(format!("<img alt=\"{alt}\" style=\"width:{width}mm\" src=\"data:image/png;base64,{data}\">"))
    }
}

fn raster(reason: String) -> FigureError {
    FigureError::Raster { reason }
}

fn render(svg: &str, scale: f32) -> Result<Vec<u8>, FigureError> {
    encoded(&drawn(svg, scale)?)
}

/// Pixels of a drawing.
fn drawn(svg: &str, scale: f32) -> Result<tiny_skia::Pixmap, FigureError> {
    let tree = usvg::Tree::from_str(&texts_as_outlines(svg)?, &usvg::Options::default())
        .map_err(|e| raster(e.to_string()))?;
    // the tree is in CSS pixels (96 to the inch); a unit of the drawing is a quarter millimetre
    let size = tree.size();
    let units = 4.0 * 25.4 / 96.0;
    let scale = (scale * units).min(LONGEST / size.width().max(size.height()));
    let width = (size.width() * scale).round().max(1.0) as u32;
    let height = (size.height() * scale).round().max(1.0) as u32;
    let mut pixels = tiny_skia::Pixmap::new(width, height)
        .ok_or_else(|| raster(format!("{width} × {height} pixels are too many")))?;
    pixels.fill(tiny_skia::Color::WHITE);
    let to = tiny_skia::Transform::from_scale(scale, scale);
    resvg::render(&tree, to, &mut pixels.as_mut());
    Ok(pixels)
}

fn encoded(pixels: &tiny_skia::Pixmap) -> Result<Vec<u8>, FigureError> {
    pixels.encode_png().map_err(|e| raster(e.to_string()))
}
