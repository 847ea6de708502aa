//! Curves, shapes and strands of a finite-element test.

use super::{
    caption,
    curves::{axes, label},
    some_of,
};
use crate::{MuscleSummary, Simulated, Units, percent};
use mckibben_core::curve::Test;
use mckibben_fem::results::{ProfilePoint, Solution, StrandState};
use mckibben_report::{Axis, Figure, Panel, Series};

/// Shapes are drawn of so many points at most.
const SHAPES: usize = 6;

/// Four panels: the curve, the shape of half the muscle, strand tension and strand angle along it.
pub fn simulate(m: &MuscleSummary, test: Test, points: &[Simulated], u: &Units) -> Figure {
    let mut figure = Figure::new(format!("Finite elements: {test} test")).sequential();
    let (x, y) = axes(test, u);
    let mut curve = Panel::new(x, y);
    let mut fixed = Vec::from_iter(points.iter().map(|q| key(test, q)));
    fixed.dedup();
    let mut longest = 0;
    for (i, &value) in fixed.iter().enumerate() {
        let line = Vec::from_iter(
            points
                .iter()
                .filter(|q| key(test, q) == value)
                .map(|q| coordinates(test, q, u)),
        );
        longest = longest.max(
            line.iter()
                .filter(|(x, y)| x.is_finite() && y.is_finite())
                .count(),
        );
        curve = curve.series(
            Series::line("", line)
                .colour(i)
                .neutral()
                .end_label(label(test, value, u)),
        );
    }
    let solved = Vec::from_iter(
        points
            .iter()
            .filter_map(|q| Some((q, q.solution.as_ref().ok()?))),
    );
    let step = solved.len().div_ceil(SHAPES).max(1);
    // The last always belongs to them.
    let shown = Vec::from_iter(solved.iter().rev().step_by(step).rev().copied());
    for (i, (q, _)) in shown.iter().enumerate() {
        curve = curve.series(Series::scatter("", vec![coordinates(test, q, u)]).colour(i));
    }
    // A curve of one point is none.
    if longest > 1 {
        figure = figure.panel(curve.title("curve"));
    }
    let some = some_of(shown.len(), solved.len(), "shapes");
    let caption = caption(format!("Finite elements{some}. {}", m.line(u)));
    figure.panels.extend(along_the_muscle(&shown, u));
    figure.caption(caption)
}

/// The shape of half the muscle, strand tension and strand angle.
fn along_the_muscle(shown: &[(&Simulated, &Solution)], u: &Units) -> [Panel; 3] {
    let mut shape = Panel::new(
        Axis::new(u.length.heading("z from the middle")).from_zero(),
        Axis::new(u.length.heading("r")).from_zero(),
    );
    let at_rest = || Axis::new(u.length.heading("z at rest")).from_zero();
    let per_width = u.stiffness();
    let mut tension = Panel::new(
        at_rest(),
        Axis::new(per_width.heading("tension of a family")).from_zero(),
    );
    let mut angle = Panel::new(at_rest(), Axis::new("strand angle θ [°]"));
    for (i, (_, s)) in shown.iter().enumerate() {
        let name = format!(
            "{}, {}",
            u.pressure.show(s.response.pressure_mpa),
            percent(s.response.contraction)
        );
        let surface = |of: fn(&ProfilePoint) -> (f64, f64)| {
            s.profile
                .iter()
                .map(of)
                .map(|(z, r)| (u.length.value(z), u.length.value(r)))
        };
        let along = |of: &dyn Fn(&StrandState) -> f64| -> Vec<(f64, f64)> {
            s.strands
                .iter()
                .map(|x| (u.length.value(x.rest_mm), of(x)))
                .collect()
        };
        let outer = surface(|x| (x.outer_z_mm, x.outer_r_mm));
        let inner = surface(|x| (x.inner_z_mm, x.inner_r_mm));
        shape = shape
            .series(Series::line(name.clone(), outer).colour(i))
            .series(Series::line("", inner).colour(i));
        let tensions = along(&|x| per_width.value(x.tension_n_per_mm));
        tension = tension.series(Series::line(name.clone(), tensions).colour(i));
        angle = angle.series(Series::line(name, along(&|x| x.angle_deg)).colour(i));
    }
    [
        shape.title("outer and inner surface"),
        tension.title("strand tension"),
        angle.title("strand angle"),
    ]
}

/// What is fixed along the curve of a point.
fn key(test: Test, q: &Simulated) -> f64 {
    match test {
        Test::Isometric => q.requested.contraction.unwrap_or(f64::NAN),
        Test::Isotonic => q.requested.force_n.unwrap_or(f64::NAN),
        Test::Isobaric => q.requested.pressure_mpa,
    }
}

fn coordinates(test: Test, q: &Simulated, u: &Units) -> (f64, f64) {
    let r = q.solution.as_ref().ok().map(|s| s.response);
    let pull = r
        .filter(|_| !q.slack)
        .map_or(f64::NAN, |r| u.force.value(r.force_n));
    match test {
        Test::Isometric => (u.pressure.value(q.requested.pressure_mpa), pull),
        Test::Isotonic => (
            u.pressure.value(q.requested.pressure_mpa),
            r.map_or(f64::NAN, |r| r.contraction),
        ),
        Test::Isobaric => (q.requested.contraction.unwrap_or(f64::NAN), pull),
    }
}
