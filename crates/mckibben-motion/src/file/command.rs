//! [command] and [controller].

use super::{
    Tables,
    keys::{Gain, OfCommand, OfController, OfExternal, Output},
};
use crate::{
    command::Command,
    control::{Pid, PidOutput},
    drive::Commanded,
};
use mckibben_core::{
    muscle::file::{FileError, Source},
    units::{
        Dimension, Values, parse_quantity, parse_values,
        typed::{Quantity, Time},
    },
};
use mckibben_io::table::{OverTime, read_over_time};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, de::Error};
use serde_json::Value;

/// What a command over time is, for messages.
const OVER_TIME: &str = "pairs of times and values such as [[\"0 s\", \"0 bar\"], [\"0.1 \
    s\", \"3 bar\"]], or \"ramp 0..3 bar in 2 s\", \"sine 1..3 bar at 2 Hz\", \"chirp 1..3 bar \
    from 0.1..5 Hz in 10 s\", \"table:command.csv\"";

/// A value over time, as it is written.
#[derive(JsonSchema)]
#[schemars(untagged)]
pub enum Course<Q> {
    /// A value, "ramp 0..3 bar in 2 s", "sine 1..3 bar at 2 Hz",
    /// "chirp 1..3 bar from 0.1..5 Hz in 10 s" or "table:command.csv"
    Said(String),
    /// A value in MPa, mm³, degrees, or a ratio
    Number(f64),
    /// Values from their times on, in pairs such as [["0 s", "0 bar"], ["0.1 s", "3 bar"]]
    Pairs(Vec<(Time, Q)>),
}

impl<'de, Q: Deserialize<'de>> Deserialize<'de> for Course<Q> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        match Value::deserialize(from)? {
            Value::String(text) => Ok(Self::Said(text)),
            Value::Number(number) => Ok(Self::Number(number.as_f64().unwrap_or(f64::NAN))),
            pairs if pairs.is_array() => Vec::deserialize(pairs)
                .map(Self::Pairs)
                .map_err(Error::custom),
            other => Err(Error::custom(format!("is {other}, expected {OVER_TIME}"))),
        }
    }
}

/// The table that a text names.
pub fn table_named(text: &str) -> Option<&str> {
    text.trim().strip_prefix("table:").map(str::trim)
}

/// The file and its tables, for the commands in it.
pub struct Commands<'s> {
    pub source: &'s Source<'s>,
    pub tables: &'s Tables,
    pub about_joint: bool,
    /// Of positions, in rad or as a contraction.
    pub unit: f64,
}

