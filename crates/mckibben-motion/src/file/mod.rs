//! Drive files: TOML in the muscle file's manner.

mod checks;
mod command;
mod liquid;
mod tables;
mod valve;

pub use tables::Tables;

use crate::drive::{Actuator, Supply, Target};
use crate::fluid::Fluid;
use crate::friction;
use crate::viscoelastic::{Branch, Prony};
use checks::{above, at, said};
use mckibben::load::{Load, LoadTable};
use mckibben::muscle::file::{FileError, Problem, Section, Source};
use mckibben::muscle::{Presliding, PreslidingElement};
use mckibben::units::{Dimension, Values};
use mckibben_io::table::read_load;
use std::collections::BTreeMap;
use std::fmt;

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
    /// Damper of a muscle's load in N s/m.
    pub damping_n_s_per_m: f64,
    /// Stops of a muscle's load: shortenings in mm.
    pub stops_mm: (f64, f64),
    /// How the friction of the braid builds up; as the muscle states it, where there is none.
    pub presliding: Option<Presliding>,
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
    "pump",
    "syringe",
    "air",
    "liquid",
    "load",
    "friction",
    "rubber",
    "command",
    "controller",
    "name",
    "notes",
];
const SUPPLY: &[&str] = &["pressure", "temperature"];
const LOAD: &[&str] = &["mass", "level", "line", "damping", "stops", "held"];
/// The stops of a load that has none.
const FREE_MM: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// Reads the text of a drive file.
///
/// ```
/// use mckibben::load::Load;
/// use mckibben_motion::{parse_drive, Subject, Tables};
/// let drive = parse_drive(
///     "muscle = 'muscle.toml'\n[valve]\nsonic_conductance = '0.5 L/(s bar)'\ncritical_ratio = 0.3\n\
///      [load]\nmass = '10 kg'\n[command]\npressure = [['0 s', '0 bar'], ['0.1 s', '3 bar']]\nuntil = '1 s'\n",
///     &Tables::default(),
/// )?;
/// assert_eq!(drive.subject, Subject::Muscle("muscle.toml".into()));
/// assert_eq!(drive.load, Some(Load::Mass { mass_kg: 10.0, level: false }));
/// # Ok::<(), mckibben::muscle::file::FileError>(())
/// ```
///
/// # Errors
/// [`FileError`] with line, column, key, what stood there and what is expected.
pub fn parse_drive(text: &str, tables: &Tables) -> Result<DriveFile, FileError> {
    read(text, None, tables)
}

impl DriveFile {
    /// A drive without load, with the defaults of a drive file.
    pub fn new(subject: Subject, actuator: Actuator, target: Target, until_s: f64) -> Self {
        Self {
            subject,
            supply: Supply::default(),
            actuator,
            fluid: Fluid::default(),
            load: None,
            held: None,
            damping_n_s_per_m: 0.0,
            stops_mm: FREE_MM,
            presliding: None,
            rubber: Prony::default(),
            target,
            until_s,
            output_step_s: until_s / 1000.0,
        }
    }

    /// The drive with another value at a dotted key of a drive file: a number, `true` or `false`, or else a text.
    pub fn with(&self, dotted: &str, value: &str, tables: &Tables) -> Result<Self, FileError> {
        read(&with_value("", dotted, value)?, Some(self), tables)
    }
}

