//! A family of curves of one test.

use super::{caption, contraction, pressure, pull, said, told_apart};
use crate::{CurveAnswer, LoadAnswer, Model, Units, percent};
use mckibben_core::{
    analysis::{Evaluation, Options},
    built::Built,
    curve::{Curve, CurvePoint, Test},
    extremes::{even, peak},
    model::{ForceModel, Workspace},
    muscle::Direction,
    study::Study,
};
use mckibben_design::{Candidate, OperatingPoint};
use mckibben_fit::compare::MeasuredPoint;
use mckibben_report::{Axis, Figure, Mark, Panel, Series, Style};

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
            drawn = drawn.series(
                Series::new(
                    curve.label.replace("(1)", "ideal").replace("(4)", "ideal"),
                    line(&curve.curve, panel.test, u),
                )
                .colour(number)
                .style(style),
            );
        }
        figure = figure.panel(drawn);
    }
    figure.caption(caption(format!(
        "Model {}. {about}. Unlike in the paper, (4) is not shifted to zero pressure at ΔL = 0. \
         The paper: {}",
        study.model,
        mckibben_core::PAPER
    )))
}

pub fn axes(test: Test, u: &Units) -> (Axis, Axis) {
    match test {
        Test::Isometric => (pressure(u), pull(u)),
        Test::Isotonic => (pressure(u), contraction()),
        Test::Isobaric => (contraction(), pull(u)),
    }
}

/// The points of a curve in the figure's units.
pub fn line(curve: &Curve, test: Test, u: &Units) -> Vec<(f64, f64)> {
    curve
        .line(test)
        .into_iter()
        .map(|(x, y)| match test {
            Test::Isobaric => (x, u.force.value(y)),
            Test::Isometric => (u.pressure.value(x), u.force.value(y)),
            Test::Isotonic => (u.pressure.value(x), y),
        })
        .collect()
}

/// Where a point lies in the figure's units, and median and ends of the interval as built.
fn built(q: &CurvePoint, test: Test, u: &Units) -> Option<(f64, [f64; 3])> {
    let a = q.answer.as_ref().ok()?;
    let pressure = u.pressure.value(q.pressure_mpa);
    let pull =
        |b: Built| [b.predicted_n, b.predicted_low_n, b.predicted_high_n].map(|n| u.force.value(n));
    Some(match test {
        Test::Isobaric => (q.contraction?, pull(a.built?)),
        Test::Isometric => (pressure, pull(a.built?)),
        Test::Isotonic => (
            pressure,
            [a.predicted?, a.predicted_low?, a.predicted_high?],
        ),
    })
}

/// Those of a curve up to where no built muscle pulls any more.
fn as_built(curve: &Curve, test: Test, u: &Units) -> Vec<(f64, [f64; 3])> {
    let points = curve.points.iter().filter_map(|q| built(q, test, u));
    let points: Vec<(f64, [f64; 3])> = points.collect();
    let may_pull = |i: usize| points.get(i).is_some_and(|(_, ends)| ends[2] > 0.0);
    let is_drawn = |i: &usize| may_pull(*i) || may_pull(i + 1) || *i > 0 && may_pull(i - 1);
    let drawn = (0..points.len()).filter(is_drawn);
    drawn.map(|i| points[i]).collect()
}

/// The medians along a curve, where they are known; else the model.
fn median(curve: &Curve, test: Test, u: &Units) -> Vec<(f64, f64)> {
    let points = as_built(curve, test, u);
    if points.len() < 2 {
        return line(curve, test, u);
    }
    points.into_iter().map(|(x, ends)| (x, ends[0])).collect()
}

/// The 95 % interval along a curve, where it has one.
pub fn band(curve: &Curve, test: Test, u: &Units) -> Option<Series> {
    let points = as_built(curve, test, u).into_iter();
    let edges: Vec<(f64, f64, f64)> = points.map(|(x, [_, low, high])| (x, low, high)).collect();
    (edges.len() > 1).then(|| Series::band(&edges))
}

/// What is fixed along a curve, as its label.
pub fn label(test: Test, fixed: f64, u: &Units) -> String {
    match test {
        Test::Isometric => format!("ε {}", percent(fixed)),
        Test::Isotonic => u.force.show(fixed),
        Test::Isobaric => u.pressure.show(fixed),
    }
}

