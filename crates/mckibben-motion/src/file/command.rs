//! [command] and [controller].

use super::checks::{above, said};
use super::tables::Tables;
use crate::command::Command;
use crate::control::{Pid, PidOutput};
use crate::drive::Target;
use mckibben::muscle::file::{FileError, Section};
use mckibben::units::{Dimension, Values, parse_quantity, parse_values};
use mckibben_io::table::{OverTime, read_over_time};

/// Keys of [command].
pub(super) const KEYS: &[&str] = &[
    "pressure",
    "pressure_1",
    "pressure_2",
    "valve",
    "valve_1",
    "valve_2",
    "volume",
    "volume_1",
    "volume_2",
    "position",
    "until",
    "output_step",
];
const CONTROLLER: &[&str] =
    &["proportional", "integral", "derivative", "filter", "tracking", "output", "bias"];

/// The tables that commands name.
pub(super) fn tables(command: &Section<'_>) -> Result<Vec<String>, FileError> {
    let mut names = vec![];
    for key in KEYS.iter().filter(|key| command.is_text(key)) {
        let name = command.text(key, "a command")?.and_then(|text| text.trim().strip_prefix(TABLE));
        names.extend(name.map(|name| name.trim().to_owned()));
    }
    Ok(names)
}

pub(super) fn target(
    command: &Section<'_>,
    pid: &Section<'_>,
    about_joint: bool,
    base: Option<&Target>,
    tables: &Tables,
) -> Result<Target, FileError> {
    pid.only(CONTROLLER, CONTROLLER)?;
    let each = |key: &str, what: OverTime| -> Result<Vec<Command>, FileError> {
        let keys = [key.to_owned(), format!("{key}_1"), format!("{key}_2")];
        let read = keys.iter().map(|key| read_command(command, key, what, tables));
        let [all, first, second]: [Option<Command>; 3] =
            read.collect::<Result<Vec<_>, _>>()?.try_into().unwrap_or_default();
        match (all, first, second) {
            (Some(all), None, None) if about_joint => Ok(vec![all.clone(), all]),
            (Some(all), None, None) => Ok(vec![all]),
            (None, Some(first), second) => Ok(std::iter::once(first).chain(second).collect()),
            (None, None, None) => Ok(vec![]),
            _ => Err(said(command, key, format!("conflicts with {key}_1 and {key}_2"))),
        }
    };
    let pressures = each("pressure", OverTime::Pressure)?;
    let openings = each("valve", OverTime::Opening)?;
    let volumes = each("volume", OverTime::Volume)?;
    let what = if about_joint { OverTime::Angle } else { OverTime::Contraction };
    let position = read_command(command, "position", what, tables)?;
    let given = [!pressures.is_empty(), !openings.is_empty(), !volumes.is_empty(), position.is_some()];
    match (given, position) {
        ([true, false, false, false], _) => Ok(Target::Pressure(pressures)),
        ([false, true, false, false], _) => Ok(Target::Opening(openings)),
        ([false, false, true, false], _) => Ok(Target::Volume(volumes)),
        ([false, false, false, true], Some(position)) => {
            let position = if about_joint { position.scaled(std::f64::consts::PI / 180.0) } else { position };
            Ok(Target::Position { command: position, pid: controller(pid)? })
        }
        ([false, false, false, false], _) => base.cloned().ok_or_else(|| {
            let expected =
                "what is commanded: pressure, valve (its opening), volume (of a syringe) or position";
            command.missing("pressure", None, expected)
        }),
        _ => Err(said(command, "until", "belongs to one command: give pressure, valve, volume or position")),
    }
}

fn controller(section: &Section<'_>) -> Result<Pid, FileError> {
    let number = |key: &str, default: f64| Ok::<f64, FileError>(section.number(key)?.unwrap_or(default));
    let time = |key: &str, default: f64| {
        Ok::<f64, FileError>(above(section, key, Dimension::Time)?.unwrap_or(default))
    };
    let Some(proportional) = section.number("proportional")? else {
        return Err(section.missing(
            "proportional",
            None,
            "the controller's gain, in MPa (or opening) per unit of position",
        ));
    };
    let output = match section.text("output", "pressure or opening, in quotes")?.unwrap_or("pressure") {
        "pressure" => {
            PidOutput::Pressure { bias_mpa: section.quantity("bias", Dimension::Pressure)?.unwrap_or(0.0) }
        }
        "opening" => PidOutput::Opening,
        _ => return Err(said(section, "output", "must be \"pressure\" or \"opening\"")),
    };
    Ok(Pid {
        proportional,
        integral_per_s: number("integral", 0.0)?,
        derivative_s: number("derivative", 0.0)?,
        filter_s: time("filter", 0.01)?,
        tracking_s: time("tracking", 0.1)?,
        output,
    })
}

