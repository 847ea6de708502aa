//! A motion: position and pressure over time.

use super::caption;
use crate::motion::{MotionAnswer, MotionRun};
use crate::units::Units;
use mckibben_report::{Axis, Figure, Palette, Panel, Series, Style};

/// Position, pressures with their command, and pulls; the runs of a sweep one over the other.
pub fn motion(answer: &MotionAnswer, sweep: Option<&str>, u: &Units) -> Figure {
    let runs: Vec<&MotionRun> = std::iter::once(&answer.motion).chain(&answer.others).collect();
    let joint = answer.motion.series.angle_deg.is_some();
    let time = || Axis::new("time t [s]").from_zero();
    let position = if joint { "angle φ [°]" } else { "contraction ratio ε [–]" };
    let mut places = Panel::new(time(), Axis::new(position));
    let mut pressures = Panel::new(time(), Axis::new(u.pressure.heading("pressure P")).from_zero());
    for (i, run) in runs.iter().enumerate() {
        let s = &run.series;
        let over = |list: &[f64], scale: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
            s.time_s.iter().zip(list).map(|(t, v)| (*t, scale(*v))).collect()
        };
        let label = run.value.clone().unwrap_or_default();
        let plain = |v: f64| v;
        let pressure = |v: f64| u.pressure.value(v);
        let place = s.angle_deg.as_deref().or(s.muscle.as_ref().map(|m| &m.contraction[..]));
        places = places
            .series(Series::line("", over(place.unwrap_or_default(), &plain)).colour(i).end_label(label));
        let numbered = |number: &str| if runs.len() > 1 { String::new() } else { number.to_owned() };
        let lists = [
            s.muscle.as_ref().map(|m| (&m.pressure_mpa, numbered(""))),
            s.first.as_ref().map(|m| (&m.pressure_mpa, numbered("P1"))),
            s.second.as_ref().map(|m| (&m.pressure_mpa, numbered("P2"))),
        ];
        for (k, (list, name)) in lists.into_iter().flatten().enumerate() {
            let style = if k == 0 { Style::Line } else { Style::Dashed };
            pressures = pressures
                .series(Series::new("", over(list, &pressure)).style(style).colour(i).end_label(name));
        }
    }
    let about = answer.muscles.first().map_or_else(String::new, |m| m.line(u));
    let of = sweep.map_or_else(String::new, |key| format!(" over {key}"));
    Figure::new(format!("Motion{of}"))
        .caption(caption(format!("Model {}. {about}", answer.model)))
        .palette(Palette::Sequential)
        .panel(places)
        .panel(pressures)
}
