//! Figures of a response: rise, settling, overshoot, fill and vent.

use crate::{Command, Commanded, Drive, Motion, MotionEnd, Moves, StepFigures, system::System};
use mckibben_core::{
    analysis::bisect,
    extremes::{ends, peak},
};

/// A point that was integrated.
pub struct Passed {
    pub time_s: f64,
    pub coordinate: f64,
    pub velocity: f64,
    /// Gauge pressure of the first muscle.
    pub gauge_mpa: f64,
}

/// A value at a time, with its slope where that is known.
struct Spot {
    time: f64,
    value: f64,
    slope: Option<f64>,
}

/// Values over time, cubic between two spots whose slopes are known, else straight.
struct Track(Vec<Spot>);

impl Track {
    /// Of times, values and slopes.
    fn new(spots: impl Iterator<Item = (f64, f64, Option<f64>)>) -> Self {
        Self(
            spots
                .map(|(time, value, slope)| Spot { time, value, slope })
                .collect(),
        )
    }

    /// The last value up to a time.
    fn value_at(&self, t: f64) -> f64 {
        let after = self.0.partition_point(|spot| spot.time <= t);
        self.0
            .get(after.saturating_sub(1))
            .map_or(0.0, |spot| spot.value)
    }

    /// The spots within a piece.
    fn inside(&self, (from, until): (f64, f64)) -> impl Iterator<Item = &Spot> {
        self.0
            .iter()
            .filter(move |spot| spot.time >= from && spot.time <= until)
    }

    /// The first time within a piece at which the value comes to `level`.
    fn reaches(&self, level: f64, (from, until): (f64, f64)) -> Option<f64> {
        for pair in self.0.windows(2) {
            let [start, end] = pair else { continue };
            let a = start.time;
            let h = end.time - start.time;
            if end.time <= from || a >= until {
                continue;
            }
            let x = start.value - level;
            let y = end.value - level;
            if x == 0.0 && a >= from {
                return Some(a);
            }
            if x * y > 0.0 || x == 0.0 {
                continue;
            }
            let [k, l] = [start, end].map(|spot| spot.slope.map_or(y - x, |slope| h * slope));
            // Hermite's cubic, halved: it changes its sign within.
            let cubic = |s: f64| {
                let r = 1.0 - s;
                x * r * r * (1.0 + 2.0 * s) + y * s * s * (3.0 - 2.0 * s) + k * s * r * r
                    - l * s * s * r
            };
            return Some(a + h * bisect(0.0, 1.0, 60, |s| cubic(s) * x > 0.0).1);
        }
        None
    }

    /// The time from 10 % to 90 % of the way between two positions within a piece.
    fn rise_time(&self, from: f64, to: f64, piece: (f64, f64)) -> Option<f64> {
        let tenth = self.reaches(from + 0.1 * (to - from), piece)?;
        Some(self.reaches(from + 0.9 * (to - from), (tenth, piece.1))? - tenth)
    }
}

/// The time from 10 % to 90 % of the way between two positions within a piece.
pub fn rise_time(motion: &Motion, from: f64, to: f64, piece: (f64, f64)) -> Option<f64> {
    let series = &motion.series;
    let moved = series.coordinate.iter().zip(&series.velocity);
    let spots = series.time_s.iter().zip(moved);
    Track::new(spots.map(|(t, (q, v))| (*t, *q, Some(*v)))).rise_time(from, to, piece)
}