/// Before the name of a table of times and values.
const TABLE: &str = "table:";

/// Pairs of times and values (steps), or a text: a table (joined by straight lines), a value, `ramp 0..3 bar in 2 s`, `sine 1..3 bar at 2 Hz`,
/// `chirp 1..3 bar from 0.1..5 Hz in 10 s`.
fn read_command(
    section: &Section<'_>,
    key: &str,
    what: OverTime,
    tables: &Tables,
) -> Result<Option<Command>, FileError> {
    let dimension = match what {
        OverTime::Pressure => Some(Dimension::Pressure),
        OverTime::Volume => Some(Dimension::Volume),
        OverTime::Opening => None,
        OverTime::Contraction => Some(Dimension::Ratio),
        OverTime::Angle => Some(Dimension::Angle),
    };
    let expected = "pairs of times and values such as [[\"0 s\", \"0 bar\"], [\"0.1 s\", \"3 bar\"]], or \"ramp 0..3 bar in 2 s\", \"sine 1..3 bar at 2 Hz\", \"chirp 1..3 bar from 0.1..5 Hz in 10 s\", \"table:command.csv\"";
    let command = if section.is_text(key) {
        let Some(text) = section.text(key, expected)? else { return Ok(None) };
        if let Some(name) = text.trim().strip_prefix(TABLE) {
            let wrong = |why: String| said(section, key, format!("names {}, {why}", name.trim()));
            let table =
                tables.texts.get(name.trim()).ok_or_else(|| wrong("which was not supplied".into()))?;
            let points = read_over_time(table.as_bytes(), what)
                .map_err(|e| wrong(format!("which is not valid: {e}")))?;
            return Command::table(points).map(Some).map_err(|e| wrong(format!("which is not valid: {e}")));
        }
        spoken(text, dimension.unwrap_or(Dimension::Ratio))
            .ok_or_else(|| said(section, key, format!("is not a command; write {expected}")))?
    } else {
        match section.pairs(key, (Some(Dimension::Time), dimension), expected)? {
            None => return Ok(None),
            Some(pairs) => Command::Steps(pairs),
        }
    };
    command.check().map_err(|error| said(section, key, error.to_string()))?;
    Ok(Some(command))
}

fn spoken(text: &str, dimension: Dimension) -> Option<Command> {
    let range = |text: &str, dimension| match parse_values(text.trim(), dimension).ok()? {
        Values::Interval(low, high) => Some((low, high)),
        Values::List(_) => None,
    };
    let one = |text: &str, dimension| parse_quantity(text, dimension).ok();
    let text = text.trim();
    let (word, rest) = text.split_once(' ').unwrap_or(("", text));
    match word {
        "ramp" => {
            let (values, time) = rest.split_once(" in ")?;
            let (from, to) = range(values, dimension)?;
            Some(Command::Ramps(vec![(0.0, from), (one(time, Dimension::Time)?, to)]))
        }
        "sine" => {
            let (values, frequency) = rest.split_once(" at ")?;
            let (low, high) = range(values, dimension)?;
            Some(Command::Sine {
                mean: 0.5 * (low + high),
                amplitude: 0.5 * (high - low),
                frequency_hz: one(frequency, Dimension::Frequency)?,
                phase_rad: -std::f64::consts::FRAC_PI_2,
            })
        }
        "chirp" => {
            let (values, rest) = rest.split_once(" from ")?;
            let (frequencies, time) = rest.split_once(" in ")?;
            let ((low, high), (from_hz, to_hz)) =
                (range(values, dimension)?, range(frequencies, Dimension::Frequency)?);
            let (mean, amplitude) = (0.5 * (low + high), 0.5 * (high - low));
            Some(Command::Chirp { mean, amplitude, from_hz, to_hz, duration_s: one(time, Dimension::Time)? })
        }
        _ => one(text, dimension).map(Command::Constant),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_spoken() {
        let read = |text: &str| spoken(text, Dimension::Pressure);
        assert_eq!(read("ramp 0..3 bar in 2 s"), Some(Command::Ramps(vec![(0.0, 0.0), (2.0, 0.3)])));
        let Some(Command::Sine { mean, amplitude, frequency_hz, .. }) = read("sine 1..3 bar at 2 Hz") else {
            panic!()
        };
        assert!((mean - 0.2).abs() < 1e-12 && (amplitude - 0.1).abs() < 1e-12 && frequency_hz == 2.0);
        assert!(read("chirp 1..3 bar from 0.1..5 Hz in 10 s").is_some());
        assert_eq!(read("3 bar"), Some(Command::Constant(0.3)));
        assert_eq!(read("saw 1..3 bar"), None);
    }
}
