//! The paper's Figure 4.

use super::caption;
use super::curves::{axes, line};
use crate::units::Units;
use mckibben::curve::Test;
use mckibben::study::Study;
use mckibben_report::{Figure, Panel, Series, Style};

/// Six panels: isometric above, isotonic below.
pub fn study(study: &Study, about: &str, u: &Units) -> Figure {
    let mut figure = Figure::new("Thickness of the tube (the paper's Figure 4)").columns(3);
    for panel in &study.panels {
        let (x, y) = axes(panel.test, u);
        let title = match panel.test {
            Test::Isometric => format!("isometric, ΔL = {}", u.length.show(panel.fixed)),
            _ => format!("isotonic, F = {}", u.force.show(panel.fixed)),
        };
        let mut drawn = Panel::new(x, y).title(title);
        for (number, curve) in panel.curves.iter().enumerate() {
            let style = match (curve.wall_mm, number % 2) {
                (Some(_), _) => Style::Line,
                (None, 0) => Style::Dotted,
                (None, _) => Style::Dashed,
            };
            // (1) and (4) are one formula: one legend entry for both.
            let label = curve.label.replace("(1)", "ideal").replace("(4)", "ideal");
            drawn = drawn
                .series(Series::new(label, line(&curve.curve, panel.test, u)).colour(number).style(style));
        }
        figure = figure.panel(drawn);
    }
    figure.caption(caption(format!("Model {}. {about}. The paper: {}", study.model, mckibben::PAPER)))
}
