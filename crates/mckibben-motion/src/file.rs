//! Drive files: TOML in the muscle file's manner.

use crate::air::{Air, Heat};
use crate::catalogue::{valve_named, valves};
use crate::command::Command;
use crate::control::{Pid, PidOutput};
use crate::drive::{Actuator, Supply, Target};
use crate::error::MotionError;
use crate::hose::Hose;
use crate::valve::{Orifice, Valve, ValveKind};
use crate::viscoelastic::{Branch, Prony};
use mckibben::muscle::file::{FileError, Problem, Section, Source};
use mckibben::nearest::nearest;
use mckibben::units::{Dimension, Values, parse_quantity, parse_values};

/// What moves: its file, relative to the drive file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Subject {
    /// A muscle file.
    Muscle(String),
    /// A joint file.
    Joint(String),
}

/// A drive file: everything but the muscle or joint itself.
#[derive(Debug, Clone, PartialEq)]
pub struct DriveFile {
    /// What moves.
    pub subject: Subject,
    /// Where the air comes from.
    pub supply: Supply,
    /// What gives each muscle its air.
    pub actuator: Actuator,
    /// Its air.
    pub air: Air,
    /// The load of a muscle, as [`mckibben::load::Load::parse`] reads it.
    pub load: Option<String>,
    /// Damper of a muscle's load in N s/m.
    pub damping_n_s_per_m: f64,
    /// Stops of a muscle's load: shortenings in mm.
    pub stops_mm: (f64, f64),
    /// Presliding length of the braid's friction in mm.
    pub presliding_mm: f64,
    /// Viscoelasticity of the rubber.
    pub rubber: Prony,
    /// What is commanded.
    pub target: Target,
    /// The end in s.
    pub until_s: f64,
    /// Time between two points of the series in s; a thousandth of the run where it is not said.
    pub output_step_s: f64,
}

const TOP: &[&str] = &[
    "muscle",
    "joint",
    "supply",
    "valve",
    "regulator",
    "air",
    "load",
    "friction",
    "rubber",
    "command",
    "controller",
    "name",
    "notes",
];
const SUPPLY: &[&str] = &["pressure", "temperature"];
const VALVE: &[&str] = &[
    "name",
    "kind",
    "sonic_conductance",
    "critical_ratio",
    "exhaust_conductance",
    "exhaust_critical_ratio",
    "lag",
    "wide_open_at",
    "hysteresis",
    "closed_centre",
    "hose_length",
    "hose_diameter",
];
const AIR: &[&str] = &["dead_volume", "heat", "polytropic_index"];
const LOAD: &[&str] = &["mass", "level", "line", "damping", "stops"];
const COMMAND: &[&str] = &[
    "pressure",
    "pressure_1",
    "pressure_2",
    "valve",
    "valve_1",
    "valve_2",
    "position",
    "until",
    "output_step",
];
const CONTROLLER: &[&str] =
    &["proportional", "integral", "derivative", "filter", "tracking", "output", "bias"];

/// Where the command of a pressure opens a proportional valve wide, in MPa, and half of an on–off valve's dead band.
const WIDE_OPEN_MPA: f64 = 0.05;
const HYSTERESIS_MPA: f64 = 0.005;
/// Presliding length in mm where none is said.
const PRESLIDING_MM: f64 = 0.5;

