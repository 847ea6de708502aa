//! The figure of the measured muscles: points, and the model with the constants of the first fit.

use crate::report::Fitted;
use mckibben_core::{extremes::peak, model::Workspace, units::tidy};
use mckibben_fit::{
    identify::{Build, Section},
    measured::{DataPoint, distinct, mean_of_data, same},
};
use mckibben_report::{Axis, Figure, Panel, Series};

/// Pressures of a panel at most; of more some are shown.
const CURVES: usize = 5;
/// Points of a line.
const LINE: u32 = 30;

/// Measured points and lines of a model, muscle by muscle.
pub fn figure(all: &[Fitted<'_>], model: &str, build: &Build<'_>) -> Figure {
    let caption = format!(
        "Dots: measured, means of the branches; lines: {model} with the constants of the first fit \
         of each muscle, over ε at constant pressure"
    );
    let mut figure = Figure::new(format!("Measured muscles and {model}"))
        .caption(caption)
        .sequential();
    for of_case in all.chunk_by(|a, b| a.case.name == b.case.name) {
        let Some(first) = of_case.first() else {
            continue;
        };
        let means = mean_of_data(&first.case.points);
        let mut sections: Vec<Section> = vec![];
        for p in &means {
            if !sections.contains(&p.section) {
                sections.push(p.section);
            }
        }
        for section in &sections {
            let points: Vec<&DataPoint> = means.iter().filter(|p| p.section == *section).collect();
            let title = match section.length_mm {
                Some(length) if sections.len() > 1 => format!("{}: {length} mm", first.case.name),
                _ => first.case.facts.title.clone(),
            };
            figure = figure.panel(panel(title, &points, first, build));
        }
    }
    figure.columns(2)
}

fn panel(mut title: String, points: &[&DataPoint], of: &Fitted<'_>, build: &Build<'_>) -> Panel {
    let mut pressures = distinct(points.iter().map(|p| p.at.pressure_mpa));
    let all = pressures.len();
    if all > CURVES {
        let shown = (1..=CURVES).map(|i| pressures[i * (all - 1) / CURVES]);
        pressures = shown.collect();
        title += &format!(" ({CURVES} of {all} pressures)");
    }
    let contraction = Axis::new("contraction ratio ε [–]").from_zero();
    let pull = Axis::new("pull F [N]").from_zero();
    let mut panel = Panel::new(contraction, pull).title(title);
    let muscle = points
        .first()
        .and_then(|p| p.section.apply(&of.muscle).ok());
    let model = muscle.and_then(|m| build(&m).ok());
    let mut workspace = Workspace::new();
    for (n, &pressure) in pressures.iter().enumerate() {
        let at = || points.iter().filter(|p| same(p.at.pressure_mpa, pressure));
        let end = peak(at().map(|p| p.at.contraction));
        let dots = at().map(|p| (p.at.contraction, p.at.force_n));
        panel = panel.series(Series::scatter("", dots).colour(n));
        let Some(model) = &model else { continue };
        let line = (0..=LINE).filter_map(|i| {
            let contraction = end * f64::from(i) / f64::from(LINE);
            let force_n = model.force_n(&mut workspace, pressure, contraction).ok()?;
            (force_n >= 0.0).then_some((contraction, force_n))
        });
        let line = Series::new("", line).end_label(format!("{} MPa", tidy(pressure, 3)));
        panel = panel.series(line.colour(n));
    }
    panel
}
