//! [command] and [controller].

use super::Tables;
use crate::command::Command;
use crate::control::{Pid, PidOutput};
use crate::drive::Target;
use mckibben::muscle::file::{FileError, OVER_TIME, Section};
use mckibben::units::{Dimension, Values, parse_quantity, parse_values};
use mckibben_io::table::{OverTime, read_over_time};

/// The tables that commands name.
pub(super) fn tables(command: &Section<'_>) -> Vec<String> {
    let all = ["pressure", "valve", "volume"]
        .into_iter()
        .flat_map(keys)
        .chain(["position".into()]);
    let texts = all.filter_map(|key| command.get::<&str>(&key));
    texts
        .filter_map(|text| Some(text.trim().strip_prefix(TABLE)?.trim().to_owned()))
        .collect()
}

/// A key for all muscles, and one for each.
fn keys(key: &str) -> [String; 3] {
    [key.to_owned(), format!("{key}_1"), format!("{key}_2")]
}

pub(super) fn target(
    command: &Section<'_>,
    pid: &Section<'_>,
    about_joint: bool,
    tables: &Tables,
) -> Result<Target, FileError> {
    let each = |key: &str, what: OverTime| -> Result<Option<Vec<Command>>, FileError> {
        let [all, first, second] = keys(key).map(|key| read_command(command, &key, what, tables));
        match (all?, first?, second?) {
            (Some(all), None, None) if about_joint => Ok(Some(vec![all.clone(), all])),
            (Some(all), None, None) => Ok(Some(vec![all])),
            (None, Some(first), second) => Ok(Some(std::iter::once(first).chain(second).collect())),
            (None, None, None) => Ok(None),
            _ => Err(command.error(key, format!("conflicts with {key}_1 and {key}_2"))),
        }
    };
    let what = if about_joint {
        OverTime::Angle
    } else {
        OverTime::Contraction
    };
    let position = read_command(command, "position", what, tables)?.map(|position| {
        let position = if about_joint {
            position.scaled(std::f64::consts::PI / 180.0)
        } else {
            position
        };
        Ok(Target::Position {
            command: position,
            pid: controller(pid)?,
        })
    });
    let targets = [
        each("pressure", OverTime::Pressure)?.map(Target::Pressure),
        each("valve", OverTime::Opening)?.map(Target::Opening),
        each("volume", OverTime::Volume)?.map(Target::Volume),
        position.transpose()?,
    ];
    let mut given = targets.into_iter().flatten();
    match (given.next(), given.next()) {
        (Some(target), None) => Ok(target),
        (None, _) => {
            let expected = "what is commanded: pressure, valve (its opening), volume (of a \
                syringe) or position";
            Err(command.missing("pressure", None, expected))
        }
        _ => Err(command.error(
            "until",
            "belongs to one command: give pressure, valve, volume or position",
        )),
    }
}

fn controller(section: &Section<'_>) -> Result<Pid, FileError> {
    let number = |key: &str, default: f64| section.get(key).unwrap_or(default);
    let needs = "the controller's gain, in MPa (or opening) per unit of position";
    let proportional = section.get("proportional");
    Ok(Pid {
        proportional: proportional.ok_or_else(|| section.missing("proportional", None, needs))?,
        integral_per_s: number("integral", 0.0),
        derivative_s: number("derivative", 0.0),
        filter_s: number("filter", 0.01),
        tracking_s: number("tracking", 0.1),
        output: match section.get("output") {
            Some("opening") => PidOutput::Opening,
            _ => PidOutput::Pressure {
                bias_mpa: number("bias", 0.0),
            },
        },
    })
}

/// Before the name of a table of times and values.
const TABLE: &str = "table:";