/// A drive file; what it leaves out is as in `base`, where there is one.
fn read(text: &str, base: Option<&DriveFile>, tables: &Tables) -> Result<DriveFile, FileError> {
    let source = Source::parse(text)?;
    let root = source.root();
    root.only(TOP, TOP)?;
    for key in ["name", "notes"] {
        root.text(key, "a text in quotes")?;
    }
    let subject = base.map_or_else(|| subject(&root), |base| Ok(base.subject.clone()))?;
    let about_joint = matches!(subject, Subject::Joint(_));
    let supply =
        supply(&root.section("supply", "supply")?, base.map_or_else(Supply::default, |base| base.supply))?;
    let air = root.section("air", "air")?;
    let fluid = match liquid::liquid(&root.section("liquid", "liquid")?, supply.temperature_k)? {
        Some(_) if air.is_written() => return Err(said(&root, "air", "conflicts with [liquid]; keep one")),
        Some(liquid) => Fluid::Liquid(liquid),
        None => match base.map(|base| &base.fluid) {
            Some(liquid @ Fluid::Liquid(_)) if !air.is_written() => liquid.clone(),
            _ => Fluid::Air(valve::air(&air, supply.temperature_k)?),
        },
    };
    let actuator = valve::actuator(&root, base.map(|base| base.actuator), fluid.is_liquid())?;
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
    let prony = rubber.pairs("prony", (None, Some(Dimension::Time)), expected)?.map(|pairs| {
        Prony(pairs.into_iter().map(|(share, time_constant_s)| Branch { share, time_constant_s }).collect())
    });
    let command = root.section("command", "command")?;
    command.only(command::KEYS, command::KEYS)?;
    let until_s = above(&command, "until", Dimension::Time)?
        .or(base.map(|base| base.until_s))
        .ok_or_else(|| command.missing("until", None, "the end of the run, such as \"5 s\""))?;
    let output_step_s = above(&command, "output_step", Dimension::Time)?.unwrap_or(until_s / 1000.0);
    let controller = root.section("controller", "controller")?;
    let target = command::target(&command, &controller, about_joint, base.map(|base| &base.target), tables)?;
    Ok(DriveFile {
        subject,
        supply,
        actuator,
        fluid,
        load: line(&load, base, tables)?,
        held: held(&load, base)?,
        damping_n_s_per_m: load
            .quantity("damping", Dimension::Damping)?
            .unwrap_or(base.map_or(0.0, |base| base.damping_n_s_per_m)),
        stops_mm: stops(&load)?.or(base.map(|base| base.stops_mm)).unwrap_or(FREE_MM),
        presliding: presliding(&friction)?.or_else(|| base.and_then(|base| base.presliding.clone())),
        rubber: prony.unwrap_or_else(|| base.map_or_else(Prony::default, |base| base.rubber.clone())),
        target,
        until_s,
        output_step_s,
    })
}

/// The files that a drive file names, before they are there.
///
/// # Errors
/// [`FileError`] for a text that is not valid TOML, or moves nothing.
pub fn drive_names(text: &str) -> Result<Names, FileError> {
    let source = Source::parse(text)?;
    let root = source.root();
    let mut tables = vec![];
    let load = root.section("load", "load")?;
    if let Some(line) = load.text("line", LINE)? {
        tables.extend(Load::tables(line).map(str::to_owned));
    }
    tables.extend(command::tables(&root.section("command", "command")?)?);
    Ok(Names { subject: subject(&root)?, tables })
}

fn subject(root: &Section<'_>) -> Result<Subject, FileError> {
    let expected = "the path of a file, in quotes";
    match (root.text("muscle", expected)?, root.text("joint", expected)?) {
        (Some(muscle), None) => Ok(Subject::Muscle(muscle.into())),
        (None, Some(joint)) => Ok(Subject::Joint(joint.into())),
        (Some(_), Some(_)) => {
            Err(said(root, "joint", "conflicts with muscle: a drive moves one or the other"))
        }
        (None, None) if root.has("tube") || root.has("braid") => Err(root.missing(
            "muscle",
            None,
            "this is a muscle file, and a motion needs a drive file: one that names it (muscle = \"muscle.toml\") and has [load], [valve] and [command]; docs/motion.md describes it, examples/drive.toml is one",
        )),
        (None, None) => Err(root.missing("muscle", None, "what moves: a muscle or a joint")),
    }
}

/// The text of a drive file with another value at a dotted key: a number, `true` or `false`, or else a text.
///
/// # Errors
/// [`FileError`] for a text that is not valid TOML, or a key whose parents are no tables.
pub fn with_value(text: &str, dotted: &str, value: &str) -> Result<String, FileError> {
    // Errors of syntax with their places.
    let source = Source::parse(text)?;
    let wrong = |what: &str| source.error(dotted, Problem::Said(what.into()));
    let mut document: toml_edit::DocumentMut =
        text.parse().map_err(|_| wrong("is in a text that is not valid TOML"))?;
    let mut table: &mut dyn toml_edit::TableLike = document.as_table_mut();
    let (parents, last) = dotted.rsplit_once('.').unwrap_or(("", dotted));
    for part in parents.split('.').filter(|p| !p.is_empty()) {
        let item = table.entry(part).or_insert_with(toml_edit::table);
        table = item.as_table_like_mut().ok_or_else(|| wrong("is not a key of a table"))?;
    }
    let item = match (value.parse::<f64>(), value.parse::<bool>()) {
        (Ok(number), _) if number.is_finite() => toml_edit::value(number),
        (_, Ok(yes)) => toml_edit::value(yes),
        _ => toml_edit::value(value),
    };
    table.insert(last, item);
    Ok(document.to_string())
}

