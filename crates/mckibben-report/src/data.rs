//! A figure as a page, with its numbers as tables.

use crate::{
    document::{Document, Part},
    figure::{Figure, Panel, Result},
};
use mckibben_units::short_numbers;

impl Figure {
    /// The figure as a self-contained HTML page that needs no network and no script: the SVG, and
    /// the points of each panel as a table.
    pub fn to_html(&self) -> Result<String> {
        let mut parts = vec![Part::Figure(Box::new(self.clone()))];
        for panel in &self.panels {
            let heading = format!("Data {}", panel.title);
            parts.extend([Part::heading(heading.trim()), table(panel)]);
        }
        let page = Document {
            title: self.title.clone(),
            parts,
            ..Document::default()
        };
        page.to_html("")
    }
}

fn table(panel: &Panel) -> Part {
    let series = panel.series.iter().flat_map(|series| {
        let name = [&*series.label, &*series.end_label].join(" ");
        let points = series.points.iter();
        points.map(move |(x, y)| (name.clone(), [*x, *y]))
    });
    let marks = panel.marks.iter();
    let marks = marks.map(|mark| (mark.label.clone(), [mark.x, mark.y]));
    let all = series.chain(marks);
    let rows = all.filter(|(_, at)| at.iter().all(|v| v.is_finite()));
    let row = |(name, at): (String, [f64; 2])| {
        let [x, y] = at.map(|v| short_numbers(&v.to_string()).into_owned());
        vec![name.trim().to_owned(), x, y]
    };
    let head = ["", &panel.x.label, &panel.y.label];
    Part::table(&head, rows.map(row).collect())
}
