//! The drawing of a figure that is laid out.

use crate::{
    axes::{Axes, LABEL, Placed, TICK, TICK_LENGTH},
    curve::Frame,
    drawing::{
        Anchor::{self, End, Middle, Start},
        Colour, Drawing, INK,
        Item::{self, Path},
        Paint,
        Shape::{self, Line, Polygon},
        Text, WHITE,
    },
    figure::{Figure, Result, Style},
    font::{CAPTION, Metrics, PANEL_TITLE, TITLE},
    labels::{self, Label},
    layout::{self, Page},
    legend::{self, Legend},
    palette::Colours,
    rect::{Rect, Spot},
    ticks::{self, Scale},
};

const SOFT: Colour = [0x59; 3];
const GRID: Colour = [0xe4; 3];
const ZERO: Colour = [0x9a; 3];
const LINE_WIDTH: f64 = 1.7;
/// From the middle line of a text to its base line, as a share of its size.
const BASE: f64 = 0.36;
/// Radius of a marker.
const MARKER: f64 = 3.1;
/// Their shapes, of which the last is a cross.
const MARKERS: usize = 6;

impl Figure {
    /// The figure as SVG: self-contained, with real text, sized in millimetres.
    ///
    /// # Errors
    /// [`FigureError::Drawing`](crate::FigureError::Drawing) without panels, for a range that is empty or not finite, and where
    /// paper or panel is too small.
    pub fn to_svg(&self) -> Result<String> {
        Ok(self.drawing()?.to_svg())
    }

    pub(crate) fn drawing(&self) -> Result<Drawing> {
        let metrics = Metrics::new()?;
        Ok(draw(self, &layout::page(self, &metrics)?))
    }
}

fn draw(figure: &Figure, page: &Page<'_>) -> Drawing {
    let colours = &layout::colours(figure);
    let mut items = Vec::new();
    for (i, line) in page.title.iter().enumerate() {
        let y = 10.0 + TITLE / 2.0 + i as f64 * (TITLE + 4.0);
        items.push(text((layout::MARGIN, y), TITLE, Start, bold(0.35), line));
    }
    for placed in &page.panels {
        draw_panel(&mut items, placed, colours);
    }
    if let Some(legend) = &page.legend {
        draw_legend(&mut items, legend, colours);
    }
    for (i, line) in page.caption.iter().enumerate() {
        items.push(text(
            (layout::MARGIN, page.caption_y + i as f64 * 12.0),
            CAPTION,
            Start,
            Paint::fill(SOFT),
            line,
        ));
    }
    Drawing {
        title: figure.title.clone(),
        width: page.width,
        height: page.height,
        items,
    }
}

/// A text whose middle line runs through `at`.
fn text(at: Spot, size: f64, anchor: Anchor, paint: Paint, words: &str) -> Item {
    Item::Text(Text {
        paint,
        ..Text::new((at.0, at.1 + BASE * size), size, anchor, words)
    })
}

/// Ink with a hair of outline in place of a second, bold face.
fn bold(width: f64) -> Paint {
    Paint::stroke(INK, width).filled(INK)
}

fn draw_panel(out: &mut Vec<Item>, placed: &Placed<'_>, colours: &Colours) {
    draw_axes(out, &placed.axes);
    let (x, y, title) = &placed.title;
    if !title.is_empty() {
        out.push(text((*x, *y), PANEL_TITLE, Start, bold(0.2), title));
    }
    let frame = &placed.axes.frame;
    let mut anything = false;
    let series = placed.panel.numbered();
    let (bands, others): (Vec<_>, Vec<_>) = series.partition(|(_, s)| s.style == Style::Band);
    for (number, band) in bands {
        let outline = frame.area(&band.points);
        let paint = Paint {
            is_pale: true,
            ..Paint::fill(colours.of(number))
        };
        if outline.len() > 2 {
            out.push(Path(vec![Polygon(outline)], paint));
        }
    }
    for (number, series) in others {
        let runs = match series.style {
            Style::Points => vec![frame.markers(&series.points)],
            _ => frame.line(&series.points),
        };
        anything |= runs.iter().any(|run| !run.is_empty());
        let neutral = series.neutral.then_some(INK);
        draw_series(out, runs, (series.style, number), neutral, colours);
    }
    let marks = placed.panel.marks.iter().filter_map(|m| frame.mark(m));
    let marks: Vec<Item> = marks.flat_map(mark).collect();
    if !anything && marks.is_empty() {
        let (middle, soft) = (frame.plot.middle(), Paint::fill(SOFT));
        out.push(text(middle, LABEL, Middle, soft, "no data in this range"));
    }
    out.extend(marks);
    if let Some(legend) = &placed.legend {
        draw_legend(out, legend, colours);
    }
    for label in &placed.labels {
        draw_label(out, label, colours);
    }
}

