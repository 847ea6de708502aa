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
    pub fn at_x(&self, value: f64) -> f64 {
        self.plot.x + self.x.part(value) * self.plot.w
    }

    pub fn at_y(&self, value: f64) -> f64 {
        self.plot.bottom() - self.y.part(value) * self.plot.h
    }

    /// Place of a point; `None` if a coordinate is not finite.
    pub fn spot(&self, (x, y): (f64, f64)) -> Option<Spot> {
        if !(x.is_finite() && y.is_finite()) {
            return None;
        }
        // far outside is as good as very far outside, and stays a number
        let across = self.x.part(x).clamp(-1e4, 1e4);
        let up = self.y.part(y).clamp(-1e4, 1e4);
        let spot = (
            self.plot.x + across * self.plot.w,
            self.plot.bottom() - up * self.plot.h,
        );
        (spot.0.is_finite() && spot.1.is_finite()).then_some(spot)
    }

    /// Place of a mark within the frame.
    pub fn mark(&self, mark: &Mark) -> Option<Spot> {
        let spot = self.spot((mark.x, mark.y))?;
        self.plot.grown(0.01).has(spot).then_some(spot)
    }

    /// The visible pieces of a line. A piece of one spot is a point without neighbours.
    pub fn line(&self, points: &[(f64, f64)]) -> Vec<Vec<Spot>> {
        let mut pieces = Vec::new();
        let mut run: Vec<Spot> = Vec::new();
        for spot in points.iter().map(|p| self.spot(*p)).chain([None]) {
            match spot {
                Some(spot) => run.push(spot),
                None if run.is_empty() => {}
                None => {
                    let seen = if run.len() > MANY {
                        thin(&run)
                    } else {
                        smooth(&run)
                    };
                    clip(&seen, &self.plot.grown(0.01), &mut pieces);
                    run.clear();
                }
            }
        }
        pieces
    }

    /// The visible part of an area with an outline.
    pub fn area(&self, outline: &[(f64, f64)]) -> Vec<Spot> {
        let frame = &self.plot;
        let mut spots: Vec<Spot> = outline.iter().filter_map(|p| self.spot(*p)).collect();
        // How far inside of each edge a spot is (Sutherland and Hodgman).
        let edges: [&dyn Fn(&Spot) -> f64; 4] = [
            &|s| s.0 - frame.x,
            &|s| frame.right() - s.0,
            &|s| s.1 - frame.y,
            &|s| frame.bottom() - s.1,
        ];
        for inside in edges {
            let mut kept = Vec::with_capacity(spots.len() + 4);
            for (i, to) in spots.iter().enumerate() {
                let from = &spots[(i + spots.len() - 1) % spots.len()];
                let a = inside(from);
                let b = inside(to);
                if (a < 0.0) != (b < 0.0) {
                    kept.push(between(*from, *to, a / (a - b)));
                }
                if b >= 0.0 {
                    kept.push(*to);
                }
            }
            spots = kept;
        }
        spots
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

/// Cuts a run of spots into the pieces within `frame`.
fn clip(run: &[Spot], frame: &Rect, pieces: &mut Vec<Vec<Spot>>) {
    if let [only] = run {
        pieces.extend(frame.has(*only).then(|| vec![*only]));
    }
    let mut goes_on = false;
    for pair in run.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let inside = clip_segment(a, b, frame);
        if let Some((from, to)) = inside {
            if !goes_on {
                pieces.push(vec![from]);
            }
            pieces
                .last_mut()
                .into_iter()
                .for_each(|piece| piece.push(to));
        }
        goes_on = inside.is_some_and(|(_, to)| to == b);
    }
}

/// The part of a segment within a rectangle (Liang and Barsky).
fn clip_segment(a: Spot, b: Spot, frame: &Rect) -> Option<(Spot, Spot)> {
    let dx = b.0 - a.0;
    let dy = b.1 - a.1;
    let mut from = 0.0_f64;
    let mut to = 1.0_f64;
    let walls = [
        (-dx, a.0 - frame.x),
        (dx, frame.right() - a.0),
        (-dy, a.1 - frame.y),
        (dy, frame.bottom() - a.1),
    ];
    for (toward, room) in walls {
        if toward == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if toward < 0.0 {
            from = from.max(room / toward);
        } else {
            to = to.min(room / toward);
        }
    }
    if from > to {
        return None;
    }
    Some((
        if from == 0.0 { a } else { between(a, b, from) },
        if to == 1.0 { b } else { between(a, b, to) },
    ))
}
