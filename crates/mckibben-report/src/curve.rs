//! From points of a series to what is seen of them: projection, gaps, clipping, thinning.

use crate::{
    figure::Mark,
    rect::{Rect, Spot, between},
    smooth::smooth,
    ticks::Scale,
};
use std::collections::HashSet;

/// Maps values of two axes onto a rectangle.
pub struct Frame {
    pub plot: Rect,
    pub x: Scale,
    pub y: Scale,
}

/// Series longer than this are thinned.
const MANY: usize = 2000;
/// Width of the columns (and cells) in which a long series is thinned, units of the drawing.
const CELL: f64 = 0.5;

impl Frame {
    // Far outside is as good as very far outside, and stays a number.
    pub fn at_x(&self, value: f64) -> f64 {
        self.plot.x + self.x.part(value).clamp(-1e4, 1e4) * self.plot.w
    }

    pub fn at_y(&self, value: f64) -> f64 {
        self.plot.bottom() - self.y.part(value).clamp(-1e4, 1e4) * self.plot.h
    }

    /// Place of a point; `None` if a coordinate is not finite.
    pub fn spot(&self, (x, y): (f64, f64)) -> Option<Spot> {
        let spot = (self.at_x(x), self.at_y(y));
        [x, y, spot.0, spot.1]
            .iter()
            .all(|v| v.is_finite())
            .then_some(spot)
    }

    /// Place of a mark within the frame.
    pub fn mark(&self, mark: &Mark) -> Option<Spot> {
        let spot = self.spot((mark.x, mark.y))?;
        self.plot.grown(0.01).has(spot).then_some(spot)
    }

    /// The visible pieces of a line. A piece of one spot is a point without neighbours.
    pub fn line(&self, points: &[(f64, f64)]) -> Vec<Vec<Spot>> {
        let spots: Vec<Option<Spot>> = points.iter().map(|p| self.spot(*p)).collect();
        let pieces = |run: &[Option<Spot>]| {
            let run: Vec<Spot> = run.iter().flatten().copied().collect();
            let seen = if run.len() > MANY {
                thin(&run)
            } else {
                smooth(&run)
            };
            clipped(seen, &self.plot.grown(0.01), false)
        };
        spots.split(Option::is_none).flat_map(pieces).collect()
    }

    /// The visible part of an area with an outline.
    pub fn area(&self, outline: &[(f64, f64)]) -> Vec<Spot> {
        let spots = outline.iter().filter_map(|p| self.spot(*p));
        clipped(spots.collect(), &self.plot, true).concat()
    }

    /// The visible markers of a series.
    pub fn markers(&self, points: &[(f64, f64)]) -> Vec<Spot> {
        let frame = self.plot.grown(0.01);
        let spots = points
            .iter()
            .filter_map(|p| self.spot(*p))
            .filter(|s| frame.has(*s));
        if points.len() <= MANY {
            return spots.collect();
        }
        let mut taken = HashSet::new();
        spots
            .filter(|(x, y)| taken.insert(((x / CELL).round() as i64, (y / CELL).round() as i64)))
            .collect()
    }
}

/// Keeps first, lowest, highest and last spot of every stretch within one narrow column.
fn thin(run: &[Spot]) -> Vec<Spot> {
    let column = |s: &Spot| (s.0 / CELL).floor();
    let mut kept = Vec::new();
    for stretch in run.chunk_by(|a, b| column(a) == column(b)) {
        if stretch.len() <= 4 {
            kept.extend_from_slice(stretch);
            continue;
        }
        let places = 0..stretch.len();
        let height = |a: &usize, b: &usize| stretch[*a].1.total_cmp(&stretch[*b].1);
        let highest = places.clone().min_by(height);
        let lowest = places.clone().rev().max_by(height);
        let mut which: Vec<usize> = highest
            .into_iter()
            .chain(lowest)
            .chain([0, places.end - 1])
            .collect();
        which.sort_unstable();
        which.dedup();
        kept.extend(which.into_iter().map(|i| stretch[i]));
    }
    kept
}

/// The pieces of a line within a rectangle, or what an outline leaves of it: one wall after the other
/// cuts them (Sutherland and Hodgman).
fn clipped(line: Vec<Spot>, frame: &Rect, is_outline: bool) -> Vec<Vec<Spot>> {
    // How far inside of each wall a spot is.
    let walls: [&dyn Fn(Spot) -> f64; 4] = [
        &|s| s.0 - frame.x,
        &|s| frame.right() - s.0,
        &|s| s.1 - frame.y,
        &|s| frame.bottom() - s.1,
    ];
    let mut pieces = vec![line];
    for inside in walls {
        let mut kept = vec![];
        for piece in pieces {
            let mut run = vec![];
            let mut last = piece.last().copied().filter(|_| is_outline);
            for to in piece {
                let b = inside(to);
                if let Some(from) = last.replace(to) {
                    let a = inside(from);
                    let is_cut = (a < 0.0) != (b < 0.0);
                    run.extend(is_cut.then(|| between(from, to, a / (a - b))));
                }
                if b >= 0.0 {
                    run.push(to);
                } else if !is_outline {
                    kept.push(std::mem::take(&mut run));
                }
            }
            kept.push(run);
        }
        kept.retain(|run| !run.is_empty());
        pieces = kept;
    }
    pieces
}
