//! Texts beside marks and at the ends of lines, kept clear of the data and of each other.

use crate::Mark;
use crate::curve::{Frame, Rect, Spot};
use crate::font::Metrics;
use crate::room::Room;

/// Font size of these texts.
pub(crate) const SIZE: f64 = 10.0;
/// Radius of the ring of a mark.
pub(crate) const RING: f64 = 5.2;
const HEIGHT: f64 = 11.0;

/// A placed text.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Label {
    /// Left end and middle of the text.
    pub at: Spot,
    pub text: String,
    /// Colour number; `None`: ink.
    pub colour: Option<usize>,
    /// A thin line from the thing to its text.
    pub leader: Option<(Spot, Spot)>,
}

/// A line with a text for its end.
pub(crate) struct Ended {
    pub text: String,
    pub colour: usize,
    pub line: Vec<Spot>,
}

fn around(at: Spot, w: f64) -> Rect {
    Rect { x: at.0, y: at.1 - HEIGHT / 2.0, w, h: HEIGHT }
}

fn cost_of(rect: &Rect, room: &Room, within: &Rect) -> f64 {
    let mut cost = 2.0 * room.drawn_under(&rect.grown(1.0)) as f64;
    if room.meets_box(&rect.grown(1.0)) {
        cost += 1000.0;
    }
    if !within.holds(rect) {
        cost += 3000.0;
    }
    cost
}

/// Notes the rings of the marks, so that texts keep away from all of them.
pub(crate) fn add_rings(marks: &[Mark], frame: &Frame<'_>, room: &mut Room) {
    for spot in marks.iter().filter_map(|m| frame.spot((m.x, m.y))).filter(|s| frame.plot.has(*s)) {
        let r = RING + 1.0;
        room.add_box(Rect { x: spot.0 - r, y: spot.1 - r, w: 2.0 * r, h: 2.0 * r });
    }
}

/// Places the texts of the marks.
pub(crate) fn of_marks(marks: &[Mark], frame: &Frame<'_>, metrics: &Metrics, room: &mut Room) -> Vec<Label> {
    let within = frame.plot.grown(-2.0);
    let mut labels = Vec::new();
    for mark in marks {
        let Some(spot) = frame.spot((mark.x, mark.y)).filter(|s| frame.plot.grown(0.01).has(*s)) else {
            continue;
        };
        let text = metrics.fit(mark.label.trim(), SIZE, within.w);
        if text.is_empty() {
            continue;
        }
        let w = metrics.width(&text, SIZE);
        let mut best: Option<(f64, Spot, f64)> = None;
        for (ring, distance) in [RING + 3.0, RING + 12.0, RING + 24.0, RING + 40.0].into_iter().enumerate() {
            for (turn, angle) in [30.0, -30.0, 150.0, -150.0, 0.0, 180.0, 90.0, -90.0, 60.0, -60.0, 120.0]
                .into_iter()
                .enumerate()
            {
                let (up, across) = f64::to_radians(angle).sin_cos();
                // the near edge of the text lies at the distance in this direction
                let middle = (
                    spot.0
                        + across * distance
                        + across.signum() * (across.abs() > 0.01) as u8 as f64 * w / 2.0,
                    spot.1 - up * (distance + HEIGHT / 2.0 - 2.0),
                );
                let at = (middle.0 - w / 2.0, middle.1);
                let cost = cost_of(&around(at, w), room, &within) + 5.0 * ring as f64 + 0.4 * turn as f64;
                if best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, at, distance));
                }
            }
        }
        let Some((_, at, distance)) = best else { continue };
        let at = inside(at, w, &within);
        let rect = around(at, w);
        room.add_box(rect);
        let leader = (distance > RING + 4.0).then(|| leader(spot, &rect)).flatten();
        labels.push(Label { at, text, colour: None, leader });
    }
    labels
}

/// Moves a text into the allowed rectangle.
fn inside(at: Spot, w: f64, within: &Rect) -> Spot {
    let x = at.0.min(within.right() - w).max(within.x);
    let y = at.1.min(within.bottom() - HEIGHT / 2.0).max(within.y + HEIGHT / 2.0);
    (x, y)
}

