//! A joint: torques over the angle, and what it reaches.

use super::{caption, curves::MOST_BANDS, said};
use crate::{JointAnswer, JointRow, Units};
use mckibben_report::{Axis, Figure, Palette, Panel, Series, Style};

/// Torque over angle of each family, and the map of angle and stiffness, as far as they are there.
pub fn joint(answer: &JointAnswer, over_angles: bool, u: &Units) -> Option<Figure> {
    let about = answer
        .muscles
        .first()
        .map_or_else(String::new, |m| m.line(u));
    let mut figure = Figure::new("Joint").palette(Palette::Sequential);
    let mut bands = vec![];
    let same = |a: &JointRow, b: &JointRow| {
        (a.pressure_1_mpa, a.pressure_2_mpa) == (b.pressure_1_mpa, b.pressure_2_mpa)
    };
    if over_angles && answer.points.len() > 1 {
        let mut panel = Panel::new(Axis::new("angle φ [°]"), Axis::new("torque τ [N m]"));
        for (i, family) in answer.points.chunk_by(same).enumerate() {
            let Some(first) = family.first() else {
                continue;
            };
            let second = first
                .pressure_2_mpa
                .map_or_else(String::new, |p| format!(", {}", u.pressure.bare(p)));
            let label = format!(
                "{}{second} {}",
                u.pressure.bare(first.pressure_1_mpa),
                u.pressure.name
            );
            let line = |of: fn(&JointRow) -> Option<f64>| {
                let points = family
                    .iter()
                    .filter_map(|q| Some((q.point.angle_deg, of(q)?)));
                Series::line("", points).colour(i)
            };
            panel = panel.series(line(|q| Some(q.point.torque_nm)).end_label(label));
            let edges: Vec<(f64, f64, f64)> = family
                .iter()
                .filter_map(|q| {
                    let p = &q.point;
                    let half = p.uncertainty_nm?;
                    Some((p.angle_deg, p.torque_nm - half, p.torque_nm + half))
                })
                .collect();
            bands.extend((edges.len() > 1).then(|| Series::band(&edges).colour(i)));
            for branch in [
                line(|q| q.torque_turning_plus_nm),
                line(|q| q.torque_turning_minus_nm),
            ] {
                if !branch.points.is_empty() {
                    panel = panel.series(branch.style(Style::Dotted));
                }
            }
        }
        if bands.len() > MOST_BANDS {
            bands.clear();
        }
        panel.series.extend_from_slice(&bands);
        figure = figure.panel(panel);
    }
    if let Some(map) = &answer.map {
        let mut panel = Panel::new(
            Axis::new("angle φ [°]"),
            Axis::new("stiffness −dτ/dφ [N m/rad]").from_zero(),
        )
        .title("reachable at rest");
        let at = |q: &mckibben::joint::MapPoint| (q.angle_deg, q.stiffness_nm_per_rad);
        let points = map.points.iter().flatten().filter(|q| !q.at_limit);
        panel = panel
            .series(Series::scatter("", points.map(at)).colour(0))
            .series(Series::line("", map.border.iter().map(at)).neutral());
        let mut torques = Panel::new(Axis::new("angle φ [°]"), Axis::new("torque τ [N m]"))
            .title("largest torques");
        for of in [
            |t: &(f64, f64, f64)| (t.0, t.1),
            |t: &(f64, f64, f64)| (t.0, t.2),
        ] {
            torques = torques.series(Series::line("", map.torques.iter().map(of)).neutral());
        }
        figure = figure.panel(panel).panel(torques);
    }
    let said = said(&bands, "");
    let figure = figure.caption(caption(format!("Model {}{said}. {about}", answer.model)));
    (!figure.panels.is_empty()).then_some(figure)
}
