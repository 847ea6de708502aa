//! Figures of a response: rise, settling, overshoot, fill and vent.

use crate::system::System;
use crate::{Command, Drive, Motion, MotionEnd, Moves, StepFigures, Target};

/// A point that was integrated.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Passed {
    pub time_s: f64,
    pub coordinate: f64,
    pub velocity: f64,
    /// Gauge pressure of the first muscle.
    pub gauge_mpa: f64,
}

/// A column over time, cubic between its points where its slope is known.
struct Track<'a> {
    time: &'a [f64],
    value: &'a [f64],
    slope: Option<&'a [f64]>,
}

impl Track<'_> {
    /// The first time from `from` on at which the value comes to `level`, to the piece's end.
    fn reaches(&self, level: f64, from: f64, until: f64) -> Option<f64> {
        let at = |list: &[f64], i: usize| list.get(i).copied();
        for i in 1..self.time.len() {
            let (a, b) = (at(self.time, i - 1)?, at(self.time, i)?);
            if b <= from || a >= until {
                continue;
            }
            let (x, y) = (at(self.value, i - 1)? - level, at(self.value, i)? - level);
            if x == 0.0 && a >= from {
                return Some(a);
            }
            if x * y > 0.0 || x == 0.0 {
                continue;
            }
            let h = b - a;
            let (k, l) = match self.slope {
                Some(s) => (h * at(s, i - 1)?, h * at(s, i)?),
                None => (y - x, y - x),
            };
            // Hermite's cubic, halved: it changes its sign within.
            let cubic = |s: f64| {
                let r = 1.0 - s;
                x * r * r * (1.0 + 2.0 * s) + y * s * s * (3.0 - 2.0 * s) + k * s * r * r - l * s * s * r
            };
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let mid = 0.5 * (low + high);
                if cubic(mid) * x > 0.0 { low = mid } else { high = mid }
            }
            return Some(a + h * high);
        }
        None
    }

    /// The time from 10 % to 90 % of the way between two positions after a time.
    fn rise_time(&self, from: f64, to: f64, after: f64, until: f64) -> Option<f64> {
        let tenth = self.reaches(from + 0.1 * (to - from), after, until)?;
        let most = self.reaches(from + 0.9 * (to - from), tenth, until)?;
        Some(most - tenth)
    }

    /// The last time within the piece at which the value is farther than `band` from `level`.
    fn leaves(&self, level: f64, band: f64, from: f64, until: f64) -> Option<f64> {
        let inside = |t: f64| t >= from && t <= until;
        let far = self.time.iter().zip(self.value).filter(|(t, v)| inside(**t) && (**v - level).abs() > band);
        far.map(|(t, _)| *t).reduce(f64::max)
    }
}

/// The time from 10 % to 90 % of the way between two positions after a time.
pub(crate) fn rise_time(motion: &Motion, from: f64, to: f64, after: f64, until: f64) -> Option<f64> {
    let series = &motion.series;
    let track = Track { time: &series.time_s, value: &series.coordinate, slope: Some(&series.velocity) };
    track.rise_time(from, to, after, until)
}

