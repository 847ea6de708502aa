//! The drawing of a figure that is laid out.

use crate::{
    axes::{Axes, LABEL, Placed, TICK, TICK_LENGTH},
    curve::Frame,
    drawing::{
        Anchor::{self, End, Middle, Start},
        Cap, Colour, Drawing, INK, Item, Paint, Shape, Text, WHITE,
    },
    figure::{Figure, Result, Style},
    font::{CAPTION, Metrics, PANEL_TITLE, TITLE},
    labels::{self, Label},
    layout::{self, Page},
    legend::{self, Legend},
    palette::{
        self, Colours,
        Marker::{self, Circle, Cross, Diamond, Square, Triangle, TriangleDown},
    },
    rect::Spot,
    ticks,
};

const SOFT: Colour = [0x59; 3];
const GRID: Colour = [0xe4; 3];
const ZERO: Colour = [0x9a; 3];
const LINE_WIDTH: f64 = 1.7;
/// Radius of a marker.
const MARKER: f64 = 3.1;

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
        items.push(text((page.left, y), TITLE, Start, bold(0.35), line));
    }
    items.extend(page.panels.iter().map(|placed| panel(placed, colours)));
    items.extend(
        page.legend
            .iter()
            .map(|legend| drawn_legend(legend, colours)),
    );
    for (i, line) in page.caption.iter().enumerate() {
        let at = (page.left, page.caption_y + i as f64 * 12.0);
        items.push(text(at, CAPTION, Start, Paint::fill(SOFT), line));
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
        ..Text::new((at.0, at.1 + 0.36 * size), size, anchor, words)
    })
}

/// Ink with a hair of outline in place of a second, bold face.
fn bold(width: f64) -> Paint {
    Paint::stroke(INK, width).filled(INK)
}

fn panel(placed: &Placed<'_>, colours: &Colours) -> Item {
    let mut out = Vec::new();
    draw_axes(&mut out, &placed.axes);
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
            out.push(Item::Path(vec![Shape::Polygon(outline)], paint));
        }
    }
    for (number, series) in others {
        let runs = match series.style {
            Style::Points => vec![frame.markers(&series.points)],
            _ => frame.line(&series.points),
        };
        anything |= runs.iter().any(|run| !run.is_empty());
        let neutral = series.neutral.then_some(INK);
        draw_series(&mut out, runs, (series.style, number), neutral, colours);
    }
    let marks = placed.panel.marks.iter();
    let marks: Vec<Item> = marks.filter_map(|m| frame.mark(m)).map(mark).collect();
    if !anything && marks.is_empty() {
        let (middle, soft) = (frame.plot.middle(), Paint::fill(SOFT));
        out.push(text(middle, LABEL, Middle, soft, "no data in this range"));
    }
    out.extend(marks);
    out.extend(
        placed
            .legend
            .iter()
            .map(|legend| drawn_legend(legend, colours)),
    );
    placed
        .labels
        .iter()
        .for_each(|label| draw_label(&mut out, label, colours));
    Item::group(out)
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
    let mut paint = Paint {
        has_round_joins: true,
        ..Paint::stroke(colour, LINE_WIDTH)
    };
    let mut shapes = Vec::new();
    let mut alone = Vec::new();
    if style == Style::Points {
        let kind = palette::marker(number);
        let spots = runs.into_iter().flatten();
        shapes.extend(spots.flat_map(|spot| marker(kind, spot)));
        paint.width = if kind == Cross { 1.4 } else { 1.3 };
        paint.fill = Some(WHITE);
    } else {
        paint.dashes = colours.dashes(style, number);
        if paint.dashes.is_empty() {
            paint.cap = Cap::Round;
        }
        for run in runs {
            match *run {
                [spot] => alone.push(Item::Circle(spot, 1.8, Paint::fill(colour))),
                _ => shapes.push(Shape::Line(run)),
            }
        }
    }
    if !shapes.is_empty() {
        out.push(Item::Path(shapes, paint));
    }
    out.extend(alone);
}