/// A length, or pairs of a share and a length.
fn presliding(section: &Section<'_>) -> Result<Option<Presliding>, FileError> {
    const KEY: &str = "presliding";
    if !section.is_list(KEY) {
        return Ok(above(section, KEY, Dimension::Length)?.map(Presliding::of));
    }
    let expected = "a length, or pairs of a share and a length, as in [[0.6, \"0.5 mm\"], [0.4, \"3 mm\"]]";
    let Some(pairs) = section.pairs(KEY, (None, Some(Dimension::Length)), expected)? else { return Ok(None) };
    let elements = pairs.into_iter().map(|(share, length_mm)| PreslidingElement { share, length_mm });
    let presliding = Presliding(elements.collect());
    at(section, KEY, friction::check(&presliding))?;
    Ok(Some(presliding))
}

fn supply(section: &Section<'_>, default: Supply) -> Result<Supply, FileError> {
    section.only(SUPPLY, SUPPLY)?;
    let celsius = section.quantity("temperature", Dimension::Temperature)?;
    if celsius.is_some_and(|t| t <= -273.15) {
        return Err(said(section, "temperature", "must be above absolute zero"));
    }
    Ok(Supply {
        pressure_mpa: above(section, "pressure", Dimension::Pressure)?.unwrap_or(default.pressure_mpa),
        temperature_k: celsius.map_or(default.temperature_k, |t| t + 273.15),
    })
}

const LINE: &str = "a load in quotes, such as \"spring:12N/mm@50N\"";

/// Mass and line as one load.
fn line(section: &Section<'_>, base: Option<&DriveFile>, tables: &Tables) -> Result<Option<Load>, FileError> {
    let level = section.boolean("level")? == Some(true);
    let mass = above(section, "mass", Dimension::Mass)?.map(|mass_kg| Load::Mass { mass_kg, level });
    let Some(text) = section.text("line", LINE)? else {
        return Ok(sum(mass, base.and_then(|base| base.load.clone())));
    };
    let mut read = BTreeMap::new();
    for name in Load::tables(text) {
        let Some(table) = tables.texts.get(name) else { continue };
        let said_of =
            |error: &dyn fmt::Display| said(section, "line", format!("is not a valid load: {name}: {error}"));
        let points = read_load(table.as_bytes(), tables.rest_length_mm).map_err(|e| said_of(&e))?;
        let table = LoadTable::new(points).map_err(|e| said_of(&e))?;
        read.insert(name, table);
    }
    let line = Load::parse(text, &|name| read.get(name).cloned())
        .map_err(|error| said(section, "line", format!("is not a valid load: {error}")))?;
    Ok(sum(mass, Some(line)))
}

fn sum(mass: Option<Load>, line: Option<Load>) -> Option<Load> {
    match (mass, line) {
        (Some(mass), Some(line)) => Some(Load::Sum(vec![mass, line])),
        (mass, line) => mass.or(line),
    }
}

/// The contraction at which both ends are held; it goes with no other key of the load.
fn held(section: &Section<'_>, base: Option<&DriveFile>) -> Result<Option<f64>, FileError> {
    let contraction = section.quantity("held", Dimension::Ratio)?.or(base.and_then(|base| base.held));
    let Some(contraction) = contraction else { return Ok(None) };
    let loaded = base.is_some_and(|base| base.load.is_some());
    let given = |key: &str| section.has(key) || loaded && key == "line";
    if let Some(key) = LOAD.iter().find(|key| **key != "held" && given(key)) {
        return Err(said(section, key, "conflicts with held: a muscle with fixed ends moves no load"));
    }
    if contraction.abs() >= 1.0 {
        return Err(said(section, "held", "must be a contraction below 1, such as \"10 %\""));
    }
    Ok(Some(contraction))
}

