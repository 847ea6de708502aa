//! Colours, dash patterns and marker shapes.

use crate::figure::{Palette, Style};

/// Okabe & Ito 2008 \[okabe2008\], without the yellow, which is lost on white.
const CATEGORICAL: [[u8; 3]; 7] = [
    [0x00, 0x72, 0xB2],
    [0xD5, 0x5E, 0x00],
    [0x00, 0x9E, 0x73],
    [0xCC, 0x79, 0xA7],
    [0x56, 0xB4, 0xE9],
    [0xE6, 0x9F, 0x00],
    [0x4D, 0x4D, 0x4D],
];

/// Stations of a ramp after viridis, cut before its pale yellow end.
const RAMP: [[u8; 3]; 6] = [
    [0x44, 0x13, 0x6E],
    [0x3E, 0x4A, 0x89],
    [0x2A, 0x78, 0x8E],
    [0x1F, 0x9E, 0x77],
    [0x6A, 0xB4, 0x34],
    [0xC8, 0xA4, 0x00],
];

/// Dash patterns in units of the line width, solid first.
const DASHES: [&[f64]; 6] = [
    &[],
    &[5.0, 2.5],
    &[1.2, 1.8],
    &[6.0, 2.0, 1.2, 2.0],
    &[9.0, 3.0],
    &[6.0, 1.8, 1.2, 1.8, 1.2, 1.8],
];

/// The colours of the series of a figure.
pub struct Colours {
    pub palette: Palette,
    /// How many there are.
    pub count: usize,
}

impl Colours {
    /// The colour of a number as `#rrggbb`.
    pub fn hex(&self, number: usize) -> String {
        let last = self.count.max(2) - 1;
        let [r, g, b] = match self.palette {
            Palette::Categorical => CATEGORICAL[number % CATEGORICAL.len()],
            Palette::Sequential => ramp(number.min(last) as f64 / last as f64),
        };
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// Dash pattern of a line in units of its width; empty: solid.
    pub fn dashes(&self, style: Style, number: usize) -> &'static [f64] {
        // a solid line whose colour repeats takes the next pattern
        let round = match self.palette {
            Palette::Categorical => number / CATEGORICAL.len(),
            Palette::Sequential => 0,
        };
        match style {
            Style::Auto => DASHES[number % DASHES.len()],
            Style::Line => DASHES[round % DASHES.len()],
            Style::Dashed => DASHES[1],
            Style::Dotted => DASHES[2],
            Style::DashDot => DASHES[3],
            Style::Points | Style::Band => &[],
        }
    }
}

/// The colour at a part (0 to 1) of the ramp.
fn ramp(part: f64) -> [u8; 3] {
    let at = part.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let left = (at.floor() as usize).min(RAMP.len() - 2);
    let part = at - left as f64;
    let a = RAMP[left];
    let b = RAMP[left + 1];
    std::array::from_fn(|i| (f64::from(a[i]) * (1.0 - part) + f64::from(b[i]) * part).round() as u8)
}

/// The shape of a marker.
#[derive(Clone, Copy, PartialEq)]
pub enum Shape {
    Circle,
    Square,
    Triangle,
    Diamond,
    TriangleDown,
    Cross,
}

/// The marker shape of a colour number.
pub fn shape(number: usize) -> Shape {
    use Shape::{Circle, Cross, Diamond, Square, Triangle, TriangleDown};
    [Circle, Square, Triangle, Diamond, TriangleDown, Cross][number % 6]
}
