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
    /// Middle and radius.
    Circle(Spot, f64, Paint),
    Text(Text),
    /// Items with their origin at a place, so many times as large.
    Group(Spot, f64, Vec<Self>),
}

impl Item {
    /// A text turned about a place, so that it reads upwards.
    pub fn turned_about(mut self, place: Spot) -> Self {
        if let Self::Text(text) = &mut self {
            text.turned_about = Some(place);
        }
        self
    }

    /// Items that belong together.
    pub fn group(items: Vec<Self>) -> Self {
        Self::Group((0.0, 0.0), 1.0, items)
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
    /// A line down and to the right: its upper and its right end.
    Axes(Spot, Spot),
}

/// How a shape is painted: filled, along its outline, or both.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Paint {
    pub fill: Option<Colour>,
    pub is_pale: bool,
    pub stroke: Option<Colour>,
    /// Of the stroke.
    pub width: f64,
    pub has_round_joins: bool,
    pub cap: Cap,
    /// Lengths of dashes and gaps; without any the stroke is solid.
    pub dashes: &'static [f64],
}

/// The end of a line.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Cap {
    #[default]
    Butt,
    Round,
    Square,
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
    Start,
    Middle,
    End,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    pub words: String,
    /// On the base line.
    pub at: Spot,
    pub size: f64,
    pub anchor: Anchor,
    /// Its stroke stands in place of a bold face; one with round joins is the ground of the same
    /// text, which keeps that readable over a line.
    pub paint: Paint,
    /// It reads upwards: turned about this place.
    pub turned_about: Option<Spot>,
}

impl Text {
    pub fn new(at: Spot, size: f64, anchor: Anchor, words: &str) -> Self {
        Self {
            words: clean::line(words),
            at,
            size,
            anchor,
            paint: Paint::fill(INK),
            turned_about: None,
        }
    }

    pub fn is_ground(&self) -> bool {
        self.paint.has_round_joins
    }
}
