//! The numbers of a figure as a table.

use crate::ticks::number;
use crate::xml::escape;
use crate::{Figure, Panel, Result, Style};
use mckibben_io::clean::cell;
use std::fmt::Write as _;

impl Figure {
    /// Every point that is drawn, as CSV: the panel (from 1, with its title), the series by the text that names it in the figure, how it is
    /// drawn, both axes with their units, and both numbers with all digits. A band is its outline. A gap in a line is a row without numbers.
    ///
    /// ```
    /// use mckibben_report::{Axis, Figure, Panel, Series};
    /// let panel = Panel::new(Axis::new("ε [–]"), Axis::new("F [N]")).series(Series::line("0.3 MPa", vec![(0.1, 190.0)]));
    /// let table = Figure::new("Pull").panel(panel).to_csv();
    /// assert_eq!(table.lines().nth(1), Some("1,0.3 MPa,line,ε [–],F [N],0.1,190"));
    /// ```
    pub fn to_csv(&self) -> String {
        let mut out = String::from("panel,series,style,x_axis,y_axis,x,y\n");
        for (i, panel) in self.panels.iter().enumerate() {
            let title = Some(panel.title.as_str()).filter(|title| !title.is_empty());
            let place = title.map_or_else(|| (i + 1).to_string(), |title| format!("{} {title}", i + 1));
            let mut row = |name: &str, style: &str, (x, y): (f64, f64)| {
                let words = [&place, name, style, &panel.x.label, &panel.y.label].map(quoted).join(",");
                let number = |v: f64| if v.is_finite() { v.to_string() } else { String::new() };
                // Writing to a string does not fail.
                let _ = writeln!(out, "{words},{},{}", number(x), number(y));
            };
            for series in &panel.series {
                let name = if series.label.is_empty() { &series.end_label } else { &series.label };
                series.points.iter().for_each(|point| row(name, series.style.name(), *point));
            }
            panel.marks.iter().for_each(|mark| row(&mark.label, "mark", (mark.x, mark.y)));
        }
        out
    }
}

impl Style {
    fn name(self) -> &'static str {
        match self {
            Self::Auto | Self::Line => "line",
            Self::Dashed => "dashed",
            Self::Dotted => "dotted",
            Self::DashDot => "dash-dot",
            Self::Points => "points",
            Self::Band => "band",
        }
    }
}

fn quoted(text: &str) -> String {
    let text = cell(text);
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into_owned()
    }
}

const STYLE: &str = "body{margin:1rem auto;max-width:75rem;font-family:DejaVu Sans,Helvetica,Arial,sans-serif}\
svg{width:100%;height:auto}table{border-collapse:collapse}th,td{padding:0 1em;text-align:right}";

impl Figure {
    /// The figure as a self-contained HTML page that needs no network and no script: the SVG, and the points of each
    /// panel as a table with six significant digits.
    pub fn to_html(&self) -> Result<String> {
        let title = if self.title.trim().is_empty() { "Figure" } else { self.title.trim() };
        let mut out = format!(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
             <title>{}</title><style>{STYLE}</style></head>\n<body>\n{}",
            escape(title),
            self.to_svg()?,
        );
        for panel in &self.panels {
            table(&mut out, panel);
        }
        out.push_str("</body></html>\n");
        Ok(out)
    }
}

fn table(out: &mut String, panel: &Panel) {
    let head = ["Data", panel.title.trim()].join(" ");
    let (x, y) = (escape(&panel.x.label), escape(&panel.y.label));
    let _ = writeln!(
        out,
        "<details><summary>{}</summary><table>\n<tr><th></th><th>{x}</th><th>{y}</th></tr>",
        escape(head.trim())
    );
    for series in &panel.series {
        let name = [series.label.trim(), series.end_label.trim()].join(" ");
        series.points.iter().for_each(|point| row(out, name.trim(), *point));
    }
    panel.marks.iter().for_each(|mark| row(out, mark.label.trim(), (mark.x, mark.y)));
    out.push_str("</table></details>\n");
}

fn row(out: &mut String, name: &str, (x, y): (f64, f64)) {
    if x.is_finite() && y.is_finite() {
        let _ =
            writeln!(out, "<tr><th>{}</th><td>{}</td><td>{}</td></tr>", escape(name), number(x), number(y));
    }
}
