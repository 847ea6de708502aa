//! The paper's Figures 5 to 12, from the tables of its method.

use super::{caption, contraction};
use crate::{NamedFigure, fit::is_of_the_paper, words::number};
use mckibben_campaign::fit::{
    FittedFormula,
    data::{distinct, same},
    paper_method::{CurveFit, LineFit, PaperMethod},
};
use mckibben_core::{
    extremes::{ends, even, peak},
    formula::Formula,
};
use mckibben_report::{Axis, Figure, Panel, Series, Style};

fn pull() -> Axis {
    Axis::new("pull F [N]")
}

/// Points of a function between two ends.
fn line(low: f64, high: f64, of: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    even((low, high), 40).map(|x| (x, of(x))).collect()
}

/// Points and the curve fitted to them.
fn pair(
    mut panel: Panel,
    label: &str,
    n: usize,
    points: Vec<(f64, f64)>,
    of: impl Fn(f64) -> f64,
) -> Panel {
    let (low, high) = ends(points.iter().map(|p| p.0));
    panel = panel.series(Series::scatter("", points).colour(n));
    panel.series(
        Series::line("", line(low, high, of))
            .colour(n)
            .style(Style::Line)
            .end_label(label),
    )
}

/// The diameter and wall in mm that figures of one muscle show, where it is fitted: the
/// prototype's.
const SHOWN: (f64, f64) = (30.0, 3.0);

/// Figures 5 to 11 where the paper's method was used, and 12, with names for their files; of the
/// prototype, or the first muscle.
pub fn fitted(f: &FittedFormula) -> Vec<NamedFigure> {
    let fitted = &f.points[..f.formula.provenance.points];
    let mut sections = fitted.iter().map(|p| (p.outer_diameter_mm, p.wall_mm));
    let first = sections.clone().next().unwrap_or(SHOWN);
    let at = if sections.any(|at| at == SHOWN) {
        SHOWN
    } else {
        first
    };
    let last = ("figure_12_formula_and_points", against_points(f, at.0));
    f.paper
        .iter()
        .flat_map(|m| paper_figures(m, at))
        .chain([last])
        .map(|(name, figure)| NamedFigure {
            name: name.into(),
            figure,
        })
        .collect()
}

/// Figures 5 to 11.
fn paper_figures(method: &PaperMethod, (d, s): (f64, f64)) -> Vec<(&'static str, Figure)> {
    let section = Section { method, d, s };
    let over_diameter = |k| section.coefficients_over_diameter(k);
    vec![
        ("figure_5_isobaric_curves", section.isobaric_curves()),
        ("figure_6_isobaric_surfaces", section.isobaric_surfaces()),
        ("figure_7_abc_over_pressure", section.abc_over_pressure()),
        ("figure_8_slopes_over_wall", section.slopes_over_wall()),
        ("figure_9_a_over_diameter", over_diameter(0)),
        ("figure_10_b_over_diameter", over_diameter(1)),
        ("figure_11_c_over_diameter", over_diameter(2)),
    ]
}

/// The coefficients of the paper's quadratics.
const LETTERS: [&str; 3] = ["a", "b", "c"];

/// The diameter and wall in mm that the figures of a fit by the paper's method show.
struct Section<'a> {
    method: &'a PaperMethod,
    d: f64,
    s: f64,
}

