//! Models and measured points on one figure.

use super::curves::{band, line, pull};
use super::{BAND, caption};
use crate::units::Units;
use mckibben::answer::Options;
use mckibben::curve::{Test, curves};
use mckibben::model::{ForceModel, Workspace};
use mckibben_fit::compare::MeasuredPoint;
use mckibben_report::{Axis, Figure, Panel, Series, Style};

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
    let count = models.len();
    let mut bands = vec![];
    for (number, (model, workspace)) in models.into_iter().enumerate() {
        let family = curves(model, workspace, Test::Isobaric, pressures, contractions, options);
        for (i, curve) in family.iter().enumerate() {
            let label = if i == 0 { &*model.info().name } else { "" };
            let style = [Style::Line, Style::Dashed, Style::Dotted, Style::DashDot][number % 4];
            let mut series = Series::new(label, line(curve, Test::Isobaric, u)).colour(number).style(style);
            if number == 0 {
                series = series.end_label(u.pressure.show(curve.fixed));
            }
            panel = panel.series(series);
            // Of the first model alone: those of several would cover each other.
            let band = band(curve, Test::Isobaric, u).filter(|_| number == 0);
            bands.extend(band.map(|band| band.colour(number)));
        }
    }
    if !measured.is_empty() {
        let points: Vec<(f64, f64)> =
            measured.iter().map(|m| (m.contraction, u.force.value(m.force_n))).collect();
        panel = panel.series(Series::scatter("measured", points).colour(count));
    }
    let said = if bands.is_empty() { "" } else { BAND };
    let said = said.replace("band", "band of the first model");
    panel.series.extend(bands);
    Figure::new("Isobaric curves of models").caption(caption(format!("{about}{said}"))).panel(panel)
}
