//! The figure as a page: drawing, read-out under the pointer, table of the data.

use std::fmt::Write as _;

use crate::font::Metrics;
use crate::layout::{self, Page, Placed};
use crate::ticks::number;
use crate::xml::{escape, length};
use crate::{Figure, FigureError, Series, palette, svg};

/// Points of a series that go into the page; longer series are thinned evenly.
const MOST: usize = 600;

impl Figure {
    /// The figure as a self-contained HTML page that needs no network: the SVG, a read-out
    /// of the nearest point, and a table of the data.
    ///
    /// Values carry six significant digits; of a series with more than 600 points the page
    /// holds every n-th.
    ///
    /// # Errors
    /// Those of [`Figure::to_svg`].
    pub fn to_html(&self) -> Result<String, FigureError> {
        let metrics = Metrics::new()?;
        let page = layout::page(self, &metrics)?;
        let title = if self.title.trim().is_empty() { "Figure" } else { self.title.trim() };
        let mut out = String::new();
        let _ = write!(
            out,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; \
             style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n\
             <title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n\
             <div class=\"paper\" style=\"max-width:{}px\">\n",
            escape(title),
            include_str!("page.css"),
            length(page.width * 1.7),
        );
        out.push_str(&svg::draw(self, &page));
        out.push_str("</div>\n<p id=\"readout\" role=\"status\" aria-live=\"polite\">Point at the figure to read values.</p>\n");
        for (i, placed) in page.panels.iter().enumerate() {
            table(&mut out, placed, i, page.panels.len());
        }
        let _ = write!(
            out,
            "</main>\n<script type=\"application/json\" id=\"data\">{}</script>\n<script>\n{}</script>\n</body>\n</html>\n",
            data(self, &page),
            include_str!("page.js"),
        );
        Ok(out)
    }
}

/// The points of a series that go into the page, and whether some were left out.
fn sample(series: &Series) -> (Vec<(f64, f64)>, bool) {
    let finite: Vec<_> =
        series.points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
    let step = finite.len().div_ceil(MOST).max(1);
    let kept = finite.iter().copied().step_by(step).collect();
    (kept, step > 1)
}

/// What a series is called in read-out and table.
fn name(series: &Series, index: usize) -> String {
    match (series.label.trim(), series.end_label.trim()) {
        ("", "") => format!("series {}", index + 1),
        (label, "") => label.to_owned(),
        ("", end) => end.to_owned(),
        (label, end) => format!("{label}, {end}"),
    }
}

fn table(out: &mut String, placed: &Placed<'_>, index: usize, count: usize) {
    let panel = placed.panel;
    let mut heading = "Data".to_owned();
    if count > 1 {
        let _ = write!(heading, " of panel {}", index + 1);
    }
    if !panel.title.trim().is_empty() {
        let _ = write!(heading, ": {}", panel.title.trim());
    }
    let or = |text: &str, other: &str| escape(if text.trim().is_empty() { other } else { text });
    let _ = write!(
        out,
        "<details>\n<summary>{}</summary>\n<div class=\"scroll\"><table>\n<thead><tr>\
         <th scope=\"col\">series</th><th scope=\"col\">{}</th><th scope=\"col\">{}</th></tr></thead>\n",
        escape(&heading),
        or(&panel.x.label, "x"),
        or(&panel.y.label, "y"),
    );
    let mut thinned = false;
    for (i, series) in panel.series.iter().enumerate() {
        let (points, some_left_out) = sample(series);
        thinned |= some_left_out;
        rows(out, &name(series, i), &points);
    }
    for mark in panel.marks.iter().filter(|m| m.x.is_finite() && m.y.is_finite()) {
        let label = if mark.label.trim().is_empty() { "marked point" } else { mark.label.trim() };
        rows(out, label, &[(mark.x, mark.y)]);
    }
    out.push_str("</table></div>\n");
    if thinned {
        out.push_str("<p class=\"note\">Long series are thinned evenly here.</p>\n");
    }
    out.push_str("</details>\n");
}

fn rows(out: &mut String, name: &str, points: &[(f64, f64)]) {
    let name = escape(name);
    out.push_str("<tbody>\n");
    for (x, y) in points {
        let _ = writeln!(
            out,
            "<tr><th scope=\"row\">{name}</th><td>{}</td><td>{}</td></tr>",
            number(*x),
            number(*y)
        );
    }
    out.push_str("</tbody>\n");
}

/// The data of the read-out, as JSON.
fn data(figure: &Figure, page: &Page<'_>) -> String {
    let colours = layout::colour_count(figure);
    let mut panels = Vec::new();
    for placed in &page.panels {
        let (plot, axes, panel) = (placed.axes.plot, &placed.axes, placed.panel);
        let mut series: Vec<String> = Vec::new();
        for (i, s) in panel.series.iter().enumerate() {
            let colour = palette::hex(figure.palette, s.colour.unwrap_or(i), colours);
            series.push(one_series(&name(s, i), &colour, &sample(s).0));
        }
        for mark in panel.marks.iter().filter(|m| m.x.is_finite() && m.y.is_finite()) {
            let label = if mark.label.trim().is_empty() { "marked point" } else { mark.label.trim() };
            series.push(one_series(label, "#222222", &[(mark.x, mark.y)]));
        }
        panels.push(format!(
            "{{\"plot\":[{},{},{},{}],\"x\":[{:e},{:e}],\"y\":[{:e},{:e}],\"xl\":{},\"yl\":{},\"series\":[{}]}}",
            length(plot.x),
            length(plot.y),
            length(plot.w),
            length(plot.h),
            axes.x.low,
            axes.x.high,
            axes.y.low,
            axes.y.high,
            json_text(&panel.x.label),
            json_text(&panel.y.label),
            series.join(",")
        ));
    }
    format!("[{}]", panels.join(","))
}

fn one_series(name: &str, colour: &str, points: &[(f64, f64)]) -> String {
    let points: Vec<String> =
        points.iter().map(|(x, y)| format!("[{},{}]", number(*x), number(*y))).collect();
    format!("{{\"name\":{},\"colour\":\"{colour}\",\"points\":[{}]}}", json_text(name), points.join(","))
}

/// A JSON string that cannot end the script element it stands in.
fn json_text(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => {
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
