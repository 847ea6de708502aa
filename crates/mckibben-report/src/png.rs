//! A drawing as pixels; texts are the outlines of the embedded font.

use crate::{
    drawing::{Drawing, Item, PALE, Paint, Shape, Text},
    figure::{Figure, FigureError, Result},
    font::Metrics,
    rect::Spot,
};
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};
use ttf_parser::OutlineBuilder;

/// Pixels for each unit of the drawing (a millimetre has four units): 254 dots per inch.
const SCALE: f64 = 2.5;
const LONGEST: f64 = 8000.0;

impl Figure {
    /// The figure as a PNG image of 10 pixels per millimetre (1600 × 1000 for one panel).
    pub fn to_png(&self) -> Result<Vec<u8>> {
        drawn(&self.drawing()?)?
            .encode_png()
            .map_err(FigureError::image)
    }
}

/// Pixels of a drawing.
fn drawn(drawing: &Drawing) -> Result<Pixmap> {
    let sides = [drawing.width, drawing.height];
    let scale = SCALE.min(LONGEST / sides[0].max(sides[1]));
    let [width, height] = sides.map(|side| (side * scale).round().max(1.0) as u32);
    let pixels = Pixmap::new(width, height)
        .ok_or_else(|| FigureError::image(format!("{width} × {height} pixels are too many")))?;
    let mut canvas = Canvas {
        pixels,
        metrics: Metrics::new()?,
    };
    canvas.pixels.fill(Color::WHITE);
    canvas.items(&drawing.items, scaled((0.0, 0.0), scale));
    Ok(canvas.pixels)
}

fn scaled((x, y): (f64, f64), scale: f64) -> Transform {
    let [x, y, scale] = [x, y, scale].map(|v| v as f32);
    Transform::from_row(scale, 0.0, 0.0, scale, x, y)
}

struct Canvas {
    pixels: Pixmap,
    metrics: Metrics,
}

impl Canvas {
    fn items(&mut self, items: &[Item], to: Transform) {
        for item in items {
            match item {
                Item::Path(shapes, paint) => self.paint(traced(shapes), paint, to),
                Item::Text(text) => self.text(text, to),
                Item::Group(at, scale, items) => {
                    self.items(items, to.pre_concat(scaled(*at, *scale)));
                }
            }
        }
    }

    fn text(&mut self, text: &Text, to: Transform) {
        let Text { words, size, .. } = text;
        let (mut x, y) = self.metrics.start(text);
        // Outlines have their y upwards.
        let scale = self.metrics.scale(*size) as f32;
        let mut path = PathBuilder::new();
        for c in words.chars() {
            let mut glyph = Outline::default();
            self.metrics
                .font
                .outline_glyph(self.metrics.glyph(c), &mut glyph);
            let place = Transform::from_row(scale, 0.0, 0.0, -scale, x as f32, y as f32);
            if let Some(glyph) = glyph.0.finish().and_then(|glyph| glyph.transform(place)) {
                path.push_path(&glyph);
            }
            x += self.metrics.advance(c, *size);
        }
        let turned = if text.is_upright {
            let [x, y] = [text.at.0, text.at.1].map(|v| v as f32);
            to.pre_concat(Transform::from_rotate_at(-90.0, x, y))
        } else {
            to
        };
        self.paint(path, &text.paint, turned);
    }

    fn paint(&mut self, path: PathBuilder, paint: &Paint, to: Transform) {
        let Some(path) = path.finish() else {
            return;
        };
        let mut ink = tiny_skia::Paint::default();
        if let Some([r, g, b]) = paint.fill {
            let mut colour = Color::from_rgba8(r, g, b, 255);
            if paint.is_pale {
                colour.set_alpha(PALE as f32);
            }
            ink.set_color(colour);
            self.pixels
                .fill_path(&path, &ink, FillRule::Winding, to, None);
        }
        if let Some([r, g, b]) = paint.stroke {
            ink.set_color_rgba8(r, g, b, 255);
            let dashes: Vec<f32> = paint.dashes.iter().map(|length| *length as f32).collect();
            let stroke = Stroke {
                width: paint.width as f32,
                line_cap: if dashes.is_empty() {
                    LineCap::Round
                } else {
                    LineCap::Butt
                },
                line_join: LineJoin::Round,
                dash: StrokeDash::new(dashes, 0.0),
                ..Stroke::default()
            };
            self.pixels.stroke_path(&path, &ink, &stroke, to, None);
        }
    }
}

/// The outlines of shapes.
pub fn traced(shapes: &[Shape]) -> PathBuilder {
    let mut path = PathBuilder::new();
    for shape in shapes {
        match shape {
            Shape::Line(spots) => line(&mut path, spots),
            Shape::Polygon(spots) => {
                line(&mut path, spots);
                path.close();
            }
            Shape::Square((x, y), side) => {
                let [right, bottom] = [x + side, y + side];
                line(
                    &mut path,
                    &[(*x, *y), (right, *y), (right, bottom), (*x, bottom)],
                );
                path.close();
            }
            Shape::Circle((x, y), r) => {
                let [x, y, r] = [x, y, r].map(|v| *v as f32);
                path.move_to(x + r, y);
                let (mut a, mut b) = (r, 0.0);
                // A quarter as a cubic curve, which is off by 0.03 % of the radius.
                let k = 0.5523;
                for _ in 0..4 {
                    let [u, v] = [x - b, y + a];
                    path.cubic_to(x + a - k * b, y + b + k * a, u + k * a, v + k * b, u, v);
                    (a, b) = (-b, a);
                }
                path.close();
            }
        }
    }
    path
}

fn line(path: &mut PathBuilder, spots: &[Spot]) {
    for (i, (x, y)) in spots.iter().enumerate() {
        if i == 0 {
            path.move_to(*x as f32, *y as f32);
        } else {
            path.line_to(*x as f32, *y as f32);
        }
    }
}

/// Outlines of glyphs that are collected.
#[derive(Default)]
struct Outline(PathBuilder);

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.0.close();
    }
}