/// The line from a ring to the nearest place of a text's box.
fn leader(spot: Spot, rect: &Rect) -> Option<(Spot, Spot)> {
    let near = (spot.0.clamp(rect.x - 1.0, rect.right() + 1.0), spot.1.clamp(rect.y, rect.bottom()));
    let (dx, dy) = (near.0 - spot.0, near.1 - spot.1);
    let length = dx.hypot(dy);
    (length > RING + 2.0).then(|| {
        let part = RING / length;
        ((spot.0 + part * dx, spot.1 + part * dy), near)
    })
}

/// Whether the text of a line belongs to the right of the plot: the line reaches the edge.
pub(crate) fn reaches_edge(line: &[Spot], plot: &Rect) -> bool {
    line.last().is_some_and(|end| end.0 > plot.right() - 0.02 * plot.w)
}

/// Places the texts at the ends of lines: those that reach the right edge beside the plot
/// (spread so that they do not overlap), the others along their line, near its end.
pub(crate) fn of_lines(lines: Vec<Ended>, metrics: &Metrics, room: &mut Room) -> Vec<Label> {
    let plot = room.plot();
    let (edge, inner): (Vec<_>, Vec<_>) =
        lines.into_iter().filter(|l| !l.line.is_empty()).partition(|l| reaches_edge(&l.line, &plot));
    let mut labels = beside(edge, &plot);
    for line in inner {
        labels.extend(along(line, metrics, room));
    }
    labels
}

fn beside(mut lines: Vec<Ended>, plot: &Rect) -> Vec<Label> {
    let end = |l: &Ended| l.line.last().map_or(plot.y, |s| s.1);
    lines.sort_by(|a, b| end(a).total_cmp(&end(b)));
    let mut heights: Vec<f64> = lines.iter().map(end).collect();
    // push down what is too close, then up again what left the plot
    let step = HEIGHT + 0.5;
    for i in 1..heights.len() {
        heights[i] = heights[i].max(heights[i - 1] + step);
    }
    let mut limit = plot.bottom();
    for height in heights.iter_mut().rev() {
        *height = height.min(limit);
        limit = *height - step;
    }
    let text_x = plot.right() + 7.0;
    lines
        .iter()
        .zip(heights)
        .map(|(line, y)| {
            let from = (plot.right() + 1.0, end(line));
            let leader = ((from.1 - y).abs() > 3.0).then_some((from, (text_x - 1.0, y)));
            Label { at: (text_x, y), text: line.text.clone(), colour: Some(line.colour), leader }
        })
        .collect()
}

fn along(line: Ended, metrics: &Metrics, room: &mut Room) -> Option<Label> {
    let within = room.plot().grown(-2.0);
    let w = metrics.width(&line.text, SIZE);
    let mut best: Option<(f64, Spot)> = None;
    for station in 0..=24 {
        let part = f64::from(station) / 25.0;
        let (spot, direction) = station_of(&line.line, part);
        let normals = [(direction.1, -direction.0), (-direction.1, direction.0)];
        for (side, normal) in normals.into_iter().enumerate() {
            // so far along the normal that the box just clears the line
            let clear = normal.0.abs() * w / 2.0 + normal.1.abs() * HEIGHT / 2.0 + 3.0;
            let middle = (spot.0 + normal.0 * clear, spot.1 + normal.1 * clear);
            let at = (middle.0 - w / 2.0, middle.1);
            let cost = cost_of(&around(at, w), room, &within) + 14.0 * part + 0.5 * side as f64;
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, at));
            }
        }
    }
    let (_, at) = best?;
    let at = inside(at, w, &within);
    room.add_box(around(at, w));
    Some(Label { at, text: line.text, colour: Some(line.colour), leader: None })
}

/// The spot a part of the way back from the end of a line, and the direction there.
fn station_of(line: &[Spot], part: f64) -> (Spot, Spot) {
    let lengths = || line.windows(2).map(|p| (p[1].0 - p[0].0).hypot(p[1].1 - p[0].1));
    let total: f64 = lengths().sum();
    let mut left = total * (1.0 - part);
    let mut last = ((0.0, 0.0), (1.0, 0.0));
    if let Some(first) = line.first() {
        last.0 = *first;
    }
    for (pair, length) in line.windows(2).zip(lengths()) {
        if length <= 0.0 {
            continue;
        }
        let direction = ((pair[1].0 - pair[0].0) / length, (pair[1].1 - pair[0].1) / length);
        let t = left.min(length);
        last = ((pair[0].0 + direction.0 * t, pair[0].1 + direction.1 * t), direction);
        if left <= length {
            break;
        }
        left -= length;
    }
    last
}