impl Section<'_> {
    fn figure(&self, title: String, text: &str) -> Figure {
        Figure::new(title)
            .caption(caption(format!(
                "{text}. The paper: {}",
                mckibben_core::PAPER
            )))
            .sequential()
    }

    /// Points and quadratics of some curves.
    fn curve_panel(
        &self,
        title: String,
        drawn: impl Fn(&CurveFit) -> bool,
        label: impl Fn(&CurveFit) -> String,
    ) -> Panel {
        let mut panel = Panel::new(contraction(), pull()).title(title);
        let curves = self.method.curves.iter().filter(|c| drawn(c));
        for (n, c) in curves.enumerate() {
            panel = pair(panel, &label(c), n, c.points.clone(), |e| c.abc.at(e));
        }
        panel
    }

    fn isobaric_curves(&self) -> Figure {
        let d = self.d;
        let s = self.s;
        self.figure(
            format!(
                "Isobaric curves, D0 {} mm, s {} mm",
                number(d, 4),
                number(s, 3)
            ),
            "Points and quadratics (5)",
        )
        .panel(self.curve_panel(
            String::new(),
            |c| same(c.outer_diameter_mm, d) && same(c.wall_mm, s),
            |c| format!("{} MPa", number(c.pressure_mpa, 3)),
        ))
    }

    /// At the highest pressure.
    fn isobaric_surfaces(&self) -> Figure {
        let d = self.d;
        let s = self.s;
        let top = distinct(self.method.curves.iter().map(|c| c.pressure_mpa))
            .last()
            .copied()
            .unwrap_or(0.0);
        let over_wall = self.curve_panel(
            format!("over ε and s, D0 {} mm", number(d, 4)),
            |c| same(c.outer_diameter_mm, d) && same(c.pressure_mpa, top),
            |c| format!("s {} mm", number(c.wall_mm, 3)),
        );
        let over_diameter = self.curve_panel(
            format!("over ε and D0, s {} mm", number(s, 3)),
            |c| same(c.wall_mm, s) && same(c.pressure_mpa, top),
            |c| format!("D0 {} mm", number(c.outer_diameter_mm, 4)),
        );
        self.figure(
            format!("Isobaric surfaces at {} MPa", number(top, 3)),
            "Each surface as its family of curves: points and quadratics (5). Below, each curve \
             stands further right and up than the one before it",
        )
        .columns(2)
        .panel(over_wall.clone())
        .panel(over_diameter.clone())
        .panel(in_space(over_wall))
        .panel(in_space(over_diameter))
    }

    /// The lines over pressure, for each wall of the diameter.
    fn lines(&self) -> impl Iterator<Item = &LineFit> {
        self.method
            .lines
            .iter()
            .filter(|l| same(l.outer_diameter_mm, self.d))
    }

    fn abc_over_pressure(&self) -> Figure {
        let mut figure = self
            .figure(
                format!("a, b and c over pressure, D0 {} mm", number(self.d, 4)),
                "Points and lines (8)",
            )
            .columns(3);
        for (k, letter) in LETTERS.into_iter().enumerate() {
            let mut panel = Panel::new(
                Axis::new("pressure P [MPa]").from_zero(),
                Axis::new(format!("{letter} [N]")),
            );
            for (n, l) in self.lines().enumerate() {
                let points = self
                    .method
                    .curves
                    .iter()
                    .filter(|c| same(c.outer_diameter_mm, self.d) && same(c.wall_mm, l.wall_mm))
                    .map(|c| (c.pressure_mpa, c.abc.coefficients[k]))
                    .collect();
                panel = pair(
                    panel,
                    &format!("s {}", number(l.wall_mm, 3)),
                    n,
                    points,
                    |p| l.lines[k].at(p),
                );
            }
            figure = figure.panel(panel);
        }
        figure
    }

    fn slopes_over_wall(&self) -> Figure {
        let mut figure = self
            .figure(
                format!(
                    "Slopes m and intercepts q over s, D0 {} mm",
                    number(self.d, 4)
                ),
                "Points and parabolas (9)",
            )
            .columns(3);
        let of_diameter = self
            .method
            .walls
            .iter()
            .find(|w| same(w.outer_diameter_mm, self.d));
        for (j, symbol, unit) in [(0, "m", "mm²"), (1, "q", "N")] {
            for (k, letter) in LETTERS.into_iter().enumerate() {
                let y = Axis::new(format!("{symbol}_{letter} [{unit}]"));
                let mut panel = Panel::new(Axis::new("wall s [mm]").from_zero(), y);
                if let Some(w) = of_diameter {
                    let points = self
                        .lines()
                        .map(|l| (l.wall_mm, l.lines[k].coefficients[j]))
                        .collect();
                    panel = pair(panel, "", 0, points, |s| w.parabolas[k][j].at(s));
                }
                figure = figure.panel(panel);
            }
        }
        figure
    }

    /// Of the k-th letter.
    fn coefficients_over_diameter(&self, k: usize) -> Figure {
        let PaperMethod {
            coefficients,
            walls,
            r2,
            ..
        } = self.method;
        let letter = LETTERS[k];
        let text = if k < 2 {
            "Points and parabolas (11)"
        } else {
            "Points and straight lines (11)"
        };
        let mut figure = self
            .figure(format!("{letter}1 to {letter}6 over D0"), text)
            .columns(3);
        let rows = [&coefficients.a, &coefficients.b, &coefficients.c][k];
        for (row, x) in rows.iter().enumerate() {
            let y = Axis::new(format!("{letter}{}", row + 1));
            let points = walls.iter().map(|w| (w.outer_diameter_mm, w.x(k)[row]));
            figure = figure.panel(pair(
                Panel::new(Axis::new("outer diameter D0 [mm]"), y)
                    .title(format!("R² {:.4}", r2[k][row])),
                "",
                0,
                points.collect(),
                |d| (x[0] * d + x[1]) * d + x[2],
            ));
        }
        figure
    }
}