impl Commands<'_> {
    pub fn target<P: Quantity>(
        &self,
        keys: OfCommand<P>,
        controller: Option<OfController>,
    ) -> Result<Commanded, FileError> {
        let what = if self.about_joint {
            OverTime::Angle
        } else {
            OverTime::Contraction
        };
        let position = keys.position.map(|position| {
            Ok(Commanded::Position {
                command: self
                    .read(position, "command.position", what)?
                    .scaled(self.unit),
                pid: self.pid(controller)?,
            })
        });
        let pressures = [keys.pressure, keys.pressure_1, keys.pressure_2];
        let valves = [keys.valve, keys.valve_1, keys.valve_2];
        let volumes = [keys.volume, keys.volume_1, keys.volume_2];
        let targets = [
            self.commands(pressures, "command.pressure", OverTime::Pressure)?
                .map(Commanded::Pressure),
            self.commands(valves, "command.valve", OverTime::Opening)?
                .map(Commanded::Opening),
            self.commands(volumes, "command.volume", OverTime::Volume)?
                .map(Commanded::Volume),
            position.transpose()?,
        ];
        let mut given = targets.into_iter().flatten();
        match (given.next(), given.next()) {
            (Some(target), None) => Ok(target),
            (None, _) => Err(self.source.missing(
                "command.pressure",
                "command",
                "what is commanded: pressure, valve (its opening), volume (of a \
                    syringe) or position",
            )),
            _ => Err(self.source.error(
                "command.until",
                "belongs to one command: give pressure, valve, volume or position",
            )),
        }
    }

    /// A command for all muscles, or one for each.
    fn commands<Q: Quantity>(
        &self,
        [all, first, second]: [Option<Course<Q>>; 3],
        key: &str,
        what: OverTime,
    ) -> Result<Option<Vec<Command>>, FileError> {
        let read = |course: Option<Course<Q>>, end: &str| {
            let key = format!("{key}{end}");
            course
                .map(|course| self.read(course, &key, what))
                .transpose()
        };
        match (read(all, "")?, read(first, "_1")?, read(second, "_2")?) {
            (Some(all), None, None) if self.about_joint => Ok(Some(vec![all.clone(), all])),
            (Some(all), None, None) => Ok(Some(vec![all])),
            (None, Some(first), second) => Ok(Some(std::iter::once(first).chain(second).collect())),
            (None, None, None) => Ok(None),
            _ => {
                let name = key.rsplit('.').next().unwrap_or(key);
                Err(self
                    .source
                    .error(key, format!("conflicts with {name}_1 and {name}_2")))
            }
        }
    }

    /// The force or torque from outside, as it opposes growing q.
    pub fn external(&self, keys: OfExternal) -> Result<Command, FileError> {
        match (keys.force, keys.torque, self.about_joint) {
            (None, None, _) => Ok(Command::Constant(0.0)),
            (Some(force), None, false) => self.read(force, "external.force", OverTime::Force),
            (None, Some(torque), true) => Ok(self
                .read(torque, "external.torque", OverTime::Torque)?
                .scaled(-1e3)),
            _ => Err(self.source.error(
                "external",
                "is a `force` on a muscle, or a `torque` on a joint",
            )),
        }
    }

    fn pid(&self, keys: Option<OfController>) -> Result<Pid, FileError> {
        let keys = keys.ok_or_else(|| {
            self.source.missing(
                "controller.proportional",
                "controller",
                "the controller's gain, in MPa (or opening) per unit of position",
            )
        })?;
        let is_opening = keys.output == Some(Output::Opening);
        let gain = |gain, key, units| self.gain(gain, key, is_opening, units);
        Ok(Pid {
            proportional: gain(Some(keys.proportional), "proportional", ["", "/rad"])?,
            integral_per_s: gain(keys.integral, "integral", ["/s", "/(rad s)"])?,
            derivative_s: gain(keys.derivative, "derivative", [" s", " s/rad"])?,
            filter_s: keys.filter.map_or(0.01, f64::from),
            tracking_s: keys.tracking.map_or(0.1, f64::from),
            output: if is_opening {
                PidOutput::Opening
            } else {
                PidOutput::Pressure {
                    bias_mpa: keys.bias.0,
                }
            },
        })
    }

    /// In MPa and one of two units: a muscle's, a joint's. The gain of an opening is a number.
    fn gain(
        &self,
        gain: Option<Gain>,
        key: &str,
        is_opening: bool,
        units: [&str; 2],
    ) -> Result<f64, FileError> {
        let text = match gain {
            None => return Ok(0.0),
            Some(Gain::Number(number)) => return Ok(number),
            Some(Gain::Said(text)) => text,
        };
        let unit = units[usize::from(self.about_joint)];
        let number = text.trim().strip_suffix(unit).filter(|_| !is_opening);
        let value = number.and_then(|n| parse_quantity(n, Dimension::Pressure).ok());
        value.ok_or_else(|| {
            let said = format!("is no gain; write \"0.5 MPa{unit}\", or of an opening a number");
            self.source.error(&format!("controller.{key}"), said)
        })
    }

    /// Pairs of times and values (steps), or a text: a table (joined by straight lines), a value,
    /// `ramp 0..3 bar in 2 s`, `sine 1..3 bar at 2 Hz`, `chirp 1..3 bar from 0.1..5 Hz in 10 s`.
    fn read<Q: Quantity>(
        &self,
        course: Course<Q>,
        key: &str,
        what: OverTime,
    ) -> Result<Command, FileError> {
        let wrong = |said: String| self.source.error(key, said);
        if let Course::Said(text) = &course
            && let Some(name) = table_named(text)
        {
            let invalid = |e: String| wrong(format!("names {name}, which is not valid: {e}"));
            let table = self
                .tables
                .texts
                .get(name)
                .ok_or_else(|| wrong(format!("names {name}, which was not supplied")))?;
            let points = read_over_time(table, what, self.tables.rest_length_mm)
                .map_err(|e| invalid(e.to_string()))?;
            return Command::table(points).map_err(|e| invalid(e.to_string()));
        }
        let command = match course {
            Course::Said(text) => spoken(&text, Q::DIMENSION)
                .ok_or_else(|| wrong(format!("is not a command; write {OVER_TIME}")))?,
            Course::Number(number) => Command::Constant(number),
            Course::Pairs(pairs) => {
                Command::Steps(pairs.into_iter().map(|(t, v)| (t.0, v.into())).collect())
            }
        };
        command.check().map_err(|error| wrong(error.to_string()))?;
        Ok(command)
    }
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
            Some(Command::Sine {
                mean,
                amplitude,
                frequency_hz: one(frequency, Dimension::Frequency)?,
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