/// Points of a load's line.
const LINE: u32 = 100;

/// The line of a load over the contraction, and its equilibria: filled where they are stable.
fn load_line(loaded: &LoadAnswer, length_mm: f64, list: &[Curve], u: &Units) -> (Series, Series) {
    let along = list
        .iter()
        .flat_map(|c| &c.points)
        .filter_map(|p| p.contraction);
    let responses = loaded
        .at
        .iter()
        .flat_map(|at| &at.equilibria)
        .map(|e| &e.answer.response);
    let end = peak(along.chain(responses.clone().map(|r| r.contraction)));
    let (low, high) = loaded.line.reach_mm();
    let line = even((0.0, end), LINE)
        .filter(|e| (low..=high).contains(&(e * length_mm)))
        .map(|e| (e, u.force.value(loaded.line.force_n(e * length_mm))));
    let points = responses.map(|r| (r.contraction, u.force.value(r.force_n)));
    (
        Series::new("", line).style(Style::Dashed).neutral(),
        Series::scatter("", points).neutral(),
    )
}

pub fn curves(answer: &CurveAnswer, u: &Units) -> Figure {
    let &CurveAnswer {
        ref model,
        ref muscle,
        ref loaded,
        test,
        curves: ref list,
        both,
        ..
    } = answer;
    let (x, y) = axes(test, u);
    let mut panel = Panel::new(x, y);
    // Of two branches of one colour the muscle lengthens on the dashed one.
    let each = if both { 2 } else { 1 };
    for (i, curve) in list.iter().enumerate() {
        let (text, style) = if i % each == 0 {
            (label(test, curve.fixed, u), Style::Line)
        } else {
            (String::new(), Style::Dashed)
        };
        let series = |name: &str| {
            Series::new(name, median(curve, test, u))
                .style(style)
                .colour(i / each)
        };
        panel = panel.series(if list.len() <= 12 * each {
            series("").end_label(text)
        } else {
            series(&text)
        });
    }
    let bands = told_apart(
        list.iter()
            .enumerate()
            .filter_map(|(i, curve)| Some(band(curve, test, u)?.colour(i / each)))
            .collect(),
    );
    let said = said(&bands, "");
    if let Some(loaded) = loaded {
        let (line, balances) = load_line(loaded, muscle.length_mm, list, u);
        panel = panel
            .series(line.end_label(loaded.load.as_str()))
            .series(balances);
    }
    panel.series.extend(bands);
    let title = match test {
        Test::Isometric => "Isometric curves",
        Test::Isotonic => "Isotonic curves",
        Test::Isobaric => "Isobaric curves",
    };
    let branches = if both {
        "; dashed: while it is lengthened"
    } else {
        ""
    };
    let mut points = list.iter().flat_map(|curve| &curve.points);
    let is_built = points.any(|q| built(q, test, u).is_some());
    let as_built = if is_built { ", medians as built" } else { "" };
    Figure::new(title)
        .caption(caption(format!(
            "Model {model}{as_built}{branches}{said}. {}",
            muscle.line(u)
        )))
        .sequential()
        .panel(panel)
}

