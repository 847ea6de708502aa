//! The figure as SVG text.

use crate::{
    axes::{Axes, LABEL, Placed, TICK, TICK_LENGTH},
    curve::Frame,
    figure::{Figure, Result, Style},
    font::{CAPTION, FAMILY, Metrics, PANEL_TITLE, TITLE},
    labels::{self, Label},
    layout::{self, Page},
    legend::{self, Legend},
    palette::Colours,
    rect::{PER_MM, Spot},
    strokes::{self, END, MIDDLE, area, series as draw_series, thin, through, upwards},
    ticks,
    xml::{escape, length as n},
};
use std::fmt::Write as _;

pub const INK: &str = "#222222";
pub const SOFT: &str = "#595959";
const GRID: &str = "#e4e4e4";

impl Figure {
    /// The figure as SVG: self-contained, with real text, sized in millimetres.
    ///
    /// # Errors
    /// [`FigureError::Drawing`](crate::FigureError::Drawing) without panels, for a range that is empty or not finite, and where
    /// paper or panel is too small.
    pub fn to_svg(&self) -> Result<String> {
        let metrics = Metrics::new()?;
        let page = layout::page(self, &metrics)?;
        Ok(draw(self, &page))
    }
}

/// The beginning of a drawing on white paper, in units of a quarter of a millimetre.
pub fn head(title: &str, width: f64, height: f64) -> String {
    let w = n(width);
    let h = n(height);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 \
         {w} {h}\" \
         font-family=\"{FAMILY}\" role=\"img\" aria-label=\"{}\">\n\
         <rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n",
        n(width / PER_MM),
        n(height / PER_MM),
        escape(title),
    )
}

/// Writes a laid-out page.
pub fn draw(figure: &Figure, page: &Page<'_>) -> String {
    let colours = &layout::colours(figure);
    let mut out = head(&figure.title, page.width, page.height);
    for (i, line) in page.title.iter().enumerate() {
        let y = 10.0 + TITLE / 2.0 + i as f64 * (TITLE + 4.0);
        // a hair of outline in place of a second, bold face
        let outline = format!(" stroke=\"{INK}\" stroke-width=\"0.35\"");
        text(&mut out, (page.left, y), TITLE, INK, &outline, line);
    }
    for placed in &page.panels {
        draw_panel(&mut out, placed, colours);
    }
    if let Some(legend) = &page.legend {
        draw_legend(&mut out, legend, colours);
    }
    for (i, line) in page.caption.iter().enumerate() {
        text(
            &mut out,
            (page.left, page.caption_y + i as f64 * 12.0),
            CAPTION,
            SOFT,
            "",
            line,
        );
    }
    out.push_str("</svg>\n");
    out
}

/// A text whose middle line runs through `at`.
fn text(out: &mut String, at: Spot, size: f64, fill: &str, attributes: &str, content: &str) {
    strokes::text(
        out,
        (at.0, at.1 + 0.36 * size),
        size,
        fill,
        attributes,
        content,
    );
}

fn draw_panel(out: &mut String, placed: &Placed<'_>, colours: &Colours) {
    out.push_str("<g>\n");
    draw_axes(out, &placed.axes);
    let (x, y, title) = &placed.title;
    if !title.is_empty() {
        let outline = format!(" stroke=\"{INK}\" stroke-width=\"0.2\"");
        text(out, (*x, *y), PANEL_TITLE, INK, &outline, title);
    }
    let frame = &placed.axes.frame;
    let mut anything = false;
    let series = placed.panel.numbered();
    let (bands, others): (Vec<_>, Vec<_>) = series.partition(|(_, s)| s.style == Style::Band);
    for (number, band) in bands {
        area(out, &frame.area(&band.points), &colours.hex(number));
    }
    for (number, series) in others {
        let runs = match series.style {
            Style::Points => vec![frame.markers(&series.points)],
            _ => frame.line(&series.points),
        };
        anything |= runs.iter().any(|run| !run.is_empty());
        let hex = if series.neutral {
            INK.to_owned()
        } else {
            colours.hex(number)
        };
        draw_series(out, &runs, (series.style, number), &hex, colours);
    }
    anything |= draw_marks(out, placed);
    if !anything {
        let middle = placed.axes.frame.plot.middle();
        text(out, middle, LABEL, SOFT, MIDDLE, "no data in this range");
    }
    if let Some(legend) = &placed.legend {
        draw_legend(out, legend, colours);
    }
    for label in &placed.labels {
        draw_label(out, label, colours);
    }
    out.push_str("</g>\n");
}