fn marker(kind: Marker, (x, y): Spot) -> Vec<Shape> {
    let r = MARKER;
    let s = 0.9 * r;
    vec![match kind {
        Circle => Shape::Circle((x, y), r),
        Square => Shape::Square((x - s, y - s), 2.0 * s),
        Triangle | TriangleDown => {
            let up = if kind == Triangle { 1.0 } else { -1.0 };
            let foot = y + 0.85 * r * up;
            Shape::Polygon(vec![
                (x, y - 1.2 * r * up),
                (x + 1.15 * r, foot),
                (x - 1.15 * r, foot),
            ])
        }
        Diamond => {
            let s = 1.3 * r;
            Shape::Polygon(vec![(x, y - s), (x + s, y), (x, y + s), (x - s, y)])
        }
        Cross => {
            let bar = |up: f64| Shape::Line(vec![(x - s, y - up), (x + s, y + up)]);
            return vec![bar(s), bar(-s)];
        }
    }]
}

/// An operating point.
fn mark(at: Spot) -> Item {
    Item::group(vec![
        Item::Circle(
            at,
            labels::RING - 0.7,
            Paint::stroke(INK, 1.3).filled(WHITE),
        ),
        Item::Circle(at, 2.2, Paint::fill(INK)),
    ])
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
        let at = (x, row + i as f64 * (LABEL + 2.5));
        write(at, LABEL, Middle, line);
    }
    for (i, line) in axes.y_label.iter().enumerate() {
        let at = (axes.y_label_x + i as f64 * (LABEL + 2.5), y);
        out.push(text(at, LABEL, Middle, ink, line).turned_about(at));
    }
}

/// Lines at the ticks, through zero, and the axes themselves.
fn draw_grid(out: &mut Vec<Item>, frame: &Frame) {
    let (plot, bottom) = (frame.plot, frame.plot.bottom());
    let line = |from, to| Shape::Line(vec![from, to]);
    let upright = |v: f64| line((frame.at_x(v), plot.y), (frame.at_x(v), bottom));
    let level = |v: f64| line((plot.x, frame.at_y(v)), (plot.right(), frame.at_y(v)));
    let [across, up] = [&frame.x.ticks, &frame.y.ticks].map(|ticks| ticks.iter().copied());
    let grid = across.clone().map(upright).chain(up.clone().map(level));
    out.push(Item::Path(grid.collect(), Paint::stroke(GRID, 0.8)));
    let mut zero = Vec::new();
    if frame.y.low < 0.0 && frame.y.high > 0.0 {
        zero.push(level(0.0));
    }
    if frame.x.low < 0.0 && frame.x.high > 0.0 {
        zero.push(upright(0.0));
    }
    if !zero.is_empty() {
        out.push(Item::Path(zero, Paint::stroke(ZERO, 0.9)));
    }
    let below = across.map(|v| frame.at_x(v));
    let below = below.map(|x| line((x, bottom), (x, bottom + TICK_LENGTH)));
    let beside = up.map(|v| frame.at_y(v));
    let small = below.chain(beside.map(|y| line((plot.x - TICK_LENGTH, y), (plot.x, y))));
    let axes = Shape::Axes((plot.x, plot.y), (plot.right(), bottom));
    let paint = Paint {
        cap: Cap::Square,
        ..Paint::stroke(INK, 1.0)
    };
    out.push(Item::Path(small.chain([axes]).collect(), paint));
}

fn draw_label(out: &mut Vec<Item>, label: &Label, colours: &Colours) {
    let colour = label.colour.map_or(INK, |number| colours.of(number));
    if let Some((a, b)) = label.leader {
        let line = Shape::Line(vec![a, b]);
        out.push(Item::Path(vec![line], Paint::stroke(colour, 0.7)));
    }
    let ground = Paint {
        has_round_joins: true,
        ..Paint::stroke(WHITE, 3.0).filled(WHITE)
    };
    for paint in [ground, Paint::fill(colour)] {
        out.push(text(label.at, labels::SIZE, Start, paint, &label.text));
    }
}

fn drawn_legend(legend: &Legend, colours: &Colours) -> Item {
    let mut out = Vec::new();
    for (x, y, entry) in &legend.entries {
        let run = match entry.style {
            Style::Points => vec![(x + legend::SAMPLE / 2.0, *y)],
            _ => vec![(*x, *y), (x + legend::SAMPLE, *y)],
        };
        draw_series(
            &mut out,
            vec![run],
            (entry.style, entry.colour),
            None,
            colours,
        );
        let at = (x + legend::SAMPLE + 6.0, *y);
        out.push(text(
            at,
            legend::SIZE,
            Start,
            Paint::fill(INK),
            &entry.label,
        ));
    }
    Item::group(out)
}