/// Where a command changes, with what it is before and after.
pub fn changes(drive: &Drive) -> Vec<f64> {
    let moves = |c: &Command, t: f64| {
        t < drive.until_s && c.value(t) != c.value_within(t, t - 1e-9 * drive.until_s)
    };
    let mut times = vec![];
    for c in drive.target.commands() {
        times.extend(c.breakpoints().into_iter().filter(|t| moves(c, *t)));
    }
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// A drive that is held by its commands in the state that the first step reaches: those after it; the
/// mean of a periodic one, and the last of those that never change.
pub fn reached(drive: &Drive) -> Drive {
    let changes = changes(drive);
    let end = changes.get(1).copied().unwrap_or(drive.until_s);
    let at = 0.5 * (changes.first().copied().unwrap_or_default() + end);
    let one = |command: &Command| {
        Command::Constant(match command {
            Command::Sine { .. } | Command::Chirp { .. } => {
                0.5 * (command.bounds().0 + command.bounds().1)
            }
            _ => command.value_within(end, at),
        })
    };
    Drive {
        target: Commanded::Pressure(drive.target.commands().iter().map(one).collect()),
        external: one(&drive.external),
        initial_coordinate: None,
        ..drive.clone()
    }
}

/// Fills in the figures of a motion, of everything that was passed: with a long run the points of
/// its series lie far apart. A load that still moves at the end is on its way to `goal`.
pub fn step_figures(drive: &Drive, motion: &mut Motion, passed: &[Passed], goal: Option<f64>) {
    let spots = passed.iter();
    let positions = Track::new(
        spots
            .clone()
            .map(|p| (p.time_s, p.coordinate, Some(p.velocity))),
    );
    let pressures = Track::new(spots.map(|p| (p.time_s, p.gauge_mpa, None)));
    let mut times = changes(drive);
    times.push(drive.until_s);
    for pair in times.windows(2) {
        let [begin, end] = *pair else { continue };
        let piece = (begin, end);
        let from = positions.value_at(begin);
        let to = match &drive.target {
            Commanded::Position { command, .. } => {
                command.value_within(end, 0.5 * (begin + end))
                    / drive.mechanism.position_per_coordinate()
            }
            _ => goal
                .filter(|_| end == drive.until_s)
                .unwrap_or_else(|| positions.value_at(end)),
        };
        let step = to - from;
        if step.abs() > 1e-9 * drive.mechanism.shortening(0.0).recip() {
            // Less than the error of the integration is none.
            let overshoot = peak(positions.inside(piece).map(|spot| (spot.value - to) / step));
            let outside = positions
                .inside(piece)
                .filter(|spot| (spot.value - to).abs() > 0.02 * step.abs())
                .map(|spot| spot.time)
                .reduce(f64::max);
            motion.steps.push(StepFigures {
                time_s: begin,
                from,
                to,
                rise_time_s: positions.rise_time(from, to, piece),
                // What changes in the last tenth of the piece has not settled.
                settling_time_s: outside
                    .filter(|t| *t < end - 0.1 * (end - begin))
                    .map(|t| t - begin),
                overshoot: if overshoot < 1e-4 { 0.0 } else { overshoot },
            });
        }
        let p = pressures.value_at(begin);
        let r = pressures.value_at(end);
        let slot = if r > p {
            &mut motion.fill_time_s
        } else {
            &mut motion.vent_time_s
        };
        if slot.is_none() && (r - p).abs() > 1e-6 {
            *slot = pressures
                .reaches(p + 0.98 * (r - p), piece)
                .map(|t| t - begin);
        }
    }
    if let Some(first) = motion.steps.first() {
        motion.rise_time_s = first.rise_time_s;
        motion.settling_time_s = first.settling_time_s;
        motion.overshoot = Some(first.overshoot);
    }
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

/// How the load moves at the end, where the command is constant there and the load can move; with
/// the coordinate of the static equilibrium under the commanded pressures, without friction, where
/// that is sought and found.
pub fn rest(system: &System, passed: &[Passed]) -> Option<(MotionEnd, Option<f64>)> {
    let drive = &system.drive;
    let until = drive.until_s;
    if drive.mechanism.is_held() {
        return None;
    }
    let from = drive
        .target
        .commands()
        .iter()
        .chain([&drive.external])
        .map(constant_from)
        .collect::<Option<Vec<_>>>()?;
    let from = peak(from);
    if from >= until {
        return None;
    }
    let last = until - LAST * (until - from);
    let begin = passed
        .iter()
        .rfind(|p| p.time_s <= from)
        .or(passed.first())?
        .coordinate;
    let late = Vec::from_iter(
        passed
            .iter()
            .filter(|p| p.time_s >= last)
            .map(|p| p.coordinate),
    );
    let first = *late.first()?;
    let end = *late.last()?;
    let (low, high) = ends(late.iter().copied());
    let room = (SHARE * (end - begin).abs()).max(OF_LENGTH / drive.mechanism.shortening(end));
    let moves = if high - low <= room {
        Moves::Rests
    } else if high - low > 1.2 * (end - first).abs() {
        Moves::Swings
    } else {
        Moves::Creeps
    };
    let equilibrium = match &drive.target {
        Commanded::Pressure(commands) => {
            let pressures = Vec::from_iter(commands.iter().map(|c| c.value(until)));
            system.at_pressures(&pressures).ok().map(|e| e.coordinate)
        }
        _ => None,
    };
    Some((
        MotionEnd {
            moves,
            between: (low, high),
        },
        equilibrium,
    ))
}