fn stops(section: &Section<'_>) -> Result<Option<(f64, f64)>, FileError> {
    match section.values("stops", Dimension::Length, "")? {
        None => Ok(None),
        Some((Values::Interval(low, high), _)) => Ok(Some((low, high))),
        Some(_) => Err(said(section, "stops", "must be two shortenings, as in \"0..80 mm\"")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::air::Heat;
    use crate::command::Command;
    use crate::liquid::Syringe;
    use crate::orifice::Orifice;

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
            &Tables::default(),
        )
        .unwrap();
        assert_eq!(drive.supply, Supply { pressure_mpa: 0.6, temperature_k: 293.15 });
        let Actuator::Valve(valve) = drive.actuator else { panic!() };
        assert_eq!(valve.supply, Orifice::new(0.5, 0.3).unwrap());
        let Fluid::Air(air) = &drive.fluid else { panic!() };
        assert_eq!((air.heat, air.dead_volume_mm3), (Heat::Transfer(25.0), 1e4));
        assert_eq!(drive.presliding, None);
        assert_eq!((drive.damping_n_s_per_m, drive.stops_mm), (400.0, (-5.0, 80.0)));
        assert_eq!(drive.target, Target::Pressure(vec![Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)])]));
        assert_eq!((drive.until_s, drive.output_step_s), (5.0, 0.005));
    }

    #[test]
    fn liquids_have_valves_pumps_and_syringes() {
        let read = |text: &str| {
            parse_drive(&format!("muscle = 'm.toml'\n[liquid]\nname = 'oil'\n{text}"), &Tables::default())
                .unwrap()
        };
        let drive = read(&format!(
            "gas_share = '1 %'\n[valve]\nflow_coefficient = '0.36 m3/h'\nhose_length = '1 m'\nhose_diameter = '4 mm'\n{TAIL}"
        ));
        let Fluid::Liquid(fill) = &drive.fluid else { panic!() };
        assert_eq!((fill.liquid.name.as_str(), fill.liquid.gas_share), ("oil", 0.01));
        // 0.36 m³/h is 0.1 L/s.
        let Actuator::LiquidValve(valve) = drive.actuator else { panic!() };
        assert!((valve.supply.kv_mm3_per_s() - 1e5).abs() < 1e-6 && valve.tank == valve.supply);
        assert!(valve.line.is_some());
        let wider = drive.with("valve.return_coefficient", "0.72 m3/h", &Tables::default());
        let Actuator::LiquidValve(wider) = wider.unwrap().actuator else { panic!() };
        assert!((wider.tank.kv_mm3_per_s() - 2e5).abs() < 1e-6 && wider.supply == valve.supply);
        let drive =
            read("[syringe]\nvolume = '20 mL'\n[command]\nvolume = 'ramp 0..15 mL in 2 s'\nuntil = '3 s'\n");
        assert_eq!(drive.actuator, Actuator::Syringe(Syringe { volume_mm3: 20e3, time_constant_s: 0.05 }));
        assert_eq!(drive.target, Target::Volume(vec![Command::Ramps(vec![(0.0, 0.0), (2.0, 15e3)])]));
    }

    #[test]
    fn a_key_over_a_drive_says_what_it_says_in_its_file() {
        let text =
            format!("{HEAD}[load]\nline = 'mass:10kg'\ndamping = '200 N s/m'\nstops = '0..80 mm'\n{TAIL}");
        let tables = Tables::default();
        let drive = parse_drive(&text, &tables).unwrap();
        for (key, value) in [
            ("valve.sonic_conductance", "0.2 L/(s bar)"),
            ("valve.critical_ratio", "0.4"),
            ("valve.exhaust_conductance", "1 L/(s bar)"),
            ("supply.pressure", "7 bar"),
            ("supply.temperature", "40 degC"),
            ("air.dead_volume", "100 cm3"),
            ("load.mass", "5"),
            ("load.line", "spring:2N/mm"),
            ("load.damping", "10 N s/m"),
            ("friction.presliding", "1 mm"),
            ("command.pressure", "2 bar"),
            ("command.until", "3 s"),
        ] {
            let by_file = with_value(&text, key, value).and_then(|text| parse_drive(&text, &tables));
            assert_eq!(drive.with(key, value, &tables).unwrap(), by_file.unwrap(), "{key}");
        }
        for (key, value) in [("load.held", "10 %"), ("valve.closed", "1"), ("supply.pressure", "0 bar")] {
            assert!(drive.with(key, value, &tables).is_err(), "{key}");
        }
    }

    #[test]
    fn files_say_where_they_are_wrong() {
        for (text, words) in [
            (format!("[valve]\nname = 'x'\n{TAIL}"), "muscle"),
            (format!("muscle = 'm.toml'\n{TAIL}"), "[regulator]"),
            (format!("{HEAD}[regulator]\ntime_constant = '20 ms'\n{TAIL}"), "conflicts with [valve]"),
            (format!("muscle = 'm.toml'\n[valve]\nsonic_conductance = '0 L/(s bar)'\n{TAIL}"), "above zero"),
            (format!("muscle = 'm.toml'\n[valve]\nname = 'festo-mh3'\n{TAIL}"), "festo-mh2"),
            (format!("{HEAD}critical_ratio = 1.5\n{TAIL}"), "critical"),
            (
                format!("{HEAD}[friction]\npresliding = [[0.6, '0.5 mm'], [0.3, '3 mm']]\n{TAIL}"),
                "sum of the shares",
            ),
            (format!("{HEAD}[friction]\npresliding = [[1, '0 mm']]\n{TAIL}"), "presliding length"),
            (format!("{HEAD}[friction]\npresliding = [1, 2]\n{TAIL}"), "pairs of a share and a length"),
            (format!("{HEAD}[air]\nheat = 'warm'\n{TAIL}"), "isothermal"),
            (format!("{HEAD}[command]\npressure = '3 bar'\n"), "until"),
            (format!("{HEAD}[command]\nuntil = '1 s'\n"), "what is commanded"),
            (
                format!("{HEAD}[command]\npressure = [['1 s', '1 bar'], ['0 s', '2 bar']]\nuntil = '1 s'\n"),
                "must increase",
            ),
            (format!("{HEAD}[command]\npressure = [['1 s']]\nuntil = '1 s'\n"), "pairs"),
            (format!("{HEAD}[command]\npressure = 'NaN bar'\nuntil = '1 s'\n"), "command"),
            (format!("{HEAD}[supply]\ntemperature = '-300 degC'\n{TAIL}"), "absolute zero"),
            (format!("{HEAD}hose_length = '1 m'\n{TAIL}"), "hose_diameter"),
            (format!("{HEAD}[command]\nposition = '10%'\nuntil = '1 s'\n"), "proportional"),
            (format!("{HEAD}[liquid]\nname = 'water'\n{TAIL}"), "flow_coefficient alone"),
            (format!("{HEAD}flow_coefficient = '0.1 m3/h'\n{TAIL}"), "no [liquid]"),
            (
                format!("muscle = 'm.toml'\n[liquid]\nname = 'beer'\n[pump]\nflow = '1 L/min'\n{TAIL}"),
                "glycol",
            ),
            (
                format!("muscle = 'm.toml'\n[liquid]\nname = 'oil'\n[air]\nheat = 'adiabatic'\n{TAIL}"),
                "keep one",
            ),
            (
                format!("muscle = 'm.toml'\n[pump]\nflow = '1 L/min'\n[syringe]\nvolume = '1 mL'\n{TAIL}"),
                "keep one",
            ),
            (format!("muscle = 'm.toml'\n[liquid]\nname = 'oil'\n[pump]\n{TAIL}"), "largest flow"),
            ("joint = 'j.toml'\n[valve]\nname = 'festo-mh2'\n[load]\nmass = '1 kg'\n".into(), "own file"),
        ] {
            let error = parse_drive(&text, &Tables::default())
                .map(|_| String::new())
                .unwrap_or_else(|e| e.to_string());
            assert!(error.contains(words), "{text}: {error}");
        }
    }
}
