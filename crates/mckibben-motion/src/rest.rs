//! Whether the load rests at the end.

use crate::command::Command;
use crate::drive::Target;
use crate::equilibrium::at_pressures;
use crate::metrics::Passed;
use crate::motion::{MotionEnd, Moves};
use crate::system::System;

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
            at_pressures(drive, &system.members, &pressures).ok().map(|e| e.coordinate)
        }
        Target::Opening(_) | Target::Volume(_) | Target::Position { .. } => None,
    };
    Some((MotionEnd { moves, between: (low, high) }, equilibrium))
}
