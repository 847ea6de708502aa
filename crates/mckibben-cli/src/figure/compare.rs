//! Models and measured points on one figure.

use super::caption;
use super::curves::line;
use crate::output::text::Pressures;
use mckibben::answer::Options;
use mckibben::compare::MeasuredPoint;
use mckibben::curve::{Test, curves};
use mckibben::model::{ForceModel, Workspace};
use mckibben_report::{Axis, Figure, Panel, Series, Style};

/// Isobaric curves of every model (one colour a model) at each pressure, with the measured points.
pub fn compare(
    models: &[&dyn ForceModel],
    measured: &[MeasuredPoint],
    pressures: &[f64],
    contractions: &[f64],
    options: Options,
    about: &str,
    p: Pressures,
) -> Figure {
    let mut panel =
        Panel::new(Axis::new("contraction ratio ε [–]").from_zero(), Axis::new("pull F [N]").from_zero());
    for (number, model) in models.iter().enumerate() {
        for (i, curve) in
            curves(*model, &mut Workspace::new(), Test::Isobaric, pressures, contractions, options)
                .iter()
                .enumerate()
        {
            let label = if i == 0 { model.name() } else { "" };
            let style = [Style::Line, Style::Dashed, Style::Dotted, Style::DashDot][number % 4];
            let mut series = Series::new(label, line(curve, Test::Isobaric, p)).colour(number).style(style);
            if number + 1 == models.len() && measured.is_empty() {
                series = series.end_label(p.show(curve.fixed));
            }
            panel = panel.series(series);
        }
    }
    if !measured.is_empty() {
        let points: Vec<(f64, f64)> = measured.iter().map(|m| (m.contraction, m.force_n)).collect();
        panel = panel.series(Series::scatter("measured", points).colour(models.len()));
    }
    let list: Vec<String> = pressures.iter().map(|&v| p.show(v)).collect();
    let about = format!("Isobaric at {}. {about}", list.join(", "));
    Figure::new("Models compared").caption(caption(about)).panel(panel)
}