fn draw_axes(out: &mut String, axes: &Axes) {
    let frame = &axes.frame;
    let plot = frame.plot;
    draw_grid(out, frame);
    let (x, y) = plot.middle();
    let below = plot.bottom() + TICK_LENGTH + 3.0 + TICK / 2.0;
    for (v, label) in frame.x.ticks.iter().zip(&frame.x.labels) {
        text(out, (frame.at_x(*v), below), TICK, INK, MIDDLE, label);
    }
    let before = plot.x - TICK_LENGTH - 3.0;
    for (v, label) in frame.y.ticks.iter().zip(&frame.y.labels) {
        text(out, (before, frame.at_y(*v)), TICK, INK, END, label);
    }
    let row = below + TICK / 2.0 + 3.0 + LABEL / 2.0;
    if frame.x.exponent != 0 {
        let power = ticks::power_text(frame.x.exponent);
        text(out, (plot.right(), row), TICK, INK, END, &power);
    }
    if frame.y.exponent != 0 {
        let power = ticks::power_text(frame.y.exponent);
        text(out, (plot.x, plot.y - 8.0), TICK, INK, "", &power);
    }
    for (i, line) in axes.x_label.iter().enumerate() {
        let at = (x, row + i as f64 * (LABEL + 2.5));
        text(out, at, LABEL, INK, MIDDLE, line);
    }
    for (i, line) in axes.y_label.iter().enumerate() {
        let at = (axes.y_label_x + i as f64 * (LABEL + 2.5), y);
        let turned = format!("{MIDDLE}{}", upwards(at));
        text(out, at, LABEL, INK, &turned, line);
    }
}

/// Lines at the ticks, through zero, and the axes themselves.
fn draw_grid(out: &mut String, frame: &Frame) {
    let (plot, bottom) = (frame.plot, frame.plot.bottom());
    let mut grid = String::new();
    let mut small = String::new();
    let mut zero = String::new();
    let upright = |v: f64| [(frame.at_x(v), plot.y), (frame.at_x(v), bottom)];
    let level = |v: f64| [(plot.x, frame.at_y(v)), (plot.right(), frame.at_y(v))];
    for v in &frame.x.ticks {
        let [_, foot] = upright(*v);
        grid += &through(&upright(*v));
        small += &through(&[foot, (foot.0, bottom + TICK_LENGTH)]);
    }
    for v in &frame.y.ticks {
        let [foot, _] = level(*v);
        grid += &through(&level(*v));
        small += &through(&[(plot.x - TICK_LENGTH, foot.1), foot]);
    }
    thin(out, &grid, GRID, 0.8);
    if frame.y.low < 0.0 && frame.y.high > 0.0 {
        zero += &through(&level(0.0));
    }
    if frame.x.low < 0.0 && frame.x.high > 0.0 {
        zero += &through(&upright(0.0));
    }
    if !zero.is_empty() {
        thin(out, &zero, "#9a9a9a", 0.9);
    }
    let [x, y, bottom, right] = [plot.x, plot.y, bottom, plot.right()].map(n);
    let _ = writeln!(
        out,
        "<path d=\"{small}M{x} {y}V{bottom}H{right}\" stroke=\"{INK}\" stroke-width=\"1\" \
         fill=\"none\" stroke-linecap=\"square\"/>"
    );
}

/// Draws the operating points; tells whether there was one to draw.
fn draw_marks(out: &mut String, placed: &Placed<'_>) -> bool {
    let frame = &placed.axes.frame;
    let mut any = false;
    for mark in &placed.panel.marks {
        let Some((x, y)) = frame.mark(mark) else {
            continue;
        };
        any = true;
        let x = n(x);
        let y = n(y);
        let r = n(labels::RING - 0.7);
        let _ = writeln!(
            out,
            "<g><circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"#ffffff\" stroke=\"{INK}\" \
             stroke-width=\"1.3\"/>\
             <circle cx=\"{x}\" cy=\"{y}\" r=\"2.2\" fill=\"{INK}\"/></g>"
        );
    }
    any
}

fn draw_label(out: &mut String, label: &Label, colours: &Colours) {
    let colour = label
        .colour
        .map_or_else(|| INK.to_owned(), |number| colours.hex(number));
    if let Some((a, b)) = label.leader {
        thin(out, &through(&[a, b]), &colour, 0.7);
    }
    // A white outline below keeps the text readable over a line.
    let halo =
        " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" aria-hidden=\"true\"";
    text(out, label.at, labels::SIZE, "#ffffff", halo, &label.text);
    text(out, label.at, labels::SIZE, &colour, "", &label.text);
}

fn draw_legend(out: &mut String, legend: &Legend, colours: &Colours) {
    out.push_str("<g>\n");
    for (x, y, entry) in &legend.entries {
        let run = match entry.style {
            Style::Points => vec![(x + legend::SAMPLE / 2.0, *y)],
            _ => vec![(*x, *y), (x + legend::SAMPLE, *y)],
        };
        let hex = colours.hex(entry.colour);
        draw_series(out, &[run], (entry.style, entry.colour), &hex, colours);
        text(
            out,
            (x + legend::SAMPLE + 6.0, *y),
            legend::SIZE,
            INK,
            "",
            &entry.label,
        );
    }
    out.push_str("</g>\n");
}