/// Draws the runs of a series: lines, or markers.
fn draw_series(
    out: &mut Vec<Item>,
    runs: Vec<Vec<Spot>>,
    (style, number): (Style, usize),
    neutral: Option<Colour>,
    colours: &Colours,
) {
    let colour = neutral.unwrap_or_else(|| colours.of(number));
    let mut paint = Paint::stroke(colour, LINE_WIDTH);
    let mut shapes = Vec::new();
    let mut alone = Vec::new();
    if style == Style::Points {
        let spots = runs.into_iter().flatten();
        shapes.extend(spots.flat_map(|spot| marker(number, spot)));
        let is_cross = number % MARKERS == MARKERS - 1;
        paint.width = if is_cross { 1.4 } else { 1.3 };
        paint.fill = Some(WHITE);
    } else {
        paint.dashes = colours.dashes(style, number);
        for run in runs {
            match *run {
                [spot] => alone.push(Item::circle(spot, 1.8, Paint::fill(colour))),
                _ => shapes.push(Line(run)),
            }
        }
    }
    if !shapes.is_empty() {
        out.push(Path(shapes, paint));
    }
    out.extend(alone);
}

/// The marker of a colour number.
fn marker(number: usize, (x, y): Spot) -> Vec<Shape> {
    let r = MARKER;
    let s = 0.9 * r;
    let polygon = |spots: &[Spot]| vec![Polygon(spots.to_vec())];
    let triangle = |up: f64| {
        let foot = y + 0.85 * r * up;
        polygon(&[
            (x, y - 1.2 * r * up),
            (x + 1.15 * r, foot),
            (x - 1.15 * r, foot),
        ])
    };
    match number % MARKERS {
        0 => vec![Shape::Circle((x, y), r)],
        1 => vec![Shape::Square((x - s, y - s), 2.0 * s)],
        2 => triangle(1.0),
        3 => {
            let s = 1.3 * r;
            polygon(&[(x, y - s), (x + s, y), (x, y + s), (x - s, y)])
        }
        4 => triangle(-1.0),
        _ => {
            let bar = |up: f64| Line(vec![(x - s, y - up), (x + s, y + up)]);
            vec![bar(s), bar(-s)]
        }
    }
}

/// An operating point.
fn mark(at: Spot) -> [Item; 2] {
    [
        Item::circle(
            at,
            labels::RING - 0.7,
            Paint::stroke(INK, 1.3).filled(WHITE),
        ),
        Item::circle(at, 2.2, Paint::fill(INK)),
    ]
}

