//! A motion: position and pressure over time.

use super::{caption, pressure, said};
use crate::{MotionAnswer, MotionRun, Units};
use mckibben_motion::Coordinate;
use mckibben_report::{Axis, Figure, Panel, Series, Style};

/// Position, pressures with their command, and pulls; the runs of a sweep one over the other.
pub fn motion(answer: &MotionAnswer, sweep: Option<&str>, u: &Units) -> Figure {
    let runs = Vec::from_iter(answer.runs());
    let joint = answer.motion.motion.series.kind == Coordinate::Angle;
    let time = || Axis::new("time t [s]").from_zero();
    let position = if joint {
        "angle φ [°]"
    } else {
        "contraction ratio ε [–]"
    };
    let mut places = Panel::new(time(), Axis::new(position));
    let mut pressures = Panel::new(time(), pressure(u));
    let mut bands = vec![];
    for (i, run) in runs.iter().enumerate() {
        bands.extend(end_band(run).map(|band| band.colour(i)));
        let s = &run.motion.series;
        let over = |list: &[f64], shown: &dyn Fn(f64) -> f64| {
            Series::line("", s.time_s.iter().zip(list).map(|(t, v)| (*t, shown(*v)))).colour(i)
        };
        let place = match s.degrees() {
            Some([angle, _]) => over(&angle, &|v| v),
            None => over(s.muscles.first().map_or(&[], |m| &m.contraction), &|v| v),
        };
        places = places.series(place.end_label(run.value.clone().unwrap_or_default()));
        for (k, muscle) in s.muscles.iter().enumerate() {
            let name = if joint && runs.len() == 1 {
                format!("P{}", k + 1)
            } else {
                String::new()
            };
            let style = if k == 0 { Style::Line } else { Style::Dashed };
            pressures = pressures.series(
                over(&muscle.pressure_mpa, &|p| u.pressure.value(p))
                    .style(style)
                    .end_label(name),
            );
        }
    }
    let said = said(&bands, " at the end");
    places.series.extend(bands);
    let about = answer
        .muscles
        .first()
        .map_or_else(String::new, |m| m.line(u));
    let of = sweep.map_or_else(String::new, |key| format!(" over {key}"));
    Figure::new(format!("Motion{of}"))
        .caption(caption(format!("Model {}{said}. {about}", answer.model)))
        .sequential()
        .panel(places)
        .panel(pressures)
}

/// The last part of a motion whose load does not settle.
const LAST: f64 = 0.9;

/// The ± of the end, from the time on from which the load rests.
fn end_band(run: &MotionRun) -> Option<Series> {
    let motion = &run.motion;
    let end = &run.end;
    let time = &motion.series.time_s;
    let last = time.last().copied()?;
    let from = motion
        .steps
        .last()
        .and_then(|step| Some(step.time_s + step.settling_time_s?))
        .unwrap_or(last)
        .min(LAST * last);
    let in_the_end = |list: &[f64]| list.last().copied();
    let (low, high) = if let Some(half) = end.end_angle_uncertainty_deg {
        let [angle, _] = motion.series.degrees()?;
        let value = motion.equilibrium_angle_deg.or(in_the_end(&angle))?;
        (value - half, value + half)
    } else {
        (
            end.end_contraction_predicted_low?,
            end.end_contraction_predicted_high?,
        )
    };
    Some(Series::band(&[(from, low, high), (last, low, high)]))
}
