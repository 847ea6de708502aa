//! Where in a plot something is drawn already, so that texts can keep away from it.

use crate::rect::{Rect, Spot, between};
use std::collections::HashSet;

/// Side of a cell, units of the drawing.
const CELL: f64 = 3.0;

/// A coarse picture of the drawn lines and points, and the boxes of placed texts.
pub struct Room {
    /// The plot this is about.
    pub plot: Rect,
    /// Cells in which something is drawn.
    drawn: HashSet<[i64; 2]>,
    boxes: Vec<Rect>,
}

impl Room {
    pub fn new(plot: Rect) -> Self {
        Self {
            plot,
            drawn: HashSet::new(),
            boxes: Vec::new(),
        }
    }

    fn cell(&self, (x, y): Spot) -> [i64; 2] {
        [x - self.plot.x, y - self.plot.y].map(|v| (v / CELL).floor() as i64)
    }

    /// Notes a drawn line.
    pub fn add_line(&mut self, line: &[Spot]) {
        for pair in line.windows(2) {
            let a = pair[0];
            let b = pair[1];
            let steps = ((b.0 - a.0).abs().max((b.1 - a.1).abs()) / (0.5 * CELL))
                .ceil()
                .max(1.0);
            for i in 0..=steps as usize {
                self.add_spot(between(a, b, i as f64 / steps));
            }
        }
        if let [only] = line {
            self.add_spot(*only);
        }
    }

    /// Notes a drawn point.
    pub fn add_spot(&mut self, spot: Spot) {
        self.drawn.insert(self.cell(spot));
    }

    /// Notes a drawn marker.
    pub fn add_marker(&mut self, (x, y): Spot) {
        for across in [-CELL, 0.0, CELL] {
            for down in [-CELL, 0.0, CELL] {
                self.add_spot((x + across, y + down));
            }
        }
    }

    /// Notes the box of a placed text or sign.
    pub fn add_box(&mut self, taken: Rect) {
        self.boxes.push(taken);
    }

    /// Whether a rectangle meets a box noted before.
    pub fn meets_box(&self, rect: &Rect) -> bool {
        self.boxes.iter().any(|taken| taken.meets(rect))
    }

    /// How many cells with something drawn lie under a rectangle.
    pub fn drawn_under(&self, rect: &Rect) -> usize {
        let [left, top] = self.cell((rect.x, rect.y));
        let [right, bottom] = self.cell((rect.right(), rect.bottom()));
        let cells = (left..=right).flat_map(|x| (top..=bottom).map(move |y| [x, y]));
        cells.filter(|cell| self.drawn.contains(cell)).count()
    }
}
