//! The figure as SVG text.

use std::fmt::Write as _;

use crate::axes::{Axes, LABEL, Placed, TICK, TICK_LENGTH};
use crate::font::{FAMILY, Metrics};
use crate::labels::{self, Label};
use crate::layout::{self, CAPTION, PANEL_TITLE, PER_MM, Page, TITLE};
use crate::legend::{self, Legend};
use crate::rect::Spot;
use crate::strokes::{Brush, area, series as draw_series, through};
use crate::xml::{escape, length as n};
use crate::{Figure, Result, Style, palette, ticks};

pub(crate) const INK: &str = "#222222";
pub(crate) const SOFT: &str = "#595959";
const GRID: &str = "#e4e4e4";

impl Figure {
    /// The figure as SVG: self-contained, with real text, sized in millimetres.
    ///
    /// # Errors
    /// [`FigureError::Drawing`] without panels, for a range that is empty or not finite, and where
    /// paper or panel is too small.
    pub fn to_svg(&self) -> Result<String> {
        let metrics = Metrics::new()?;
        let page = layout::page(self, &metrics)?;
        Ok(draw(self, &page))
    }
}

/// The colours of the series of a figure.
struct Pen<'a> {
    figure: &'a Figure,
    colours: usize,
}

impl Pen<'_> {
    fn brush(&self, number: usize) -> Brush {
        Brush {
            number,
            hex: self.hex(number),
            palette: self.figure.palette,
        }
    }

    fn hex(&self, number: usize) -> String {
        palette::hex(self.figure.palette, number, self.colours)
    }
}

