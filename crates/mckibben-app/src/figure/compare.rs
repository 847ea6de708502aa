//! Models and measured points on one figure.

use super::curves::{band, line, pull};
use super::{BAND, caption};
use crate::{Model, Units};
use mckibben::answer::Options;
use mckibben::curve::{Test, curves};
use mckibben::model::{ForceModel, Workspace};
use mckibben_fit::compare::MeasuredPoint;
use mckibben_report::{Axis, Figure, Panel, Series, Style};

/// Colours of a figure before the grey, which is that of measured points.
const COLOURS: usize = 6;

/// The colour number of a model, the same in every figure: those that are compared most first, then the others in the order of the list, then formulas of
/// files in theirs.
pub fn model_colour(name: &str, formulas: &mut Vec<String>) -> usize {
    const FIRST: [&str; COLOURS] = ["fe", "universal", "thick-wall", "ideal", "fe3d", "paper"];
    let listed: Vec<&str> = Model::all().into_iter().map(|entry| entry.name).collect();
    let others = listed.iter().copied().filter(|name| !FIRST.contains(name));
    let place = FIRST.into_iter().chain(others).position(|known| known == name).unwrap_or_else(|| {
        if !formulas.iter().any(|known| known == name) {
            formulas.push(name.to_owned());
        }
        listed.len() + formulas.iter().position(|known| known == name).unwrap_or_default()
    });
    // Without the grey.
    place + place / COLOURS
}

/// Isobaric curves of every model (one colour a model) at each pressure, with the measured points.
pub fn compare(
    models: Vec<(&dyn ForceModel, &mut Workspace)>,
    measured: &[MeasuredPoint],
    pressures: &[f64],
    contractions: &[f64],
    options: Options,
    about: &str,
    u: &Units,
) -> Figure {
    let mut panel = Panel::new(Axis::new("contraction ratio ε [–]").from_zero(), pull(u));
    let (mut bands, mut formulas) = (vec![], vec![]);
    for (number, (model, workspace)) in models.into_iter().enumerate() {
        let colour = model_colour(&model.info().name, &mut formulas);
        let family = curves(model, workspace, Test::Isobaric, pressures, contractions, options);
        for (i, curve) in family.iter().enumerate() {
            let label = if i == 0 { &*model.info().name } else { "" };
            let style =
                [Style::Line, Style::Dashed, Style::Dotted, Style::DashDot][(colour + colour / 4) % 4];
            let mut series = Series::new(label, line(curve, Test::Isobaric, u)).colour(colour).style(style);
            if number == 0 {
                series = series.end_label(u.pressure.show(curve.fixed));
            }
            panel = panel.series(series);
            // Of the first model alone: those of several would cover each other.
            let band = band(curve, Test::Isobaric, u).filter(|_| number == 0);
            bands.extend(band.map(|band| band.colour(colour)));
        }
    }
    if !measured.is_empty() {
        let points: Vec<(f64, f64)> =
            measured.iter().map(|m| (m.contraction, u.force.value(m.force_n))).collect();
        panel = panel.series(Series::scatter("measured", points).colour(COLOURS));
    }
    let said = if bands.is_empty() { "" } else { BAND };
    let said = said.replace("band", "band of the first model");
    panel.series.extend(bands);
    Figure::new("Isobaric curves of models").caption(caption(format!("{about}{said}"))).panel(panel)
}