fn draw_axes(out: &mut Vec<Item>, axes: &Axes) {
    let frame = &axes.frame;
    let plot = frame.plot;
    draw_grid(out, frame);
    let (x, y) = plot.middle();
    let below = plot.bottom() + TICK_LENGTH + 3.0 + TICK / 2.0;
    let ink = Paint::fill(INK);
    let mut write = |at, size, anchor, words: &str| out.push(text(at, size, anchor, ink, words));
    for (v, label) in frame.x.ticks.iter().zip(&frame.x.labels) {
        write((frame.at_x(*v), below), TICK, Middle, label);
    }
    let before = plot.x - TICK_LENGTH - 3.0;
    for (v, label) in frame.y.ticks.iter().zip(&frame.y.labels) {
        write((before, frame.at_y(*v)), TICK, End, label);
    }
    let row = below + TICK / 2.0 + 3.0 + LABEL / 2.0;
    if frame.x.exponent != 0 {
        let power = ticks::power_text(frame.x.exponent);
        write((plot.right(), row), TICK, End, &power);
    }
    if frame.y.exponent != 0 {
        let power = ticks::power_text(frame.y.exponent);
        write((plot.x, plot.y - 8.0), TICK, Start, &power);
    }
    for (i, line) in axes.x_label.iter().enumerate() {
        write((x, row + i as f64 * (LABEL + 2.5)), LABEL, Middle, line);
    }
    for (i, line) in axes.y_label.iter().enumerate() {
        let x = axes.y_label_x + i as f64 * (LABEL + 2.5);
        out.push(Item::Text(Text {
            is_upright: true,
            ..Text::new((x + BASE * LABEL, y), LABEL, Middle, line)
        }));
    }
}

/// Lines at the ticks, through zero, and the axes themselves.
fn draw_grid(out: &mut Vec<Item>, frame: &Frame) {
    let Rect {
        x: left, y: top, ..
    } = frame.plot;
    let (right, bottom) = (frame.plot.right(), frame.plot.bottom());
    let upright = |v: f64, from, to| Line(vec![(frame.at_x(v), from), (frame.at_x(v), to)]);
    let level = |v: f64, from, to| Line(vec![(from, frame.at_y(v)), (to, frame.at_y(v))]);
    let at_ticks = |[a, b]: [f64; 2], [c, d]: [f64; 2]| -> Vec<Shape> {
        let uprights = frame.x.ticks.iter().map(|v| upright(*v, a, b));
        uprights
            .chain(frame.y.ticks.iter().map(|v| level(*v, c, d)))
            .collect()
    };
    out.push(Path(
        at_ticks([top, bottom], [left, right]),
        Paint::stroke(GRID, 0.8),
    ));
    let has_zero = |scale: &Scale| scale.low < 0.0 && scale.high > 0.0;
    let zero = has_zero(&frame.y).then(|| level(0.0, left, right));
    let other = has_zero(&frame.x).then(|| upright(0.0, top, bottom));
    let zero: Vec<Shape> = zero.into_iter().chain(other).collect();
    if !zero.is_empty() {
        out.push(Path(zero, Paint::stroke(ZERO, 0.9)));
    }
    let mut axes = at_ticks([bottom, bottom + TICK_LENGTH], [left - TICK_LENGTH, left]);
    axes.push(Line(vec![(left, top), (left, bottom), (right, bottom)]));
    out.push(Path(axes, Paint::stroke(INK, 1.0)));
}

fn draw_label(out: &mut Vec<Item>, label: &Label, colours: &Colours) {
    let colour = label.colour.map_or(INK, |number| colours.of(number));
    if let Some((a, b)) = label.leader {
        let line = Line(vec![a, b]);
        out.push(Path(vec![line], Paint::stroke(colour, 0.7)));
    }
    let ground = Paint::stroke(WHITE, 3.0).filled(WHITE);
    for paint in [ground, Paint::fill(colour)] {
        out.push(text(label.at, labels::SIZE, Start, paint, &label.text));
    }
}

fn draw_legend(out: &mut Vec<Item>, legend: &Legend, colours: &Colours) {
    for (x, y, entry) in &legend.entries {
        let run = match entry.style {
            Style::Points => vec![(x + legend::SAMPLE / 2.0, *y)],
            _ => vec![(*x, *y), (x + legend::SAMPLE, *y)],
        };
        draw_series(out, vec![run], (entry.style, entry.colour), None, colours);
        let at = (x + legend::SAMPLE + 6.0, *y);
        out.push(text(
            at,
            legend::SIZE,
            Start,
            Paint::fill(INK),
            &entry.label,
        ));
    }
}
