//! Texts that name lines directly: beside the plot where lines reach its right edge,
//! otherwise set into the line like the heights of a map.

use crate::font::Metrics;
use crate::labels::{HEIGHT, Label, SIZE, around, cost_of, inside};
use crate::rect::{Rect, Spot};
use crate::room::Room;

/// A line with its text.
pub(crate) struct Ended {
    pub text: String,
    /// Colour number; that of the text where it has none.
    pub colour: Option<usize>,
    /// Number of the series in its panel.
    pub series: usize,
    pub line: Vec<Spot>,
}

/// Places tried along a line, from its end backward.
const STATIONS: usize = 40;
/// A cost no free place has.
const BLOCKED: f64 = 12.0;

/// Whether the text of a line belongs to the right of the plot: the line reaches the edge.
pub(crate) fn reaches_edge(line: &[Spot], plot: &Rect) -> bool {
    line.last().is_some_and(|end| end.0 > plot.right() - 0.02 * plot.w)
}

/// Places the texts of the lines.
pub(crate) fn of_lines(lines: Vec<Ended>, metrics: &Metrics, room: &mut Room) -> Vec<Label> {
    let plot = room.plot();
    let (edge, inner): (Vec<_>, Vec<_>) =
        lines.into_iter().filter(|l| !l.line.is_empty()).partition(|l| reaches_edge(&l.line, &plot));
    let mut labels = beside_plot(edge, &plot);
    if let Some(together) = common_station(&inner, metrics, room) {
        labels.extend(together);
        return labels;
    }
    for line in inner {
        let set_in = (0..=STATIONS)
            .filter_map(|s| set_into(&line, s as f64 / STATIONS as f64, metrics, room))
            .min_by(|a, b| a.cost.total_cmp(&b.cost))
            .filter(|place| place.cost < 2.0 * BLOCKED);
        match set_in {
            Some(place) => {
                place.boxes.iter().for_each(|b| room.add_box(*b));
                labels.push(place.label);
            }
            None => labels.extend(along(line, metrics, room)),
        }
    }
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
        let leader = ((from.1 - y).abs() > 3.0).then_some((from, (text_x - 1.0, y)));
        Label { at: (text_x, y), turn: None, text: line.text.clone(), colour: line.colour, leader }
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
    groups.iter().flat_map(|g| (0..g.1).map(move |k| top(g) + k as f64 * step)).collect()
}

/// A text set into its line.
struct LabelPosition {
    cost: f64,
    label: Label,
    /// The room it takes.
    boxes: Vec<Rect>,
}

/// One part of the way at which all texts stand freely, so that they line up.
fn common_station(lines: &[Ended], metrics: &Metrics, room: &mut Room) -> Option<Vec<Label>> {
    if lines.len() < 2 {
        return None;
    }
    let mut best: Option<(f64, Vec<LabelPosition>)> = None;
    for station in 0..=STATIONS {
        let part = station as f64 / STATIONS as f64;
        let places: Vec<_> = lines.iter().map_while(|l| set_into(l, part, metrics, room)).collect();
        let free = places.iter().all(|p| p.cost < BLOCKED);
        if places.len() < lines.len() || !free || meet(&places) {
            continue;
        }
        let cost = places.iter().map(|p| p.cost).sum();
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, places));
        }
    }
    let (_, places) = best?;
    places.iter().flat_map(|p| &p.boxes).for_each(|b| room.add_box(*b));
    Some(places.into_iter().map(|p| p.label).collect())
}

fn meet(places: &[LabelPosition]) -> bool {
    let touch = |a: &LabelPosition, b: &LabelPosition| {
        a.boxes.iter().any(|r| b.boxes.iter().any(|s| r.grown(1.0).meets(s)))
    };
    places.iter().enumerate().any(|(i, a)| places[..i].iter().any(|b| touch(a, b)))
}