/// Reads the text of a drive file.
///
/// ```
/// use mckibben_motion::{parse_drive, Subject};
/// let drive = parse_drive(
///     "muscle = 'muscle.toml'\n[valve]\nsonic_conductance = '0.5 L/(s bar)'\ncritical_ratio = 0.3\n\
///      [load]\nmass = '10 kg'\n[command]\npressure = [['0 s', '0 bar'], ['0.1 s', '3 bar']]\nuntil = '1 s'\n",
/// )?;
/// assert_eq!(drive.subject, Subject::Muscle("muscle.toml".into()));
/// assert_eq!(drive.load.as_deref(), Some("mass:10kg"));
/// # Ok::<(), mckibben::muscle::file::FileError>(())
/// ```
///
/// # Errors
/// [`FileError`] with line, column, key, what stood there and what is expected.
pub fn parse_drive(text: &str) -> Result<DriveFile, FileError> {
    let source = Source::parse(text)?;
    let root = source.root();
    root.only(TOP, TOP)?;
    for key in ["name", "notes"] {
        root.text(key, "a text in quotes")?;
    }
    let expected = "the path of a file, in quotes";
    let subject = match (root.text("muscle", expected)?, root.text("joint", expected)?) {
        (Some(muscle), None) => Subject::Muscle(muscle.into()),
        (None, Some(joint)) => Subject::Joint(joint.into()),
        (Some(_), Some(_)) => {
            return Err(said(&root, "joint", "stands beside a muscle: a drive moves one or the other"));
        }
        (None, None) => return Err(root.missing("muscle", None, "what moves: a muscle or a joint")),
    };
    let about_joint = matches!(subject, Subject::Joint(_));
    let supply = supply(&root.section("supply", "supply")?)?;
    let actuator = actuator(&root)?;
    let air = air(&root.section("air", "air")?, supply.temperature_k)?;
    let load = root.section("load", "load")?;
    load.only(LOAD, LOAD)?;
    if about_joint && load.is_written() {
        return Err(said(&root, "load", "a joint carries its load in its own file ([link], [spring])"));
    }
    let friction = root.section("friction", "friction")?;
    friction.only(&["presliding"], &["friction.presliding"])?;
    let rubber = root.section("rubber", "rubber")?;
    rubber.only(&["prony"], &["rubber.prony"])?;
    let expected = "pairs of a share and a time, as in [[0.1, \"50 ms\"]]";
    let prony = rubber.pairs("prony", (None, Some(Dimension::Time)), expected)?.unwrap_or_default();
    let command = root.section("command", "command")?;
    command.only(COMMAND, COMMAND)?;
    let until_s = above(&command, "until", Dimension::Time)?
        .ok_or_else(|| command.missing("until", None, "the end of the run, such as \"5 s\""))?;
    let output_step_s = above(&command, "output_step", Dimension::Time)?.unwrap_or(until_s / 1000.0);
    let target = target(&command, &root.section("controller", "controller")?, about_joint)?;
    Ok(DriveFile {
        subject,
        supply,
        actuator,
        air,
        load: line(&load)?,
        damping_n_s_per_m: load.quantity("damping", Dimension::Damping)?.unwrap_or(0.0),
        stops_mm: stops(&load)?,
        presliding_mm: above(&friction, "presliding", Dimension::Length)?.unwrap_or(PRESLIDING_MM),
        rubber: Prony(
            prony.into_iter().map(|(share, time_constant_s)| Branch { share, time_constant_s }).collect(),
        ),
        target,
        until_s,
        output_step_s,
    })
}

/// The text of a drive file with another value at a dotted key: a number, `true` or `false`, or else a text.
///
/// # Errors
/// [`FileError`] for a text that is no TOML, or a key whose parents are no tables.
pub fn with_value(text: &str, dotted: &str, value: &str) -> Result<String, FileError> {
    // Errors of syntax with their places.
    let source = Source::parse(text)?;
    let wrong = |what: &str| source.error(dotted, Problem::Said(what.into()));
    let mut document: toml_edit::DocumentMut = text.parse().map_err(|_| wrong("stands in no TOML"))?;
    let mut table: &mut dyn toml_edit::TableLike = document.as_table_mut();
    let (parents, last) = dotted.rsplit_once('.').unwrap_or(("", dotted));
    for part in parents.split('.').filter(|p| !p.is_empty()) {
        let item = table.entry(part).or_insert_with(toml_edit::table);
        table = item.as_table_like_mut().ok_or_else(|| wrong("is no key of a table"))?;
    }
    let item = match (value.parse::<f64>(), value.parse::<bool>()) {
        (Ok(number), _) if number.is_finite() => toml_edit::value(number),
        (_, Ok(yes)) => toml_edit::value(yes),
        _ => toml_edit::value(value),
    };
    table.insert(last, item);
    Ok(document.to_string())
}

fn said(section: &Section<'_>, key: &str, text: impl Into<String>) -> FileError {
    section.error(key, Problem::Said(text.into()))
}

/// A quantity above zero.
fn above(section: &Section<'_>, key: &str, dimension: Dimension) -> Result<Option<f64>, FileError> {
    match section.quantity(key, dimension)? {
        Some(value) if value <= 0.0 => Err(said(section, key, "must be above zero")),
        value => Ok(value),
    }
}

/// What the crate itself says of a number, at its key.
fn at<T>(section: &Section<'_>, key: &str, result: Result<T, MotionError>) -> Result<T, FileError> {
    result.map_err(|error| said(section, key, format!("makes no sense: {error}")))
}

