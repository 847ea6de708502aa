//! A family of curves of one test.

use super::caption;
use crate::muscle::MuscleSummary;
use crate::words::{PressureUnit, number, percent};
use mckibben::curve::{Curve, Test};
use mckibben_report::{Axis, Figure, Palette, Panel, Series};

/// The axes of a test.
pub(super) fn axes(test: Test, p: PressureUnit) -> (Axis, Axis) {
    let pressure = Axis::new(format!("pressure P [{}]", p.name())).from_zero();
    let pull = Axis::new("pull F [N]").from_zero();
    let contraction = Axis::new("contraction ratio ε [–]").from_zero();
    match test {
        Test::Isometric => (pressure, pull),
        Test::Isotonic => (pressure, contraction),
        Test::Isobaric => (contraction, pull),
    }
}

/// The points of a curve in the figure's units.
pub(super) fn line(curve: &Curve, test: Test, p: PressureUnit) -> Vec<(f64, f64)> {
    let points = curve.line(test).into_iter();
    points.map(|(x, y)| if test == Test::Isobaric { (x, y) } else { (p.value(x), y) }).collect()
}

/// What is fixed along a curve, as its label.
pub(super) fn label(test: Test, fixed: f64, p: PressureUnit) -> String {
    match test {
        Test::Isometric => format!("ε {}", percent(fixed)),
        Test::Isotonic => format!("{} N", number(fixed, 5)),
        Test::Isobaric => p.show(fixed),
    }
}

/// The figure of `curve`.
pub fn curves(model: &str, muscle: &MuscleSummary, test: Test, list: &[Curve], p: PressureUnit) -> Figure {
    let (x, y) = axes(test, p);
    let mut panel = Panel::new(x, y);
    for curve in list {
        let text = label(test, curve.fixed, p);
        let points = line(curve, test, p);
        panel = panel.series(if list.len() <= 12 {
            Series::line("", points).end_label(text)
        } else {
            Series::line(text, points)
        });
    }
    let title = match test {
        Test::Isometric => "Isometric curves",
        Test::Isotonic => "Isotonic curves",
        Test::Isobaric => "Isobaric curves",
    };
    let about = format!("Model {model}. {}", muscle.line());
    Figure::new(title).caption(caption(about)).palette(Palette::Sequential).panel(panel)
}
