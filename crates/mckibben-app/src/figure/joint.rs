//! A joint: torques over the angle, and what it reaches.

use super::{caption, said, told_apart};
use crate::{JointAnswer, JointRow, Units};
use mckibben_core::joint::{JointMap, MapPoint};
use mckibben_report::{Axis, Figure, Panel, Series, Style};

/// Torque over angle of each family, and the map of angle and stiffness, as far as they are there.
pub fn joint(answer: &JointAnswer, over_angles: bool, u: &Units) -> Option<Figure> {
    let about = answer
        .muscles
        .first()
        .map_or_else(String::new, |m| m.line(u));
    let mut figure = Figure::new("Joint").sequential();
    let mut bands = vec![];
    if over_angles && answer.points.len() > 1 {
        let panel;
        (panel, bands) = torques(&answer.points, u);
        figure = figure.panel(panel);
    }
    if let Some(map) = &answer.map {
        figure.panels.extend(reachable(map));
    }
    let said = said(&bands, "");
    let figure = figure.caption(caption(format!("Model {}{said}. {about}", answer.model)));
    (!figure.panels.is_empty()).then_some(figure)
}

/// Torque over angle of each family of pressures, and the bands in it.
fn torques(points: &[JointRow], u: &Units) -> (Panel, Vec<Series>) {
    let mut bands = vec![];
    let same = |a: &JointRow, b: &JointRow| {
        (a.pressure_1_mpa, a.pressure_2_mpa) == (b.pressure_1_mpa, b.pressure_2_mpa)
    };
    let mut panel = Panel::new(Axis::new("angle φ [°]"), Axis::new("torque τ [N m]"));
    for (i, family) in points.chunk_by(same).enumerate() {
        let first = &family[0];
        let second = first
            .pressure_2_mpa
            .map_or_else(String::new, |p| format!(", {}", u.pressure.bare(p)));
        let label = format!(
            "{}{second} {}",
            u.pressure.bare(first.pressure_1_mpa),
            u.pressure.name
        );
        let line = |of: &dyn Fn(&JointRow) -> Option<f64>| -> Vec<(f64, f64)> {
            family
                .iter()
                .filter_map(|q| Some((q.point.angle_deg, of(q)?)))
                .collect()
        };
        panel = panel.series(
            Series::line(
                "",
                line(&|q| q.point.predicted_nm.or(Some(q.point.torque_nm))),
            )
            .colour(i)
            .end_label(label),
        );
        let edges = Vec::from_iter(family.iter().filter_map(|q| {
            let ends = (q.point.predicted_low_nm?, q.point.predicted_high_nm?);
            Some((q.point.angle_deg, ends.0, ends.1))
        }));
        bands.extend((edges.len() > 1).then(|| Series::band(&edges).colour(i)));
        for branch in [
            line(&|q| q.torque_turning_plus_nm),
            line(&|q| q.torque_turning_minus_nm),
        ] {
            if !branch.is_empty() {
                panel = panel.series(Series::new("", branch).style(Style::Dotted).colour(i));
            }
        }
    }
    let bands = told_apart(bands);
    panel.series.extend_from_slice(&bands);
    (panel, bands)
}

/// The map of angle and stiffness, and the largest torques over the angle.
fn reachable(map: &JointMap) -> [Panel; 2] {
    let at = |q: &MapPoint| (q.angle_deg, q.stiffness_nm_per_rad);
    let points = map.points.iter().flatten().filter(|q| !q.at_limit).map(at);
    let states = Panel::new(
        Axis::new("angle φ [°]"),
        Axis::new("stiffness −dτ/dφ [N m/rad]").from_zero(),
    )
    .title("reachable at rest")
    .series(Series::scatter("a pair of pressures", points).colour(0))
    .series(Series::line("one at its highest, or at 0", map.border.iter().map(at)).colour(1));
    let [low, high] = [0, 1].map(|end| {
        let line = map.torques.iter().map(|t| (t.0, [t.1, t.2][end]));
        Series::line("", line).neutral()
    });
    let torques = Panel::new(Axis::new("angle φ [°]"), Axis::new("torque τ [N m]"))
        .title("largest torques")
        .series(low)
        .series(high);
    [states, torques]
}
