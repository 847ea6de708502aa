//! Drive files: TOML in the muscle file's manner.

mod command;
mod keys;
mod liquid;
mod valve;

use crate::{
    command::Command,
    drive::{Actuator, Commanded, Supply},
    fluid::Fluid,
    viscoelastic::Prony,
};
use command::Commands;
pub use keys::DriveKeys;
use keys::{OfLoad, OfSupply};
use mckibben_core::{
    load::{Load, LoadTable},
    muscle::file::{FileError, Keys, Source, with_keys},
    units::{
        Dimension,
        typed::{Angle, Quantity, Ratio},
    },
};
use mckibben_io::table::read_load;
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use std::{collections::BTreeMap, f64::consts::PI};

/// What moves: its file, relative to the drive file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Subject {
    /// A muscle file.
    Muscle(String),
    /// A joint file.
    Joint(String),
}

/// The files that a drive file names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Names {
    /// What moves.
    pub subject: Subject,
    /// Tables of its load and its commands.
    pub tables: Vec<String>,
}

/// What a drive file names beside its muscle or joint.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tables {
    /// The text of every table (`table:NAME`) by its name.
    pub texts: BTreeMap<String, String>,
    /// L0 of the muscle in mm, for a load over contractions.
    pub rest_length_mm: f64,
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
    /// What fills it.
    pub fluid: Fluid,
    /// The load of a muscle.
    pub load: Option<Load>,
    /// The contraction at which both ends of a muscle are held, in place of a load.
    pub held: Option<f64>,
    /// The contraction, or the angle in rad, from which it is released at rest, in place of its
    /// equilibrium.
    pub start: Option<f64>,
    /// Gauge pressures of the muscles at the start in MPa; else what the first command says.
    pub start_mpa: Vec<f64>,
    /// A force or torque from outside ([`Drive::external`](crate::Drive::external)).
    pub external: Command,
    /// Damper of a muscle's load in N s/m.
    pub damping_n_s_per_m: f64,
    /// Stops of a muscle's load: shortenings in mm.
    pub stops_mm: (f64, f64),
    /// C of the friction in N/MPa^β; that of the muscle, where there is none.
    pub friction_coefficient: Option<f64>,
    /// Presliding length of the friction in mm, likewise.
    pub presliding_mm: Option<f64>,
    /// Viscoelasticity of the rubber.
    pub rubber: Prony,
    /// What is commanded.
    pub target: Commanded,
    /// The end in s.
    pub until_s: f64,
    /// Time between two points of the series in s; a thousandth of the run where it is not given.
    pub output_step_s: f64,
}

/// Reads the text of a drive file.
///
/// ```
/// use mckibben_core::load::Load;
/// use mckibben_motion::{parse_drive, Subject, Tables};
/// let drive = parse_drive(
///     "muscle = 'muscle.toml'\n[valve]\nsonic_conductance = '0.5 L/(s bar)'\ncritical_ratio = 0.3\n\
///      [load]\nmass = '10 kg'\n[command]\npressure = [['0 s', '0 bar'], ['0.1 s', '3 bar']]\nuntil = '1 s'\n",
///     &Tables::default(),
/// )?;
/// assert_eq!(drive.subject, Subject::Muscle("muscle.toml".into()));
/// assert_eq!(drive.load, Some(Load::Mass { mass_kg: 10.0, level: false }));
/// # Ok::<(), mckibben_core::muscle::file::FileError>(())
/// ```
///
/// # Errors
/// [`FileError`] with line, column, key, what stood there and what is expected.
pub fn parse_drive(text: &str, tables: &Tables) -> Result<DriveFile, FileError> {
    let source = Source::parse(text)?;
    match subject(&source)? {
        subject @ Subject::Muscle(_) => drive::<Ratio>(&source, tables, subject, 1.0),
        subject => drive::<Angle>(&source, tables, subject, PI / 180.0),
    }
}

/// A drive whose positions are in a unit of rad or of a contraction of 1.
fn drive<P>(
    source: &Source<'_>,
    tables: &Tables,
    subject: Subject,
    unit: f64,
) -> Result<DriveFile, FileError>
where
    P: Quantity + DeserializeOwned + JsonSchema,
{
    let mut keys: DriveKeys<P> = source.read()?;
    let about_joint = matches!(subject, Subject::Joint(_));
    let supply = supply(&keys.supply, source)?;
    let fluid = match &keys.liquid {
        Some(_) if keys.air.is_some() => {
            return Err(source.error("air", "conflicts with [liquid]; keep one"));
        }
        Some(liquid) => Fluid::Liquid(liquid::liquid(liquid, source, supply.temperature_k)?),
        None => {
            let air = keys.air.take().unwrap_or_default();
            Fluid::Air(valve::air(&air, source, supply.temperature_k)?)
        }
    };
    if about_joint && keys.load.is_some() {
        return Err(source.error(
            "load",
            "a joint carries its load in its own file ([link], [spring])",
        ));
    }
    let actuator = valve::actuator(&keys, source, fluid.is_liquid())?;
    let load = keys.load.unwrap_or_default();
    let held = held_contraction(&load, keys.start.is_some(), source)?;
    let (start, start_mpa) = keys.start.map_or_else(Default::default, |start| {
        (
            start.position.map(|position| unit * position.into()),
            start.pressures.into_iter().map(f64::from).collect(),
        )
    });
    let until_s = keys.command.until.into();
    let output_step = keys.command.output_step;
    let commands = Commands {
        source,
        tables,
        about_joint,
        unit,
    };
    Ok(DriveFile {
        subject,
        supply,
        actuator,
        fluid,
        load: line(&load, source, tables)?,
        held,
        start,
        start_mpa,
        external: commands.external(keys.external)?,
        damping_n_s_per_m: load.damping.unwrap_or_default().0,
        stops_mm: load
            .stops
            .map_or((f64::NEG_INFINITY, f64::INFINITY), |stops| {
                (stops.low.0, stops.high.0)
            }),
        friction_coefficient: keys.friction.coefficient.map(f64::from),
        presliding_mm: keys.friction.presliding.map(f64::from),
        rubber: Prony(keys.rubber.prony.branches),
        target: commands.target(keys.command, keys.controller)?,
        until_s,
        output_step_s: output_step.map_or(until_s / 1000.0, f64::from),
    })
}