fn supply(section: &Section<'_>) -> Result<Supply, FileError> {
    section.only(SUPPLY, SUPPLY)?;
    let default = Supply::default();
    let celsius = section.quantity("temperature", Dimension::Temperature)?;
    if celsius.is_some_and(|t| t <= -273.15) {
        return Err(said(section, "temperature", "must be above absolute zero"));
    }
    Ok(Supply {
        pressure_mpa: above(section, "pressure", Dimension::Pressure)?.unwrap_or(default.pressure_mpa),
        temperature_k: celsius.map_or(default.temperature_k, |t| t + 273.15),
    })
}

fn actuator(root: &Section<'_>) -> Result<Actuator, FileError> {
    let (valve, regulator) = (root.section("valve", "valve")?, root.section("regulator", "regulator")?);
    match (valve.is_written(), regulator.is_written()) {
        (true, false) => Ok(Actuator::Valve(read_valve(&valve)?)),
        (false, true) => {
            regulator.only(&["time_constant"], &["regulator.time_constant"])?;
            let time_constant_s = above(&regulator, "time_constant", Dimension::Time)?.ok_or_else(|| {
                regulator.missing("time_constant", None, "how fast it follows, such as \"20 ms\"")
            })?;
            Ok(Actuator::Regulator { time_constant_s })
        }
        (true, true) => Err(said(root, "regulator", "stands beside a valve: give one of them")),
        (false, false) => Err(root.missing("valve", None, "a [valve] or a [regulator] that gives the air")),
    }
}

fn read_valve(section: &Section<'_>) -> Result<Valve, FileError> {
    section.only(VALVE, VALVE)?;
    let named = match section.text("name", "the name of a valve, in quotes")? {
        None => None,
        Some(name) => Some(valve_named(name).ok_or_else(|| {
            let all: Vec<&str> = valves().iter().map(|v| v.name.as_str()).collect();
            let near = nearest(name, all.iter().copied());
            let near = near.map_or_else(String::new, |n| format!("did you mean {n}? "));
            said(section, "name", format!("is no valve that is known: {near}there are {}", all.join(", ")))
        })?),
    };
    let path = |c: &str, b: &str, own: Option<Orifice>| -> Result<Option<Orifice>, FileError> {
        let conductance = above(section, c, Dimension::Conductance)?;
        let ratio = section.number(b)?;
        let base = own.map(|o| (o.conductance_l_per_s_bar(), o.critical_ratio()));
        let Some(conductance) = conductance.or(base.map(|o| o.0)) else { return Ok(None) };
        let ratio = ratio.or(base.map(|o| o.1)).unwrap_or(0.3);
        let key = if section.has(b) { b } else { c };
        at(section, key, Orifice::new(conductance, ratio)).map(Some)
    };
    let supply = path("sonic_conductance", "critical_ratio", named.map(|v| v.supply))?.ok_or_else(|| {
        section.missing("sonic_conductance", None, "the valve's C, such as \"0.5 L/(s bar)\", or a name")
    })?;
    let own = named.filter(|_| !section.has("sonic_conductance")).map_or(supply, |v| v.exhaust);
    let exhaust = path("exhaust_conductance", "exhaust_critical_ratio", Some(own))?.unwrap_or(supply);
    let kind = match section.text("kind", "proportional or on-off, in quotes")?.unwrap_or("proportional") {
        "proportional" => ValveKind::Proportional {
            time_constant_s: section.quantity("lag", Dimension::Time)?.unwrap_or(0.0),
            gain_per_mpa: 1.0 / above(section, "wide_open_at", Dimension::Pressure)?.unwrap_or(WIDE_OPEN_MPA),
        },
        "on-off" => ValveKind::OnOff {
            hysteresis_mpa: above(section, "hysteresis", Dimension::Pressure)?.unwrap_or(HYSTERESIS_MPA),
            closed_centre: section.boolean("closed_centre")?.unwrap_or(true),
        },
        _ => return Err(said(section, "kind", "must be \"proportional\" or \"on-off\"")),
    };
    let length = above(section, "hose_length", Dimension::Length)?;
    let hose = match (above(section, "hose_diameter", Dimension::Length)?, length) {
        (Some(d), Some(l)) => Some(at(section, "hose_length", Hose::new(d, l))?),
        (None, None) => None,
        (Some(_), None) => {
            return Err(section.missing("hose_length", Some("hose_diameter"), "the hose's length"));
        }
        (None, Some(_)) => {
            return Err(section.missing("hose_diameter", Some("hose_length"), "the hose's inner diameter"));
        }
    };
    Ok(Valve { kind, supply, exhaust, hose })
}