/// One colour a candidate: solid at the highest pressure that supply and muscle allow, dashed at
/// the pressure it needs.
pub fn design(
    models: &[(&Candidate, Box<dyn ForceModel>)],
    wanted: &[OperatingPoint],
    (options, is_model_named): (Options, bool),
    u: &Units,
) -> Figure {
    let mut panel = Panel::new(contraction(), pull(u));
    let mut bands = vec![];
    let reach = peak(wanted.iter().map(|w| w.contraction));
    for (i, (candidate, model)) in models.iter().enumerate() {
        let m = &candidate.muscle;
        let name = format!(
            "D0 {}, s {}",
            u.length.to(m.outer_diameter_mm(), 4),
            u.length.to(m.wall_mm(), 3)
        );
        let along = Vec::from_iter(even(
            (
                0.0,
                candidate
                    .free_contraction
                    .unwrap_or(0.2)
                    .max(reach)
                    .min(model.info().range.contraction.1),
            ),
            60,
        ));
        let max_pressure_mpa = candidate.highest_pressure_mpa;
        let needed = candidate.pressure_mpa;
        let workspace = &mut Workspace::new();
        let mut evaluation = Evaluation::new(model.as_ref(), workspace, options);
        for (pressure, style) in [(max_pressure_mpa, Style::Line), (needed, Style::Dashed)] {
            if pressure == needed && needed > 0.995 * max_pressure_mpa {
                continue;
            }
            for curve in evaluation.curves(Test::Isobaric, &[pressure], &along) {
                if i == 0 && pressure == max_pressure_mpa {
                    bands.extend(band(&curve, Test::Isobaric, u).map(|band| band.colour(0)));
                }
                let label = format!("{name} at {}", u.pressure.show(pressure));
                let points = if is_model_named {
                    line(&curve, Test::Isobaric, u)
                } else {
                    median(&curve, Test::Isobaric, u)
                };
                panel = panel.series(Series::new(label, points).colour(i).style(style));
            }
        }
    }
    for w in wanted {
        let label = format!("{} at {}", u.force.show(w.force_n), percent(w.contraction));
        panel = panel.mark(Mark::new(w.contraction, u.force.value(w.force_n), label));
    }
    let said = said(&bands, " of the first");
    panel.series.extend(bands);
    let mut names = Vec::from_iter(models.iter().map(|m| &*m.1.info().name));
    names.dedup();
    let branch = match (is_model_named, options.direction) {
        (false, direction) => format!(", as built, {}", direction.motion()),
        (_, Direction::Mean) => String::new(),
        (_, Direction::Contraction) => ", less friction while it shortens".into(),
        (_, Direction::Elongation) => ", with friction while it lengthens".into(),
    };
    Figure::new("Candidates: pull over contraction")
        .caption(caption(format!(
            "Model {}{branch}; lengths in {}{said}",
            names.join(", then "),
            u.length.name
        )))
        .panel(panel)
}

/// Colours of a figure before the grey, which is that of measured points.
const COLOURS: usize = 6;

/// The colour number of a model, the same in every figure: those that are compared most first, then
/// the others in the order of the list, then formulas of files in theirs.
pub fn model_colour(name: &str, formulas: &mut Vec<String>) -> usize {
    const FIRST: [&str; COLOURS] = ["fe", "universal", "thick-wall", "ideal", "fe3d", "paper"];
    let listed = Vec::from_iter(Model::all().into_iter().map(|entry| entry.name));
    let others = listed.iter().copied().filter(|name| !FIRST.contains(name));
    let place = FIRST
        .into_iter()
        .chain(others)
        .position(|known| known == name)
        .unwrap_or_else(|| {
            let known = formulas.iter().position(|known| known == name);
            listed.len()
                + known.unwrap_or_else(|| {
                    formulas.push(name.to_owned());
                    formulas.len() - 1
                })
        });
    // Without the grey.
    place + place / COLOURS
}

/// Isobaric curves of every model (one colour a model) at each pressure, with the measured points.
pub fn compare(
    models: Vec<Evaluation<'_>>,
    measured: &[MeasuredPoint],
    pressures: &[f64],
    contractions: &[f64],
    about: &str,
    u: &Units,
) -> Figure {
    let mut panel = Panel::new(contraction(), pull(u));
    let mut formulas = vec![];
    for (number, mut evaluation) in models.into_iter().enumerate() {
        let model = evaluation.model;
        let colour = model_colour(&model.info().name, &mut formulas);
        let family = evaluation.curves(Test::Isobaric, pressures, contractions);
        for (i, curve) in family.iter().enumerate() {
            let label = if i == 0 { &*model.info().name } else { "" };
            let style = [Style::Line, Style::Dashed, Style::Dotted, Style::DashDot]
                [(colour + colour / 4) % 4];
            let mut series = Series::new(label, line(curve, Test::Isobaric, u))
                .colour(colour)
                .style(style);
            if number == 0 {
                series = series.end_label(u.pressure.show(curve.fixed));
            }
            panel = panel.series(series);
        }
    }
    if !measured.is_empty() {
        panel = panel.series(
            Series::scatter(
                "measured",
                measured
                    .iter()
                    .map(|m| (m.contraction, u.force.value(m.force_n))),
            )
            .colour(COLOURS),
        );
    }
    Figure::new("Isobaric curves of models")
        .caption(caption(about))
        .panel(panel)
}