/// A text set into its line, turned with it, a part of the way back from the end.
fn set_into(line: &Ended, part: f64, metrics: &Metrics, room: &Room) -> Option<LabelPosition> {
    let w = metrics.width(&line.text, SIZE);
    let total = length_of(&line.line);
    if total < 1.6 * w {
        return None;
    }
    let reach = (w / 2.0 + 4.0) / total;
    let part = reach + part * (1.0 - 2.0 * reach);
    let (a, b) = (station_of(&line.line, part - reach).0, station_of(&line.line, part + reach).0);
    let on_line = station_of(&line.line, part).0;
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let chord = dx.hypot(dy);
    if chord < 0.9 * w {
        return None;
    }
    let (dx, dy) = if dx < 0.0 { (-dx / chord, -dy / chord) } else { (dx / chord, dy / chord) };
    // the middle of the chord and of the line together: half the sag each way
    let middle = ((a.0 + b.0) / 4.0 + on_line.0 / 2.0, (a.1 + b.1) / 4.0 + on_line.1 / 2.0);
    let count = (w / 6.0).ceil().max(1.0) as usize;
    let boxes: Vec<Rect> = (0..=count)
        .map(|i| (i as f64 / count as f64 - 0.5) * (w - 0.6 * HEIGHT))
        .map(|along| (middle.0 + along * dx, middle.1 + along * dy))
        .map(|c| Rect { x: c.0 - HEIGHT / 2.0, y: c.1 - HEIGHT / 2.0, w: HEIGHT, h: HEIGHT })
        .collect();
    let within = room.plot().grown(-1.0);
    let worst: f64 = boxes
        .iter()
        .map(|b| {
            let near_text = if room.meets_box(&b.grown(5.0)) { 1000.0 } else { 0.0 };
            near_text + cost_of(&b.grown(1.5), room, &within, Some(line.series))
        })
        .sum();
    let sag = (1.0 - chord / (w + 8.0)).max(0.0);
    let label = Label {
        at: middle,
        turn: Some((dy.atan2(dx).to_degrees(), w)),
        text: line.text.clone(),
        colour: line.colour,
        leader: None,
    };
    Some(LabelPosition { cost: worst + 8.0 * part + 60.0 * sag, label, boxes })
}

/// A text beside its line, as near to its end as there is room.
fn along(line: Ended, metrics: &Metrics, room: &mut Room) -> Option<Label> {
    let within = room.plot().grown(-2.0);
    let w = metrics.width(&line.text, SIZE);
    let mut best: Option<(f64, Spot)> = None;
    for station in 0..=STATIONS {
        let part = station as f64 / STATIONS as f64;
        let (spot, direction) = station_of(&line.line, part);
        let normals = [(direction.1, -direction.0), (-direction.1, direction.0)];
        for (side, normal) in normals.into_iter().enumerate() {
            // so far along the normal that the box just clears the line
            let clear = normal.0.abs() * w / 2.0 + normal.1.abs() * HEIGHT / 2.0 + 3.0;
            let middle = (spot.0 + normal.0 * clear, spot.1 + normal.1 * clear);
            let at = (middle.0 - w / 2.0, middle.1);
            let cost = cost_of(&around(at, w), room, &within, None) + 14.0 * part + 0.5 * side as f64;
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, at));
            }
        }
    }
    let (_, at) = best?;
    let at = inside(at, w, &within);
    room.add_box(around(at, w));
    Some(Label { at, turn: None, text: line.text, colour: line.colour, leader: None })
}

fn lengths(line: &[Spot]) -> impl Iterator<Item = f64> {
    line.windows(2).map(|p| (p[1].0 - p[0].0).hypot(p[1].1 - p[0].1))
}

fn length_of(line: &[Spot]) -> f64 {
    lengths(line).sum()
}

/// The spot a part of the way back from the end of a line, and the direction there.
fn station_of(line: &[Spot], part: f64) -> (Spot, Spot) {
    let mut left = length_of(line) * (1.0 - part);
    let mut last = (line.first().copied().unwrap_or_default(), (1.0, 0.0));
    for (pair, length) in line.windows(2).zip(lengths(line)) {
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
