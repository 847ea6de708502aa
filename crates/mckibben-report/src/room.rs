//! Where in a plot something is drawn already, so that texts can keep away from it.

use crate::rect::{Rect, Spot, between};

/// Side of a cell, units of the drawing.
const CELL: f64 = 3.0;

/// A coarse picture of the drawn lines and points, and the boxes of placed texts.
pub struct Room {
    /// The plot this is about.
    pub plot: Rect,
    columns: usize,
    rows: usize,
    /// Whether something is drawn in the cell.
    cells: Vec<bool>,
    boxes: Vec<Rect>,
}

/// The number of a cell, of so many.
fn cell(from_edge: f64, count: usize) -> usize {
    (from_edge / CELL).floor().clamp(0.0, (count - 1) as f64) as usize
}

impl Room {
    pub fn new(plot: Rect) -> Self {
        let columns = (plot.w / CELL).ceil().max(1.0) as usize;
        let rows = (plot.h / CELL).ceil().max(1.0) as usize;
        Self {
            plot,
            columns,
            rows,
            cells: vec![false; columns * rows],
            boxes: Vec::new(),
        }
    }

    fn column(&self, x: f64) -> usize {
        cell(x - self.plot.x, self.columns)
    }

    fn row(&self, y: f64) -> usize {
        cell(y - self.plot.y, self.rows)
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
    pub fn add_spot(&mut self, (x, y): Spot) {
        let column = self.column(x);
        let row = self.row(y);
        self.cells[row * self.columns + column] = true;
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

    /// Whether the way from `a` to `b` runs through a noted box that does not hold `a`.
    pub fn crosses_box(&self, a: Spot, b: Spot) -> bool {
        let others: Vec<_> = self.boxes.iter().filter(|taken| !taken.has(a)).collect();
        let is_taken = |spot| others.iter().any(|taken| taken.has(spot));
        (1..=24).any(|i| is_taken(between(a, b, f64::from(i) / 24.0)))
    }

    /// How many cells with something drawn lie under a rectangle.
    pub fn drawn_under(&self, rect: &Rect) -> usize {
        let columns = self.column(rect.x)..=self.column(rect.right());
        self.cells
            .chunks(self.columns)
            .take(self.row(rect.bottom()) + 1)
            .skip(self.row(rect.y))
            .map(|row| row[columns.clone()].iter().filter(|drawn| **drawn).count())
            .sum()
    }
}
