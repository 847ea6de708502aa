//! A drawing as data: shapes and texts in the order in which they are painted.
//!
//! Lengths are in quarters of a millimetre; y runs downwards.

use crate::rect::Spot;
use mckibben_units::clean;

/// Red, green, blue.
pub type Colour = [u8; 3];

pub const INK: Colour = [0x22; 3];
pub const WHITE: Colour = [0xff; 3];
/// Opacity of a pale area.
pub const PALE: f64 = 0.14;

/// A drawing on white paper.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    pub title: String,
    pub width: f64,
    pub height: f64,
    pub items: Vec<Item>,
}

#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// Shapes that are painted alike.
    Path(Vec<Shape>, Paint),
    Text(Text),
    /// Items with their origin at a place, so many times as large.
    Group(Spot, f64, Vec<Self>),
}

impl Item {
    pub fn circle(middle: Spot, radius: f64, paint: Paint) -> Self {
        Self::Path(vec![Shape::Circle(middle, radius)], paint)
    }
}

#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    Line(Vec<Spot>),
    Polygon(Vec<Spot>),
    /// Middle and radius.
    Circle(Spot, f64),
    /// Upper left corner and side.
    Square(Spot, f64),
}

/// How a shape is painted: filled, along its outline, or both. A solid stroke has round ends, and all
/// have round joins.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Paint {
    pub fill: Option<Colour>,
    pub is_pale: bool,
    pub stroke: Option<Colour>,
    /// Of the stroke.
    pub width: f64,
    /// Lengths of dashes and gaps; without any the stroke is solid.
    pub dashes: &'static [f64],
}

impl Paint {
    pub fn fill(colour: Colour) -> Self {
        Self::default().filled(colour)
    }

    pub fn stroke(colour: Colour, width: f64) -> Self {
        Self {
            stroke: Some(colour),
            width,
            ..Self::default()
        }
    }

    pub fn filled(self, colour: Colour) -> Self {
        Self {
            fill: Some(colour),
            ..self
        }
    }
}

/// Which part of a text lies at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins there.
    Start,
    /// The text is centred there.
    Middle,
    /// The text ends there.
    End,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    pub words: String,
    /// On the base line.
    pub at: Spot,
    pub size: f64,
    pub anchor: Anchor,
    /// Its stroke stands in place of a bold face; a white one is the ground of the same text, which
    /// keeps that readable over a line.
    pub paint: Paint,
    /// It reads upwards: turned about its place.
    pub is_upright: bool,
}

impl Text {
    pub fn new(at: Spot, size: f64, anchor: Anchor, words: &str) -> Self {
        Self {
            words: clean::line(words),
            at,
            size,
            anchor,
            paint: Paint::fill(INK),
            is_upright: false,
        }
    }

    pub fn is_ground(&self) -> bool {
        self.paint.stroke == Some(WHITE)
    }
}
