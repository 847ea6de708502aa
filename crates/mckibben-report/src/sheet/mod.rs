//! Technical drawings: lines, circles and texts on a sheet of paper, as SVG and PDF.
//!
//! Places are in mm from the lower left corner of the sheet, y upwards. Widths of lines follow ISO 128-2: outlines twice as wide as all others.

mod svg;

/// A sheet with a drawing on it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sheet {
    /// What the drawing shows.
    pub title: String,
    /// Width of the paper in mm.
    pub width_mm: f64,
    /// Height of the paper in mm.
    pub height_mm: f64,
    /// What is drawn, in this order.
    pub items: Vec<Item>,
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
    pub(super) fn width_mm(self) -> f64 {
        match self {
            Self::Outline => 0.5,
            Self::Thin | Self::Axis => 0.25,
        }
    }

    /// Lengths in mm of dashes and gaps; none for a full line.
    pub(super) fn dashes_mm(self) -> &'static [f64] {
        match self {
            Self::Axis => &[6.0, 1.0, 0.5, 1.0],
            Self::Outline | Self::Thin => &[],
        }
    }
}

/// Which part of a text lies at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// A part of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// Straight lines from point to point.
    Line {
        points: Vec<[f64; 2]>,
        /// The kind of line.
        pen: Pen,
    },
    /// A filled polygon: an arrow, a thin section.
    Fill { points: Vec<[f64; 2]> },
    Circle {
        centre: [f64; 2],
        /// Its radius in mm.
        radius_mm: f64,
        /// The kind of line.
        pen: Pen,
    },
    Text {
        /// Place of its base line.
        at: [f64; 2],
        /// Height of its capitals in mm.
        height_mm: f64,
        text: String,
        /// What lies at the place.
        anchor: Anchor,
        /// Whether it reads upwards.
        upright: bool,
    },
}

impl Sheet {
    /// A line through points.
    pub fn line(&mut self, pen: Pen, points: impl Into<Vec<[f64; 2]>>) {
        self.items.push(Item::Line { points: points.into(), pen });
    }

    /// A closed line through corners.
    pub fn outline(&mut self, pen: Pen, corners: impl Into<Vec<[f64; 2]>>) {
        let mut points = corners.into();
        points.extend(points.first().copied());
        self.line(pen, points);
    }

    pub fn fill(&mut self, points: impl Into<Vec<[f64; 2]>>) {
        self.items.push(Item::Fill { points: points.into() });
    }

    pub fn circle(&mut self, pen: Pen, centre: [f64; 2], radius_mm: f64) {
        self.items.push(Item::Circle { centre, radius_mm, pen });
    }

    /// A text that reads to the right.
    pub fn text(&mut self, at: [f64; 2], height_mm: f64, anchor: Anchor, text: impl Into<String>) {
        self.items.push(Item::Text { at, height_mm, text: text.into(), anchor, upright: false });
    }

    /// A text that reads upwards.
    pub fn text_upwards(&mut self, at: [f64; 2], height_mm: f64, anchor: Anchor, text: impl Into<String>) {
        self.items.push(Item::Text { at, height_mm, text: text.into(), anchor, upright: true });
    }
}
