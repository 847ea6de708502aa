//! The numbers of a figure as a table.

use crate::{
    document::head,
    figure::{Figure, Panel, Result},
    ticks::number,
};
use mckibben_units::clean::markup;
use std::fmt::Write as _;

const STYLE: &str = "body{margin:1rem auto;max-width:75rem;font-family:DejaVu \
    Sans,Helvetica,Arial,sans-serif}\
svg{width:100%;height:auto}table{border-collapse:collapse}th,td{padding:0 1em;text-align:right}";

impl Figure {
    /// The figure as a self-contained HTML page that needs no network and no script: the SVG, and
    /// the points of each panel as a table with six significant digits.
    pub fn to_html(&self) -> Result<String> {
        let title = if self.title.trim().is_empty() {
            "Figure"
        } else {
            self.title.trim()
        };
        let mut out = head(title, STYLE, "", "") + &self.to_svg()?;
        for panel in &self.panels {
            table(&mut out, panel);
        }
        out.push_str("</body></html>\n");
        Ok(out)
    }
}

fn table(out: &mut String, panel: &Panel) {
    let head = ["Data", panel.title.trim()].join(" ");
    let x = markup(&panel.x.label);
    let y = markup(&panel.y.label);
    let _ = writeln!(
        out,
        "<details><summary>{}</summary><table>\n<tr><th></th><th>{x}</th><th>{y}</th></tr>",
        markup(head.trim())
    );
    for series in &panel.series {
        let name = [series.label.trim(), series.end_label.trim()].join(" ");
        series
            .points
            .iter()
            .for_each(|point| row(out, name.trim(), *point));
    }
    panel
        .marks
        .iter()
        .for_each(|mark| row(out, mark.label.trim(), (mark.x, mark.y)));
    out.push_str("</table></details>\n");
}

fn row(out: &mut String, name: &str, (x, y): (f64, f64)) {
    if x.is_finite() && y.is_finite() {
        let _ = writeln!(
            out,
            "<tr><th>{}</th><td>{}</td><td>{}</td></tr>",
            markup(name),
            number(x),
            number(y)
        );
    }
}