/// A family of curves in space: each stands further back than the one before, and lines join their
/// points to a surface. The axes are those of the front curve.
fn in_space(mut panel: Panel) -> Panel {
    let top = peak(panel.series.iter().flat_map(|s| &s.points).map(|p| p.1));
    panel.title += ", in space";
    panel.x.label = "ε of the front curve [–]".into();
    panel.y.label = "F of the front curve [N]".into();
    let last = panel.series.last().and_then(|s| s.colour);
    for series in &mut panel.series {
        if ![Some(0), last].contains(&series.colour) {
            series.end_label.clear();
        }
        let back = series.colour.unwrap_or_default() as f64;
        for (x, y) in &mut series.points {
            *x += 0.02 * back;
            *y += 0.1 * top * back;
        }
    }
    let dots = Vec::from_iter(panel.series.iter().step_by(2).cloned());
    for i in 0..dots.first().map_or(0, |s| s.points.len()) {
        let line = dots.iter().filter_map(|s| s.points.get(i).copied());
        panel.series.push(Series::line("", line).colour(0));
    }
    panel
}

/// The largest errors of a formula, by (12) and in N; of points held out where there are some.
fn largest(f: &Formula) -> String {
    let errors = f
        .errors
        .held_out
        .as_ref()
        .map_or(f.errors.fit, |h| h.errors);
    let share = number(100.0 * errors.max_12, 3);
    let force = number(errors.max_n, 3);
    format!("; {}: {share} %, {force} N", f.name)
}

/// Figure 12: the formula against the points, of the diameter held out where there is one; of the
/// paper's muscles with the published formula.
fn against_points(f: &FittedFormula, d: f64) -> Figure {
    let FittedFormula {
        formula, points, ..
    } = f;
    let published = is_of_the_paper(formula).then(|| f.published());
    let held = formula
        .errors
        .held_out
        .as_ref()
        .and_then(|h| h.outer_diameters_mm.first().copied());
    let d = held.unwrap_or(d);
    let of_d = || points.iter().filter(|p| same(p.outer_diameter_mm, d));
    let dots = if held.is_some() {
        "table, held out of the fit"
    } else {
        "table"
    };
    let method = &formula.provenance.method;
    let formulas = Vec::from_iter([formula].into_iter().chain(&published));
    let errors: String = formulas.iter().map(|f| largest(f)).collect();
    let mut figure = Figure::new(format!(
        "Formula {} and points, D0 {} mm",
        formula.name,
        number(d, 4)
    ))
    .caption(caption(format!(
        "Largest error by (12) and in N, where the table pulls{errors}. Method: {method}"
    )))
    .sequential()
    .columns(2);
    let pressures = distinct(of_d().map(|p| p.pressure_mpa));
    let shown = Vec::from_iter(
        pressures
            .iter()
            .rev()
            .step_by(pressures.len().div_ceil(5).max(1))
            .copied(),
    );
    for s in distinct(of_d().map(|p| p.wall_mm)).into_iter().take(6) {
        let mut panel = Panel::new(contraction(), pull()).title(format!("s {} mm", number(s, 3)));
        for (n, &p) in shown.iter().rev().enumerate() {
            let points = Vec::from_iter(
                of_d()
                    .filter(|q| same(q.wall_mm, s) && same(q.pressure_mpa, p))
                    .map(|q| (q.contraction, q.force_n)),
            );
            if !points.is_empty() {
                panel = pair(panel, &format!("{} MPa", number(p, 3)), n, points, |e| {
                    formula.force_n(d, s, p, e)
                });
                if let Some(published) = &published {
                    let series = Series::new("", line(0.0, 0.2, |e| published.force_n(d, s, p, e)))
                        .colour(n);
                    panel = panel.series(series.style(Style::Dashed));
                }
            }
        }
        // The first curve stands for all in the legend.
        let names = [dots].into_iter().chain(formulas.iter().map(|f| &*f.name));
        for (series, name) in panel.series.iter_mut().zip(names) {
            series.label = name.into();
        }
        figure = figure.panel(panel);
    }
    figure
}
