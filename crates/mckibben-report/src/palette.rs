//! Colours and dash patterns.

use crate::{
    drawing::Colour,
    figure::{Palette, Style},
};

/// Okabe & Ito 2008 \[okabe2008\], without the yellow, which is lost on white.
const CATEGORICAL: [Colour; 7] = [
    [0x00, 0x72, 0xB2],
    [0xD5, 0x5E, 0x00],
    [0x00, 0x9E, 0x73],
    [0xCC, 0x79, 0xA7],
    [0x56, 0xB4, 0xE9],
    [0xE6, 0x9F, 0x00],
    [0x4D, 0x4D, 0x4D],
];

/// Stations of a ramp after viridis, cut before its pale yellow end.
const RAMP: [Colour; 6] = [
    [0x44, 0x13, 0x6E],
    [0x3E, 0x4A, 0x89],
    [0x2A, 0x78, 0x8E],
    [0x1F, 0x9E, 0x77],
    [0x6A, 0xB4, 0x34],
    [0xC8, 0xA4, 0x00],
];

/// Dash patterns, solid first.
const DASHES: [&[f64]; 6] = [
    &[],
    &[8.5, 4.25],
    &[2.04, 3.06],
    &[10.2, 3.4, 2.04, 3.4],
    &[15.3, 5.1],
    &[10.2, 3.06, 2.04, 3.06, 2.04, 3.06],
];

/// The colours of the series of a figure.
pub struct Colours {
    pub palette: Palette,
    /// How many there are.
    pub count: usize,
}

impl Colours {
    /// The colour of a number.
    pub fn of(&self, number: usize) -> Colour {
        let last = self.count.max(2) - 1;
        match self.palette {
            Palette::Categorical => CATEGORICAL[number % CATEGORICAL.len()],
            Palette::Sequential => ramp(number.min(last) as f64 / last as f64),
        }
    }

    /// Dash pattern of a line; empty: solid.
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
fn ramp(part: f64) -> Colour {
    let at = part.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let left = (at.floor() as usize).min(RAMP.len() - 2);
    let part = at - left as f64;
    let a = RAMP[left];
    let b = RAMP[left + 1];
    std::array::from_fn(|i| (f64::from(a[i]) * (1.0 - part) + f64::from(b[i]) * part).round() as u8)
}
