//! Curves, shapes and strands of a finite-element test.

use super::{
    caption,
    curves::{axes, label},
    some_of,
};
use crate::{MuscleSummary, Simulated, Units, percent};
use mckibben::curve::Test;
use mckibben_fem::results::{Solution, StrandState};
use mckibben_report::{Axis, Figure, Palette, Panel, Series};

/// Shapes are drawn of so many points at most.
const SHAPES: usize = 6;

/// Four panels: the curve, the shape of half the muscle, strand tension and strand angle along it.
pub fn simulate(m: &MuscleSummary, test: Test, points: &[Simulated], u: &Units) -> Figure {
    let title = format!("{} test, finite elements", capital(test.name()));
    let mut figure = Figure::new(title).palette(Palette::Sequential);
    let (x, y) = axes(test, u);
    let mut curve = Panel::new(x, y);
    let mut fixed: Vec<f64> = points.iter().map(|q| key(test, q)).collect();
    fixed.dedup();
    let mut longest = 0;
    for (i, &value) in fixed.iter().enumerate() {
        let line: Vec<(f64, f64)> = points
            .iter()
            .filter(|q| key(test, q) == value)
            .map(|q| coordinates(test, q, u))
            .collect();
        let known = line.iter().filter(|(x, y)| x.is_finite() && y.is_finite());
        longest = longest.max(known.count());
        curve = curve.series(
            Series::line("", line)
                .colour(i)
                .neutral()
                .end_label(label(test, value, u)),
        );
    }
    let solved: Vec<(&Simulated, &Solution)> = points
        .iter()
        .filter_map(|q| Some((q, q.solution.as_ref().ok()?)))
        .collect();
    let step = solved.len().div_ceil(SHAPES).max(1);
    // The last always belongs to them.
    let shown: Vec<(&Simulated, &Solution)> =
        solved.iter().rev().step_by(step).rev().copied().collect();
    let name = |s: &Solution| {
        format!(
            "{}, {}",
            u.pressure.show(s.response.pressure_mpa),
            percent(s.response.contraction)
        )
    };
    let at = |z, r| (u.length.value(z), u.length.value(r));
    let mut shape = Panel::new(
        Axis::new(u.length.heading("z from the middle")).from_zero(),
        Axis::new(u.length.heading("r")).from_zero(),
    );
    let per_width = u.stiffness();
    let mut tension = Panel::new(
        Axis::new(u.length.heading("z at rest")).from_zero(),
        Axis::new(per_width.heading("tension of a family")).from_zero(),
    );
    let mut angle = Panel::new(
        Axis::new(u.length.heading("z at rest")).from_zero(),
        Axis::new("strand angle θ [°]"),
    );
    for (i, (q, s)) in shown.iter().enumerate() {
        curve = curve.series(Series::scatter("", [coordinates(test, q, u)]).colour(i));
        let outer = s.profile.iter().map(|x| at(x.outer_z_mm, x.outer_r_mm));
        let inner = s.profile.iter().map(|x| at(x.inner_z_mm, x.inner_r_mm));
        shape = shape
            .series(Series::line(name(s), outer).colour(i))
            .series(Series::line("", inner).colour(i));
        let along = |of: &dyn Fn(&StrandState) -> f64| {
            let line = s.strands.iter().map(|x| (u.length.value(x.rest_mm), of(x)));
            Series::line(name(s), line).colour(i)
        };
        tension = tension.series(along(&|x| per_width.value(x.tension_n_per_mm)));
        angle = angle.series(along(&|x| x.angle_deg));
    }
    // A curve of one point is none.
    if longest > 1 {
        figure = figure.panel(curve.title("curve"));
    }
    figure = figure
        .panel(shape.title("outer and inner surface"))
        .panel(tension.title("strand tension"));
    let some = some_of(shown.len(), solved.len(), "shapes");
    let caption = caption(format!("Axisymmetric finite elements{some}. {}", m.line(u)));
    figure.panel(angle.title("strand angle")).caption(caption)
}

fn capital(word: &str) -> String {
    let mut letters = word.chars();
    letters
        .next()
        .map_or_else(String::new, |c| c.to_uppercase().chain(letters).collect())
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
