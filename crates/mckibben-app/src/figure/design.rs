//! Isobaric curves of the first candidates with the operating points.

use super::curves::{band, line, pull};
use super::{BAND, caption};
use crate::{Units, percent};
use mckibben::answer::Options;
use mckibben::curve::{Test, curves};
use mckibben::model::{ForceModel, Workspace};
use mckibben_design::{Candidate, OperatingPoint};
use mckibben_report::{Axis, Figure, Mark, Panel, Series, Style};

/// One colour a candidate: solid at the maximum pressure, dashed at the pressure it needs.
pub fn design(
    models: &[(&Candidate, Box<dyn ForceModel>)],
    wanted: &[OperatingPoint],
    max_pressure_mpa: f64,
    options: Options,
    u: &Units,
) -> Figure {
    let mut panel = Panel::new(Axis::new("contraction ratio ε [–]").from_zero(), pull(u));
    let mut first_band = None;
    let asked = wanted.iter().map(|w| w.contraction).fold(0.0, f64::max);
    for (i, (candidate, model)) in models.iter().enumerate() {
        let m = &candidate.muscle;
        let name = format!("D0 {}, s {}", u.length.to(m.outer_diameter_mm(), 4), u.length.to(m.wall_mm(), 3));
        let end = candidate.free_contraction.unwrap_or(0.2).max(asked).min(model.info().range.contraction.1);
        let along: Vec<f64> = (0..=60).map(|i| end * f64::from(i) / 60.0).collect();
        let needed = candidate.pressure_mpa;
        let mut workspace = Workspace::new();
        for (pressure, style) in [(max_pressure_mpa, Style::Line), (needed, Style::Dashed)] {
            if pressure == needed && needed > 0.995 * max_pressure_mpa {
                continue;
            }
            for curve in curves(model.as_ref(), &mut workspace, Test::Isobaric, &[pressure], &along, options)
            {
                if i == 0 && pressure == max_pressure_mpa {
                    first_band = band(&curve, Test::Isobaric, u).map(|band| band.colour(0));
                }
                let label = format!("{name} at {}", u.pressure.show(pressure));
                let points = line(&curve, Test::Isobaric, u);
                panel = panel.series(Series::new(label, points).colour(i).style(style));
            }
        }
    }
    for w in wanted {
        let label = format!("{} at {}", u.force.show(w.force_n), percent(w.contraction));
        panel = panel.mark(Mark::new(w.contraction, u.force.value(w.force_n), label));
    }
    let said = if first_band.is_some() { BAND } else { "" };
    let said = said.replace("band", "band of the first");
    panel.series.extend(first_band);
    let mut names: Vec<&str> = models.iter().map(|m| &*m.1.info().name).collect();
    names.dedup();
    Figure::new("Candidates: pull over contraction")
        .caption(caption(format!("Model {}; lengths in {}{said}", names.join(", then "), u.length.name)))
        .panel(panel)
}