fn air(section: &Section<'_>, wall_temperature_k: f64) -> Result<Air, FileError> {
    section.only(AIR, AIR)?;
    let expected = "\"isothermal\", \"adiabatic\", or a coefficient such as \"25 W/(m2 K)\" or \"0.3 W/K\"";
    let heat = match section.text("heat", expected)?.map(str::trim) {
        None | Some("isothermal") => Heat::Isothermal,
        Some("adiabatic") => Heat::Adiabatic,
        Some(text) => {
            let number = |unit: &str| text.strip_suffix(unit).and_then(|t| t.trim().parse::<f64>().ok());
            let of_area = ["W/(m2 K)", "W/(m² K)", "W/m2/K", "W/(m^2 K)"].into_iter().find_map(number);
            match (of_area, number("W/K")) {
                (Some(h), _) if h >= 0.0 => Heat::Transfer(h),
                (None, Some(h)) if h >= 0.0 => Heat::Conductance(h),
                _ => return Err(said(section, "heat", format!("must be {expected}"))),
            }
        }
    };
    let heat = match section.number("polytropic_index")? {
        None => heat,
        Some(_) if section.has("heat") => {
            return Err(said(section, "polytropic_index", "stands beside heat: give one of them"));
        }
        Some(n) if (1.0..=1.4).contains(&n) => Heat::Polytropic(n),
        Some(_) => return Err(said(section, "polytropic_index", "must be from 1 to 1.4")),
    };
    let dead_volume_mm3 = section.quantity("dead_volume", Dimension::Volume)?.unwrap_or(0.0);
    Ok(Air { heat, wall_temperature_k, dead_volume_mm3 })
}

/// Mass and line as one load.
fn line(section: &Section<'_>) -> Result<Option<String>, FileError> {
    let line = section.text("line", "a load in quotes, such as \"spring:12N/mm@50N\"")?;
    let level = if section.boolean("level")? == Some(true) { "@level" } else { "" };
    let mass = above(section, "mass", Dimension::Mass)?.map(|kg| format!("mass:{kg}kg{level}"));
    let parts: Vec<String> = mass.into_iter().chain(line.map(str::to_owned)).collect();
    Ok((!parts.is_empty()).then(|| parts.join("+")))
}

fn stops(section: &Section<'_>) -> Result<(f64, f64), FileError> {
    match section.values("stops", Dimension::Length, "")? {
        None => Ok((f64::NEG_INFINITY, f64::INFINITY)),
        Some((Values::Interval(low, high), _)) => Ok((low, high)),
        Some(_) => Err(said(section, "stops", "must be two shortenings, as in \"0..80 mm\"")),
    }
}

