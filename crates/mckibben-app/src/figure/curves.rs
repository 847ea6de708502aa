//! A family of curves of one test.

use super::caption;
use crate::muscle::MuscleSummary;
use crate::units::Units;
use crate::words::percent;
use mckibben::curve::{Curve, Test};
use mckibben_report::{Axis, Figure, Palette, Panel, Series, Style};

/// The axes of a test.
pub(super) fn axes(test: Test, u: &Units) -> (Axis, Axis) {
    let pressure = Axis::new(u.pressure.heading("pressure P")).from_zero();
    let pull = pull(u);
    let contraction = Axis::new("contraction ratio ε [–]").from_zero();
    match test {
        Test::Isometric => (pressure, pull),
        Test::Isotonic => (pressure, contraction),
        Test::Isobaric => (contraction, pull),
    }
}

/// The axis of a pull.
pub(super) fn pull(u: &Units) -> Axis {
    Axis::new(u.force.heading("pull F")).from_zero()
}

/// The points of a curve in the figure's units.
pub(super) fn line(curve: &Curve, test: Test, u: &Units) -> Vec<(f64, f64)> {
    let points = curve.line(test).into_iter();
    let shown = |(x, y)| match test {
        Test::Isobaric => (x, u.force.value(y)),
        Test::Isometric => (u.pressure.value(x), u.force.value(y)),
        Test::Isotonic => (u.pressure.value(x), y),
    };
    points.map(shown).collect()
}

/// What is fixed along a curve, as its label.
pub(super) fn label(test: Test, fixed: f64, u: &Units) -> String {
    match test {
        Test::Isometric => format!("ε {}", percent(fixed)),
        Test::Isotonic => u.force.show(fixed),
        Test::Isobaric => u.pressure.show(fixed),
    }
}

/// The figure of `curve`.
pub fn curves(
    model: &str,
    muscle: &MuscleSummary,
    test: Test,
    list: &[Curve],
    both: bool,
    u: &Units,
) -> Figure {
    let (x, y) = axes(test, u);
    let mut panel = Panel::new(x, y);
    // Of two branches of one colour the muscle lengthens on the dashed one.
    let each = if both { 2 } else { 1 };
    for (i, curve) in list.iter().enumerate() {
        let text = if i % each == 0 { label(test, curve.fixed, u) } else { String::new() };
        let style = if i % each == 0 { Style::Line } else { Style::Dashed };
        let series = |name: &str| Series::new(name, line(curve, test, u)).style(style).colour(i / each);
        panel =
            panel.series(if list.len() <= 12 * each { series("").end_label(text) } else { series(&text) });
    }
    let title = match test {
        Test::Isometric => "Isometric curves",
        Test::Isotonic => "Isotonic curves",
        Test::Isobaric => "Isobaric curves",
    };
    let branches = if both { "; dashed: while it is lengthened" } else { "" };
    let about = format!("Model {model}{branches}. {}", muscle.line(u));
    Figure::new(title).caption(caption(about)).palette(Palette::Sequential).panel(panel)
}
