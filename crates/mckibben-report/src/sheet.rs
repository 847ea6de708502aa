//! Technical drawings: lines, circles and texts on a sheet of paper.
//!
//! Places are in mm from the lower left corner of the sheet, y upwards. Widths of lines follow ISO
//! 128-2: outlines twice as wide as all others.

use crate::{
    drawing::{Anchor, Drawing, INK, Item, Paint, Shape, Text},
    figure::Result,
    layout::check_paper,
    rect::{PER_MM, Spot},
};

/// Height of the capitals of the embedded font, as a share of its size.
pub const CAPITALS: f64 = 0.729;

/// A sheet with a drawing on it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DrawingSheet {
    drawing: Drawing,
}

/// A kind of line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pen {
    /// Visible edges: 0.5 mm.
    Outline,
    /// Dimensions, hatches, leaders: 0.25 mm.
    Thin,
    /// Axes: thin, long and short dashes.
    Axis,
}

impl Pen {
    fn paint(self) -> Paint {
        let width_mm = if self == Self::Outline { 0.5 } else { 0.25 };
        let dashes: &[f64] = if self == Self::Axis {
            &[24.0, 4.0, 2.0, 4.0]
        } else {
            &[]
        };
        Paint {
            dashes,
            ..Paint::stroke(INK, width_mm * PER_MM)
        }
    }
}

impl DrawingSheet {
    /// An empty sheet of a size in mm; the title says what the drawing shows.
    pub fn new(title: String, width_mm: f64, height_mm: f64) -> Self {
        Self {
            drawing: Drawing {
                title,
                width: width_mm * PER_MM,
                height: height_mm * PER_MM,
                items: vec![],
            },
        }
    }

    /// A place in units of the drawing, y downwards.
    fn place(&self, [x, y]: [f64; 2]) -> Spot {
        (x * PER_MM, self.drawing.height - y * PER_MM)
    }

    fn places(&self, points: Vec<[f64; 2]>) -> Vec<Spot> {
        points.into_iter().map(|point| self.place(point)).collect()
    }

    fn push(&mut self, item: Item) {
        self.drawing.items.push(item);
    }

    /// A line through points.
    pub fn line(&mut self, pen: Pen, points: impl Into<Vec<[f64; 2]>>) {
        let line = Shape::Line(self.places(points.into()));
        self.push(Item::Path(vec![line], pen.paint()));
    }

    /// A closed line through corners.
    pub fn outline(&mut self, pen: Pen, corners: impl Into<Vec<[f64; 2]>>) {
        let polygon = Shape::Polygon(self.places(corners.into()));
        self.push(Item::Path(vec![polygon], pen.paint()));
    }

    /// A polygon filled with a grey, from 0 for black to 255 for white: an arrow, a section.
    pub fn fill(&mut self, grey: u8, points: impl Into<Vec<[f64; 2]>>) {
        let polygon = Shape::Polygon(self.places(points.into()));
        self.push(Item::Path(vec![polygon], Paint::fill([grey; 3])));
    }

    /// A circle with this line.
    pub fn circle(&mut self, pen: Pen, centre: [f64; 2], radius_mm: f64) {
        let centre = self.place(centre);
        self.push(Item::circle(centre, radius_mm * PER_MM, pen.paint()));
    }

    /// A text that reads to the right: the place of its base line, and the height of its capitals.
    pub fn text(&mut self, at: [f64; 2], height_mm: f64, anchor: Anchor, text: impl AsRef<str>) {
        let size = height_mm * PER_MM / CAPITALS;
        let text = Text::new(self.place(at), size, anchor, text.as_ref());
        self.push(Item::Text(text));
    }

    /// A text that reads upwards.
    pub fn text_upwards(
        &mut self,
        at: [f64; 2],
        height_mm: f64,
        anchor: Anchor,
        text: impl AsRef<str>,
    ) {
        self.text(at, height_mm, anchor, text);
        if let Some(Item::Text(text)) = self.drawing.items.last_mut() {
            text.is_upright = true;
        }
    }

    pub(crate) fn drawing(&self) -> Result<&Drawing> {
        check_paper(self.drawing.width / PER_MM, self.drawing.height / PER_MM)?;
        Ok(&self.drawing)
    }

    /// The drawing as SVG of the sheet's size.
    pub fn to_svg(&self) -> Result<String> {
        Ok(self.drawing()?.to_svg())
    }

    /// Another drawing with its upper left corner at a place, so many times as large.
    pub fn embed(&mut self, drawing: &Drawing, at: [f64; 2], scale: f64) {
        let item = Item::Group(self.place(at), scale, drawing.items.clone());
        self.push(item);
    }
}