fn target(command: &Section<'_>, pid: &Section<'_>, about_joint: bool) -> Result<Target, FileError> {
    pid.only(CONTROLLER, CONTROLLER)?;
    let each = |key: &str, dimension: Option<Dimension>| -> Result<Vec<Command>, FileError> {
        let keys = [key.to_owned(), format!("{key}_1"), format!("{key}_2")];
        let read = keys.iter().map(|key| read_command(command, key, dimension));
        let [all, first, second]: [Option<Command>; 3] =
            read.collect::<Result<Vec<_>, _>>()?.try_into().unwrap_or_default();
        match (all, first, second) {
            (Some(all), None, None) if about_joint => Ok(vec![all.clone(), all]),
            (Some(all), None, None) => Ok(vec![all]),
            (None, Some(first), second) => Ok(std::iter::once(first).chain(second).collect()),
            (None, None, None) => Ok(vec![]),
            _ => Err(said(command, key, format!("stands beside {key}_1 or {key}_2"))),
        }
    };
    let pressures = each("pressure", Some(Dimension::Pressure))?;
    let openings = each("valve", None)?;
    let dimension = if about_joint { Dimension::Angle } else { Dimension::Ratio };
    let position = read_command(command, "position", Some(dimension))?;
    match (pressures.is_empty(), openings.is_empty(), position) {
        (false, true, None) => Ok(Target::Pressure(pressures)),
        (true, false, None) => Ok(Target::Opening(openings)),
        (true, true, Some(position)) => {
            let position = if about_joint { position.scaled(std::f64::consts::PI / 180.0) } else { position };
            Ok(Target::Position { command: position, pid: controller(pid)? })
        }
        (true, true, None) => Err(command.missing(
            "pressure",
            None,
            "what is commanded: pressure, valve (its opening) or position",
        )),
        _ => Err(said(command, "until", "belongs to one command: give pressure, valve or position")),
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

/// Pairs of times and values (steps), or a text: a value, `ramp 0..3 bar in 2 s`, `sine 1..3 bar at 2 Hz`,
/// `chirp 1..3 bar from 0.1..5 Hz in 10 s`.
fn read_command(
    section: &Section<'_>,
    key: &str,
    dimension: Option<Dimension>,
) -> Result<Option<Command>, FileError> {
    let expected = "pairs of times and values such as [[\"0 s\", \"0 bar\"], [\"0.1 s\", \"3 bar\"]], or \"ramp 0..3 bar in 2 s\", \"sine 1..3 bar at 2 Hz\", \"chirp 1..3 bar from 0.1..5 Hz in 10 s\"";
    let command = if section.is_text(key) {
        let Some(text) = section.text(key, expected)? else { return Ok(None) };
        spoken(text, dimension.unwrap_or(Dimension::Ratio))
            .ok_or_else(|| said(section, key, format!("is no command; write {expected}")))?
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

    const HEAD: &str = "muscle = 'm.toml'\n[valve]\nsonic_conductance = '0.5 L/(s bar)'\n";
    const TAIL: &str = "[command]\npressure = '3 bar'\nuntil = '1 s'\n";

    #[test]
    fn the_file_of_the_contract_is_read() {
        let drive = parse_drive(
            "muscle = \"muscle.toml\"\n[supply]\npressure = \"6 bar\"\ntemperature = \"20 degC\"\n\
             [valve]\nsonic_conductance = \"0.5 L/(s bar)\"\ncritical_ratio = 0.3\n\
             [air]\ndead_volume = \"10 cm3\"\nheat = \"25 W/(m2 K)\"\n\
             [load]\nmass = \"10 kg\"\ndamping = \"400 N s/m\"\nstops = \"-5..80 mm\"\n\
             [command]\npressure = [[\"0 s\", \"0 bar\"], [\"0.1 s\", \"3 bar\"]]\nuntil = \"5 s\"\n",
        )
        .unwrap();
        assert_eq!(drive.supply, Supply { pressure_mpa: 0.6, temperature_k: 293.15 });
        let Actuator::Valve(valve) = drive.actuator else { panic!() };
        assert_eq!(valve.supply, Orifice::new(0.5, 0.3).unwrap());
        assert_eq!((drive.air.heat, drive.air.dead_volume_mm3), (Heat::Transfer(25.0), 1e4));
        assert_eq!((drive.damping_n_s_per_m, drive.stops_mm), (400.0, (-5.0, 80.0)));
        assert_eq!(drive.target, Target::Pressure(vec![Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)])]));
        assert_eq!((drive.until_s, drive.output_step_s), (5.0, 0.005));
    }

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

    #[test]
    fn files_say_where_they_are_wrong() {
        for (text, words) in [
            (format!("[valve]\nname = 'x'\n{TAIL}"), "muscle"),
            (format!("muscle = 'm.toml'\n{TAIL}"), "[regulator]"),
            (format!("{HEAD}[regulator]\ntime_constant = '20 ms'\n{TAIL}"), "beside a valve"),
            (format!("muscle = 'm.toml'\n[valve]\nsonic_conductance = '0 L/(s bar)'\n{TAIL}"), "above zero"),
            (format!("muscle = 'm.toml'\n[valve]\nname = 'festo-mh3'\n{TAIL}"), "festo-mh2"),
            (format!("{HEAD}critical_ratio = 1.5\n{TAIL}"), "critical"),
            (format!("{HEAD}[air]\nheat = 'warm'\n{TAIL}"), "isothermal"),
            (format!("{HEAD}[command]\npressure = '3 bar'\n"), "until"),
            (format!("{HEAD}[command]\nuntil = '1 s'\n"), "what is commanded"),
            (
                format!("{HEAD}[command]\npressure = [['1 s', '1 bar'], ['0 s', '2 bar']]\nuntil = '1 s'\n"),
                "must grow",
            ),
            (format!("{HEAD}[command]\npressure = [['1 s']]\nuntil = '1 s'\n"), "pairs"),
            (format!("{HEAD}[command]\npressure = 'NaN bar'\nuntil = '1 s'\n"), "command"),
            (format!("{HEAD}[supply]\ntemperature = '-300 degC'\n{TAIL}"), "absolute zero"),
            (format!("{HEAD}hose_length = '1 m'\n{TAIL}"), "hose_diameter"),
            (format!("{HEAD}[command]\nposition = '10%'\nuntil = '1 s'\n"), "proportional"),
            ("joint = 'j.toml'\n[valve]\nname = 'festo-mh2'\n[load]\nmass = '1 kg'\n".into(), "own file"),
        ] {
            let error = parse_drive(&text).map(|_| String::new()).unwrap_or_else(|e| e.to_string());
            assert!(error.contains(words), "{text}: {error}");
        }
    }
}
