//! Texts that name lines directly: beside the plot where lines reach its right edge, otherwise
//! beside the line.

use crate::{
    font::Metrics,
    labels::{HEIGHT, Label, SIZE, cheapest},
    rect::{Rect, Spot},
    room::Room,
};

/// A line with its text.
pub struct Ended {
    pub text: String,
    /// Colour number; that of the text where it has none.
    pub colour: Option<usize>,
    pub line: Vec<Spot>,
}

/// Places tried along a line, from its end backward.
const STATIONS: usize = 40;

/// Whether the text of a line belongs to the right of the plot: the line reaches the edge.
pub fn reaches_edge(line: &[Spot], plot: &Rect) -> bool {
    line.last()
        .is_some_and(|end| end.0 > plot.right() - 0.02 * plot.w)
}

/// Places the texts of the lines.
pub fn for_lines(lines: Vec<Ended>, metrics: &Metrics, room: &mut Room) -> Vec<Label> {
    let plot = room.plot;
    let (edge, inner): (Vec<_>, Vec<_>) = lines
        .into_iter()
        .partition(|l| reaches_edge(&l.line, &plot));
    let mut labels = beside_plot(edge, &plot);
    labels.extend(inner.into_iter().map(|line| along(line, metrics, room)));
    labels
}

/// Texts to the right of the plot, spread so that they do not overlap.
fn beside_plot(mut lines: Vec<Ended>, plot: &Rect) -> Vec<Label> {
    let end = |l: &Ended| l.line.last().map_or(plot.y, |s| s.1);
    lines.sort_by(|a, b| end(a).total_cmp(&end(b)));
    let wanted: Vec<f64> = lines.iter().map(end).collect();
    let heights = spread(&wanted, HEIGHT + 1.5, plot.y, plot.bottom());
    let text_x = plot.right() + 8.0;
    let place = |(line, y): (&Ended, f64)| {
        let from = (plot.right() + 1.0, end(line));
        Label {
            at: (text_x, y),
            text: line.text.clone(),
            colour: line.colour,
            leader: ((from.1 - y).abs() > 3.0).then_some((from, (text_x - 1.0, y))),
        }
    };
    lines.iter().zip(heights).map(place).collect()
}

/// Moves rising values apart to at least `step`, each group about its middle, within limits
/// if they fit.
fn spread(wanted: &[f64], step: f64, low: f64, high: f64) -> Vec<f64> {
    // groups of (sum of first places, count) that touch are merged until none touch
    let mut groups: Vec<(f64, usize)> = Vec::new();
    let top = |group: &(f64, usize)| {
        let first = group.0 / group.1 as f64;
        first.min(high - (group.1 - 1) as f64 * step).max(low)
    };
    for value in wanted {
        groups.push((*value, 1));
        while let [.., a, b] = groups.as_slice() {
            if top(a) + a.1 as f64 * step <= top(b) {
                break;
            }
            let both = (a.0 + b.0 - a.1 as f64 * step * b.1 as f64, a.1 + b.1);
            groups.truncate(groups.len() - 2);
            groups.push(both);
        }
    }
    groups
        .iter()
        .flat_map(|g| (0..g.1).map(move |k| top(g) + k as f64 * step))
        .collect()
}

/// A text beside its line, as near to its end as there is room.
fn along(line: Ended, metrics: &Metrics, room: &mut Room) -> Label {
    let w = metrics.width(&line.text, SIZE);
    let places = (0..=STATIONS).flat_map(|number| {
        let part = number as f64 / STATIONS as f64;
        let (spot, (x, y)) = station(&line.line, part);
        [(0.0, (y, -x)), (0.5, (-y, x))].map(|(cost, normal)| {
            // so far along the normal that the box just clears the line
            let clear = normal.0.abs() * w / 2.0 + normal.1.abs() * HEIGHT / 2.0 + 3.0;
            let at = (
                spot.0 + normal.0 * clear - w / 2.0,
                spot.1 + normal.1 * clear,
            );
            (14.0 * part + cost, at)
        })
    });
    Label {
        at: cheapest(places, w, room),
        text: line.text,
        colour: line.colour,
        leader: None,
    }
}

fn lengths(line: &[Spot]) -> impl Iterator<Item = f64> {
    line.windows(2)
        .map(|p| (p[1].0 - p[0].0).hypot(p[1].1 - p[0].1))
}

/// The spot a part of the way back from the end of a line, and the direction there.
fn station(line: &[Spot], part: f64) -> (Spot, Spot) {
    let mut rest = lengths(line).sum::<f64>() * (1.0 - part);
    let mut last = (line.first().copied().unwrap_or_default(), (1.0, 0.0));
    for (pair, length) in line.windows(2).zip(lengths(line)) {
        if length <= 0.0 {
            continue;
        }
        let direction = (
            (pair[1].0 - pair[0].0) / length,
            (pair[1].1 - pair[0].1) / length,
        );
        let t = rest.min(length);
        last = (
            (pair[0].0 + direction.0 * t, pair[0].1 + direction.1 * t),
            direction,
        );
        if rest <= length {
            break;
        }
        rest -= length;
    }
    last
}