/// The files that a drive file names, before they are there.
///
/// # Errors
/// [`FileError`] for a text that is not valid TOML, or moves nothing.
pub fn drive_names(text: &str) -> Result<Names, FileError> {
    let source = Source::parse(text)?;
    let of_load = source.texts("load").flat_map(Load::tables);
    let of_commands = ["command", "external"]
        .map(|table| source.texts(table))
        .into_iter()
        .flatten()
        .filter_map(command::table_named);
    Ok(Names {
        subject: subject(&source)?,
        tables: of_load.chain(of_commands).map(str::to_owned).collect(),
    })
}

/// What a drive file moves.
fn subject(source: &Source<'_>) -> Result<Subject, FileError> {
    let missing = |why: &str| Err(source.error("", format!("muscle is missing; {why}")));
    match (source.text_at("muscle"), source.text_at("joint")) {
        (Some(muscle), None) => Ok(Subject::Muscle(muscle.to_owned())),
        (None, Some(joint)) => Ok(Subject::Joint(joint.to_owned())),
        (Some(_), Some(_)) => Err(source.error(
            "joint",
            "conflicts with muscle: a drive moves one or the other",
        )),
        (None, None) if source.has("tube") || source.has("braid") => missing(
            "this is a muscle file, and a motion needs a drive file: one that names it (muscle = \
             \"muscle.toml\") and has [load], [valve] and [command]; docs/motion.md describes it, \
             examples/drive.toml is one",
        ),
        (None, None) => missing("what moves: a muscle or a joint"),
    }
}

/// The text of a drive file with another value at a dotted key: a number, `true` or `false`, or
/// else a text.
///
/// # Errors
/// [`FileError`] for a text that is not valid TOML, or a key whose parents are no tables.
pub fn with_value(text: &str, dotted: &str, value: &str) -> Result<String, FileError> {
    with_keys(text, &[format!("{dotted}={value}")])
}

/// The dimension of the number at a dotted key of a drive file, and the number in the unit used
/// inside, where it is written.
///
/// # Errors
/// [`FileError`] for a text that is no drive file, or a key that has no number.
pub fn number_at(text: &str, dotted: &str) -> Result<(Dimension, Option<f64>), FileError> {
    drive_names(text)?;
    let source = Source::parse(text)?;
    let is_in_table = dotted.contains('.') && !dotted.starts_with("command.");
    let dimension = Keys::of::<DriveKeys>()
        .dimension(dotted)
        .filter(|_| is_in_table)
        .ok_or_else(|| {
            source.error(
                dotted,
                "is not a number of a drive file; one is valve.sonic_conductance",
            )
        })?;
    Ok((dimension, source.number(dotted, dimension)))
}

fn supply(keys: &OfSupply, source: &Source<'_>) -> Result<Supply, FileError> {
    let default = Supply::default();
    if keys.temperature.is_some_and(|t| t.0 <= -273.15) {
        return Err(source.error("supply.temperature", "must be above absolute zero"));
    }
    Ok(Supply {
        pressure_mpa: keys.pressure.map_or(default.pressure_mpa, f64::from),
        temperature_k: keys
            .temperature
            .map_or(default.temperature_k, |t| t.0 + 273.15),
    })
}

/// Mass and line as one load.
fn line(keys: &OfLoad, source: &Source<'_>, tables: &Tables) -> Result<Option<Load>, FileError> {
    let mass = keys.mass.map(|mass| Load::Mass {
        mass_kg: mass.into(),
        level: keys.level.unwrap_or_default(),
    });
    let Some(text) = &keys.line else {
        return Ok(mass);
    };
    let wrong = |error: String| source.error("load.line", format!("is not a valid load: {error}"));
    let mut read = BTreeMap::new();
    for name in Load::tables(text) {
        let Some(table) = tables.texts.get(name) else {
            continue;
        };
        let points = read_load(table, tables.rest_length_mm)
            .map_err(|error| wrong(format!("{name}: {error}")))?;
        let table = LoadTable::new(points).map_err(|error| wrong(format!("{name}: {error}")))?;
        read.insert(name, table);
    }
    let line = Load::parse(text, &|name| read.get(name).cloned())
        .map_err(|error| wrong(error.to_string()))?;
    Ok(Some(match mass {
        Some(mass) => Load::Sum(vec![mass, line]),
        None => line,
    }))
}

/// The contraction at which both ends are held; it goes with no other key of the load, nor with a start.
fn held_contraction(
    keys: &OfLoad,
    is_started: bool,
    source: &Source<'_>,
) -> Result<Option<f64>, FileError> {
    let Some(Ratio(contraction)) = keys.held else {
        return Ok(None);
    };
    let alone = OfLoad {
        held: keys.held,
        ..OfLoad::default()
    };
    if is_started || *keys != alone {
        return Err(source.error(
            "load.held",
            "conflicts with [start] and other keys of [load]",
        ));
    }
    if contraction.abs() >= 1.0 {
        return Err(source.error(
            "load.held",
            "must be a contraction below 1, such as \"10 %\"",
        ));
    }
    Ok(Some(contraction))
}
