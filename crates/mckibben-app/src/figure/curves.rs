//! A family of curves of one test.

use super::{BAND, caption};
use crate::{CurveAnswer, LoadAnswer, Units, percent};
use mckibben::curve::{Curve, CurvePoint, Test};
use mckibben::study::Study;
use mckibben_report::{Axis, Figure, Palette, Panel, Series, Style};

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

/// The ± along a curve, where it has one; the user of a muscle that pulls need not see pushes.
pub(super) fn band(curve: &Curve, test: Test, u: &Units) -> Option<Series> {
    let edge = |q: &CurvePoint| {
        let a = q.answer.as_ref().ok().filter(|a| !a.slack)?;
        let edges = |v: f64, half: f64| ((v - half).max(v.min(0.0)), v + half);
        let (pull, pressure) = (|v| u.force.value(v), u.pressure.value(q.pressure_mpa));
        let of_pull = || Some(edges(a.response.force_n, a.uncertainty_n?));
        let (x, (low, high)) = match test {
            Test::Isobaric => (q.contraction?, of_pull()?),
            Test::Isometric => (pressure, of_pull()?),
            Test::Isotonic => {
                let (low, high) = edges(a.response.contraction, a.contraction_uncertainty?);
                return Some((pressure, low, high));
            }
        };
        Some((x, pull(low), pull(high)))
    };
    let mut edges: Vec<(f64, f64, f64)> = curve.points.iter().filter_map(edge).collect();
    // Where the line goes on to its end without a pull, the ± of its last point does.
    let drawn = line(curve, test, u);
    if let (Some(&(x, _, high)), Some(&(end, y))) = (edges.last(), drawn.iter().rfind(|p| p.1.is_finite()))
        && let Some((_, at)) = drawn.iter().find(|p| p.0 == x && end > x)
    {
        edges.push((end, (y - (high - at)).max(y.min(0.0)), y + (high - at)));
    }
    (edges.len() > 1).then(|| Series::band(&edges))
}

/// What is fixed along a curve, as its label.
pub(super) fn label(test: Test, fixed: f64, u: &Units) -> String {
    match test {
        Test::Isometric => format!("ε {}", percent(fixed)),
        Test::Isotonic => u.force.show(fixed),
        Test::Isobaric => u.pressure.show(fixed),
    }
}

/// Curves whose bands can be told apart.
pub(super) const MOST_BANDS: usize = 6;
/// Points of a load's line.
const LINE: usize = 101;

/// The line of a load over the contraction, and its equilibria: filled where they are stable.
fn load_line(loaded: &LoadAnswer, length_mm: f64, list: &[Curve], u: &Units) -> (Series, Series) {
    let asked = list.iter().flat_map(|c| &c.points).filter_map(|p| p.contraction);
    let found = loaded.at.iter().flat_map(|at| &at.equilibria);
    let end = asked.chain(found.clone().map(|e| e.answer.response.contraction)).fold(0.0, f64::max);
    let (low, high) = loaded.line.reach_mm();
    let places = (0..LINE).map(|i| end * i as f64 / (LINE - 1) as f64);
    let known = places.filter(|e| (low..=high).contains(&(e * length_mm)));
    let line: Vec<(f64, f64)> =
        known.map(|e| (e, u.force.value(loaded.line.force_n(e * length_mm)))).collect();
    let points = found.map(|e| {
        let r = &e.answer.response;
        (r.contraction, u.force.value(r.force_n))
    });
    (
        Series::new("", line).style(Style::Dashed).neutral(),
        Series::new("", points.collect::<Vec<_>>()).style(Style::Points).neutral(),
    )
}

pub fn curves(answer: &CurveAnswer, test: Test, list: &[Curve], both: bool, u: &Units) -> Figure {
    let CurveAnswer { model, muscle, loaded, .. } = answer;
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
    let bands = list.iter().enumerate().filter_map(|(i, curve)| Some(band(curve, test, u)?.colour(i / each)));
    let bands: Vec<Series> = if list.len() <= MOST_BANDS { bands.collect() } else { vec![] };
    let said = if bands.is_empty() { "" } else { BAND };
    if let Some(loaded) = loaded {
        let (line, balances) = load_line(loaded, muscle.length_mm, list, u);
        panel = panel.series(line.end_label(loaded.load.as_str())).series(balances);
    }
    panel.series.extend(bands);
    let title = match test {
        Test::Isometric => "Isometric curves",
        Test::Isotonic => "Isotonic curves",
        Test::Isobaric => "Isobaric curves",
    };
    let branches = if both { "; dashed: while it is lengthened" } else { "" };
    let about = format!("Model {model}{branches}{said}. {}", muscle.line(u));
    Figure::new(title).caption(caption(about)).palette(Palette::Sequential).panel(panel)
}