/// Pairs of times and values (steps), or a text: a table (joined by straight lines), a value,
/// `ramp 0..3 bar in 2 s`, `sine 1..3 bar at 2 Hz`, `chirp 1..3 bar from 0.1..5 Hz in 10 s`.
fn read_command(
    section: &Section<'_>,
    key: &str,
    what: OverTime,
    tables: &Tables,
) -> Result<Option<Command>, FileError> {
    let dimension = match what {
        OverTime::Pressure => Dimension::Pressure,
        OverTime::Volume => Dimension::Volume,
        OverTime::Opening | OverTime::Contraction => Dimension::Ratio,
        OverTime::Angle => Dimension::Angle,
    };
    let command = if let Some(text) = section.get::<&str>(key) {
        if let Some(name) = text.trim().strip_prefix(TABLE) {
            let wrong = |why: String| section.error(key, format!("names {}, {why}", name.trim()));
            let invalid = |e: String| wrong(format!("which is not valid: {e}"));
            let table = tables.texts.get(name.trim());
            let table = table.ok_or_else(|| wrong("which was not supplied".into()))?;
            let points = read_over_time(table, what, tables.rest_length_mm)
                .map_err(|e| invalid(e.to_string()))?;
            return Command::table(points)
                .map(Some)
                .map_err(|e| invalid(e.to_string()));
        }
        spoken(text, dimension)
            .ok_or_else(|| section.error(key, format!("is not a command; write {OVER_TIME}")))?
    } else {
        let Some(pairs) = section.get(key) else {
            return Ok(None);
        };
        Command::Steps(pairs)
    };
    command
        .check()
        .map_err(|error| section.error(key, error.to_string()))?;
    Ok(Some(command))
}

fn spoken(text: &str, dimension: Dimension) -> Option<Command> {
    let range = |text: &str, dimension| match parse_values(text.trim(), dimension).ok()? {
        Values::Interval(low, high) => Some((low, high)),
        Values::List(_) => None,
    };
    let swing = |text: &str| {
        range(text, dimension).map(|(low, high)| (0.5 * (low + high), 0.5 * (high - low)))
    };
    let one = |text: &str, dimension| parse_quantity(text, dimension).ok();
    let text = text.trim();
    let (word, rest) = text.split_once(' ').unwrap_or(("", text));
    match word {
        "ramp" => {
            let (values, time) = rest.split_once(" in ")?;
            let (from, to) = range(values, dimension)?;
            Some(Command::Ramps(vec![
                (0.0, from),
                (one(time, Dimension::Time)?, to),
            ]))
        }
        "sine" => {
            let (values, frequency) = rest.split_once(" at ")?;
            let (mean, amplitude) = swing(values)?;
            let frequency_hz = one(frequency, Dimension::Frequency)?;
            Some(Command::Sine {
                mean,
                amplitude,
                frequency_hz,
                phase_rad: -std::f64::consts::FRAC_PI_2,
            })
        }
        "chirp" => {
            let (values, rest) = rest.split_once(" from ")?;
            let (frequencies, time) = rest.split_once(" in ")?;
            let (mean, amplitude) = swing(values)?;
            let (from_hz, to_hz) = range(frequencies, Dimension::Frequency)?;
            Some(Command::Chirp {
                mean,
                amplitude,
                from_hz,
                to_hz,
                duration_s: one(time, Dimension::Time)?,
            })
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
        assert_eq!(
            read("ramp 0..3 bar in 2 s"),
            Some(Command::Ramps(vec![(0.0, 0.0), (2.0, 0.3)]))
        );
        let Some(Command::Sine {
            mean,
            amplitude,
            frequency_hz,
            ..
        }) = read("sine 1..3 bar at 2 Hz")
        else {
            panic!()
        };
        assert!(
            (mean - 0.2).abs() < 1e-12 && (amplitude - 0.1).abs() < 1e-12 && frequency_hz == 2.0
        );
        assert!(read("chirp 1..3 bar from 0.1..5 Hz in 10 s").is_some());
        assert_eq!(read("3 bar"), Some(Command::Constant(0.3)));
        assert_eq!(read("saw 1..3 bar"), None);
    }
}