/// Where a command changes, with what it is before and after.
pub(crate) fn changes(drive: &Drive<'_>) -> Vec<f64> {
    let mut times: Vec<f64> = drive
        .target
        .commands()
        .iter()
        .filter(|c| c.period_s().is_none())
        .flat_map(|c| {
            let moved = |t: &f64| c.value_within(*t, *t) != c.value_within(*t, t - 1e-9 * drive.until_s);
            c.breakpoints().into_iter().filter(moved).collect::<Vec<_>>()
        })
        .filter(|t| *t < drive.until_s)
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// Fills in the figures of a motion, of everything that was passed: with a long run the points of its series lie far apart.
pub(crate) fn step_figures(drive: &Drive<'_>, motion: &mut Motion, passed: &[Passed], cycle: Option<f64>) {
    let of = |pick: fn(&Passed) -> f64| passed.iter().map(pick).collect::<Vec<f64>>();
    let (time, value, velocity, gauge) =
        (of(|p| p.time_s), of(|p| p.coordinate), of(|p| p.velocity), of(|p| p.gauge_mpa));
    let track = Track { time: &time, value: &value, slope: Some(&velocity) };
    let at = |list: &[f64], t: f64| {
        let i = time.partition_point(|x| *x <= t).saturating_sub(1);
        list.get(i).copied().unwrap_or(0.0)
    };
    let mut ends = changes(drive);
    let starts = ends.clone();
    ends.push(drive.until_s);
    for (begin, end) in starts.iter().zip(ends.iter().skip(1)) {
        let (from, to) = (at(&value, *begin), at(&value, *end));
        let way = to - from;
        if way.abs() > 1e-9 * drive.mechanism.lever(0, 0.0).per_coordinate.abs().max(1e-9).recip() {
            let beyond = |v: &f64| (v - to) / way;
            let inside = time.iter().zip(&value).filter(|(t, _)| **t >= *begin && **t <= *end);
            // What is less than the integration knows is none.
            let overshoot = inside.map(|(_, v)| beyond(v)).fold(0.0, f64::max);
            let overshoot = if overshoot < 1e-4 { 0.0 } else { overshoot };
            let left = track.leaves(to, 0.02 * way.abs(), *begin, *end);
            // Of the last tenth of the piece nothing can be said to have settled.
            let settled = left.filter(|t| *t < end - 0.1 * (end - begin)).map(|t| t - begin);
            motion.steps.push(StepFigures {
                time_s: *begin,
                from,
                to,
                rise_time_s: track.rise_time(from, to, *begin, *end),
                settling_time_s: settled,
                overshoot,
            });
        }
        let pressure = Track { time: &time, value: &gauge, slope: None };
        let (p, r) = (at(&gauge, *begin), at(&gauge, *end));
        let slot = if r > p { &mut motion.fill_time_s } else { &mut motion.vent_time_s };
        if slot.is_none() && (r - p).abs() > 1e-6 {
            *slot = pressure.reaches(p + 0.98 * (r - p), *begin, *end).map(|t| t - begin);
        }
    }
    let first = motion.steps.first().copied();
    motion.rise_time_s = first.and_then(|f| f.rise_time_s);
    motion.settling_time_s = first.and_then(|f| f.settling_time_s);
    motion.overshoot = first.map(|f| f.overshoot);
    let Some((from, muscle)) = cycle.zip(motion.series.muscles.first()) else { return };
    let series = &motion.series;
    let points: Vec<(f64, f64)> = series
        .time_s
        .iter()
        .zip(muscle.pressure_mpa.iter().zip(&series.coordinate))
        .filter(|(t, _)| **t >= from)
        .map(|(_, (p, x))| (*p, *x))
        .collect();
    // Trapezoids, closed from the last point to the first.
    let closed = points.iter().zip(points.iter().cycle().skip(1));
    motion.loop_area = Some(closed.map(|(a, b)| 0.5 * (a.0 + b.0) * (b.1 - a.1)).sum::<f64>().abs());
}

/// The share of the way within which a load rests.
const SHARE: f64 = 0.02;
/// The same of the muscle's length, for ways that are next to none.
const OF_LENGTH: f64 = 1e-4;
/// The last part of the time since the command became constant that is looked at.
const LAST: f64 = 0.1;

/// The time from which on a command does not change; `None` for one that always does.
fn constant_from(command: &Command) -> Option<f64> {
    match command {
        Command::Constant(_) => Some(0.0),
        Command::Steps(points) | Command::Ramps(points) => points.last().map(|p| p.0),
        Command::Sine { .. } | Command::Chirp { .. } => None,
    }
}

/// How the load moves at the end, where the command is constant there and the load can move; with the coordinate of the static
/// equilibrium under the commanded pressures, without friction, where that is sought and found.
pub(crate) fn rest(system: &System<'_>, passed: &[Passed]) -> Option<(MotionEnd, Option<f64>)> {
    let drive = system.drive;
    let until = drive.until_s;
    if drive.mechanism.is_held() {
        return None;
    }
    let commands = drive.target.commands();
    let from = commands.iter().map(constant_from).collect::<Option<Vec<_>>>()?;
    let from = from.into_iter().fold(0.0, f64::max);
    if from >= until {
        return None;
    }
    let last = until - LAST * (until - from);
    let begin = passed.iter().take_while(|p| p.time_s <= from).last().or(passed.first())?.coordinate;
    let late: Vec<f64> = passed.iter().filter(|p| p.time_s >= last).map(|p| p.coordinate).collect();
    let (first, end) = (*late.first()?, *late.last()?);
    let low = late.iter().copied().fold(f64::INFINITY, f64::min);
    let high = late.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let length = 1.0 / drive.mechanism.lever(0, end).per_coordinate.abs().max(1e-9);
    let room = (SHARE * (end - begin).abs()).max(OF_LENGTH * length);
    let moves = if high - low <= room {
        Moves::Rests
    } else if high - low > 1.2 * (end - first).abs() {
        Moves::Swings
    } else {
        Moves::Creeps
    };
    let equilibrium = match &drive.target {
        Target::Pressure(commands) => {
            let pressures: Vec<f64> = commands.iter().map(|c| c.value_within(until, until)).collect();
            system.at_pressures(&pressures).ok().map(|e| e.coordinate)
        }
        Target::Opening(_) | Target::Volume(_) | Target::Position { .. } => None,
    };
    Some((MotionEnd { moves, between: (low, high) }, equilibrium))
}