/// The beginning of a drawing on white paper, in units of a quarter of a millimetre.
pub(crate) fn head(title: &str, width: f64, height: f64) -> String {
    let (w, h) = (n(width), n(height));
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
pub(crate) fn draw(figure: &Figure, page: &Page<'_>) -> String {
    let pen = Pen {
        figure,
        colours: layout::colour_count(figure),
    };
    let mut out = head(&figure.title, page.width, page.height);
    for (i, line) in page.title.iter().enumerate() {
        let y = 10.0 + TITLE / 2.0 + i as f64 * (TITLE + 4.0);
        // a hair of outline in place of a second, bold face
        let outline = format!(" stroke=\"{INK}\" stroke-width=\"0.35\"");
        text(&mut out, (page.left, y), TITLE, INK, &outline, line);
    }
    for placed in &page.panels {
        draw_panel(&mut out, placed, &pen);
    }
    if let Some(legend) = &page.legend {
        draw_legend(&mut out, legend, &pen);
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

/// Attributes of a text that does not start at its place.
const MIDDLE: &str = " text-anchor=\"middle\"";
const END: &str = " text-anchor=\"end\"";

/// A text whose middle line runs through `at`.
fn text(out: &mut String, at: Spot, size: f64, fill: &str, attributes: &str, content: &str) {
    let _ = writeln!(
        out,
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{fill}\"{attributes}>{}</text>",
        n(at.0),
        n(at.1 + 0.36 * size),
        n(size),
        escape(content)
    );
}

fn draw_panel(out: &mut String, placed: &Placed<'_>, pen: &Pen<'_>) {
    out.push_str("<g>\n");
    draw_axes(out, &placed.axes);
    let (x, y, title) = &placed.title;
    if !title.is_empty() {
        let outline = format!(" stroke=\"{INK}\" stroke-width=\"0.2\"");
        text(out, (*x, *y), PANEL_TITLE, INK, &outline, title);
    }
    let frame = placed.axes.frame();
    let mut anything = false;
    let bands = |s: &&crate::Series| s.style == Style::Band;
    for (i, band) in placed
        .panel
        .series
        .iter()
        .enumerate()
        .filter(|(_, s)| bands(s))
    {
        area(out, &frame.area(&band.points), &pen.hex(band.number(i)));
    }
    for (i, series) in placed
        .panel
        .series
        .iter()
        .enumerate()
        .filter(|(_, s)| !bands(s))
    {
        let runs = match series.style {
            Style::Points => vec![frame.markers(&series.points)],
            _ => frame.line(&series.points),
        };
        anything |= runs.iter().any(|run| !run.is_empty());
        let brush = pen.brush(series.number(i));
        let brush = if series.neutral {
            Brush {
                hex: INK.into(),
                ..brush
            }
        } else {
            brush
        };
        draw_series(out, &runs, series.style, &brush);
    }
    anything |= draw_marks(out, placed);
    if !anything {
        let plot = placed.axes.plot;
        let middle = (plot.x + plot.w / 2.0, plot.y + plot.h / 2.0);
        text(out, middle, LABEL, SOFT, MIDDLE, "no data in this range");
    }
    if let Some(legend) = &placed.legend {
        draw_legend(out, legend, pen);
    }
    for label in &placed.labels {
        draw_label(out, label, pen);
    }
    out.push_str("</g>\n");
}

fn draw_axes(out: &mut String, axes: &Axes) {
    let plot = axes.plot;
    let at_x = |v: f64| plot.x + axes.x.part(v) * plot.w;
    let at_y = |v: f64| plot.bottom() - axes.y.part(v) * plot.h;
    let (mut grid, mut small) = (String::new(), String::new());
    for v in &axes.x.ticks {
        through(&mut grid, &[(at_x(*v), plot.y), (at_x(*v), plot.bottom())]);
        through(
            &mut small,
            &[
                (at_x(*v), plot.bottom()),
                (at_x(*v), plot.bottom() + TICK_LENGTH),
            ],
        );
    }
    for v in &axes.y.ticks {
        through(&mut grid, &[(plot.x, at_y(*v)), (plot.right(), at_y(*v))]);
        through(
            &mut small,
            &[(plot.x - TICK_LENGTH, at_y(*v)), (plot.x, at_y(*v))],
        );
    }
    let _ = writeln!(
        out,
        "<path d=\"{grid}\" stroke=\"{GRID}\" stroke-width=\"0.8\" fill=\"none\"/>"
    );
    let mut zero = String::new();
    if axes.y.low < 0.0 && axes.y.high > 0.0 {
        through(&mut zero, &[(plot.x, at_y(0.0)), (plot.right(), at_y(0.0))]);
    }
    if axes.x.low < 0.0 && axes.x.high > 0.0 {
        through(
            &mut zero,
            &[(at_x(0.0), plot.y), (at_x(0.0), plot.bottom())],
        );
    }
    if !zero.is_empty() {
        let _ = writeln!(
            out,
            "<path d=\"{zero}\" stroke=\"#9a9a9a\" stroke-width=\"0.9\" fill=\"none\"/>"
        );
    }
    let _ = writeln!(
        out,
        "<path d=\"{small}M{} {}V{}H{}\" stroke=\"{INK}\" stroke-width=\"1\" fill=\"none\" \
         stroke-linecap=\"square\"/>",
        n(plot.x),
        n(plot.y),
        n(plot.bottom()),
        n(plot.right())
    );
    let below = plot.bottom() + TICK_LENGTH + 3.0 + TICK / 2.0;
    for (v, label) in axes.x.ticks.iter().zip(&axes.x.labels) {
        text(out, (at_x(*v), below), TICK, INK, MIDDLE, label);
    }
    for (v, label) in axes.y.ticks.iter().zip(&axes.y.labels) {
        text(
            out,
            (plot.x - TICK_LENGTH - 3.0, at_y(*v)),
            TICK,
            INK,
            END,
            label,
        );
    }
    let row = below + TICK / 2.0 + 3.0 + LABEL / 2.0;
    if axes.x.exponent != 0 {
        text(
            out,
            (plot.right(), row),
            TICK,
            INK,
            END,
            &ticks::power_text(axes.x.exponent),
        );
    }
    if axes.y.exponent != 0 {
        text(
            out,
            (plot.x, plot.y - 8.0),
            TICK,
            INK,
            "",
            &ticks::power_text(axes.y.exponent),
        );
    }
    for (i, line) in axes.x_label.iter().enumerate() {
        let at = (plot.x + plot.w / 2.0, row + i as f64 * (LABEL + 2.5));
        text(out, at, LABEL, INK, MIDDLE, line);
    }
    for (i, line) in axes.y_label.iter().enumerate() {
        let at = (
            axes.y_label_x + i as f64 * (LABEL + 2.5),
            plot.y + plot.h / 2.0,
        );
        let turned = format!("{MIDDLE} transform=\"rotate(-90 {} {})\"", n(at.0), n(at.1));
        text(out, at, LABEL, INK, &turned, line);
    }
}

/// Draws the operating points; tells whether there was one to draw.
fn draw_marks(out: &mut String, placed: &Placed<'_>) -> bool {
    let frame = placed.axes.frame();
    let mut any = false;
    for mark in &placed.panel.marks {
        let spot = frame
            .spot((mark.x, mark.y))
            .filter(|s| placed.axes.plot.grown(0.01).has(*s));
        let Some((x, y)) = spot else { continue };
        any = true;
        let (x, y, r) = (n(x), n(y), n(labels::RING - 0.7));
        let _ = writeln!(
            out,
            "<g><circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"#ffffff\" stroke=\"{INK}\" \
             stroke-width=\"1.3\"/>\
             <circle cx=\"{x}\" cy=\"{y}\" r=\"2.2\" fill=\"{INK}\"/></g>"
        );
    }
    any
}

fn draw_label(out: &mut String, label: &Label, pen: &Pen<'_>) {
    let colour = label
        .colour
        .map_or_else(|| INK.to_owned(), |number| pen.hex(number));
    if let Some((a, b)) = label.leader {
        let mut path = String::new();
        through(&mut path, &[a, b]);
        let _ = writeln!(
            out,
            "<path d=\"{path}\" stroke=\"{colour}\" stroke-width=\"0.7\" fill=\"none\"/>"
        );
    }
    // A white outline below keeps the text readable over a line.
    let halo =
        " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" aria-hidden=\"true\"";
    text(out, label.at, labels::SIZE, "#ffffff", halo, &label.text);
    text(out, label.at, labels::SIZE, &colour, "", &label.text);
}

fn draw_legend(out: &mut String, legend: &Legend, pen: &Pen<'_>) {
    out.push_str("<g>\n");
    for (x, y, entry) in &legend.entries {
        let run = match entry.style {
            Style::Points => vec![(x + legend::SAMPLE / 2.0, *y)],
            _ => vec![(*x, *y), (x + legend::SAMPLE, *y)],
        };
        draw_series(out, &[run], entry.style, &pen.brush(entry.colour));
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
