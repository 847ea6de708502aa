//! Drive files: TOML in the muscle file's manner.

mod command;
mod liquid;
mod valve;

use crate::drive::{Actuator, Supply, Target};
use crate::fluid::Fluid;
use crate::viscoelastic::Prony;
use mckibben::load::{Load, LoadTable};
use mckibben::muscle::file::{FileError, Section, Source, dimension, keys};
use mckibben::units::Dimension;
use mckibben_io::table::read_load;
use std::collections::BTreeMap;

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
    /// The contraction from which the load of a muscle is released at rest, in place of its
    /// equilibrium.
    pub start: Option<f64>,
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
    pub target: Target,
    /// The end in s.
    pub until_s: f64,
    /// Time between two points of the series in s; a thousandth of the run where it is not given.
    pub output_step_s: f64,
}

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
    let (source, subject) = source(text)?;
    let about_joint = matches!(subject, Subject::Joint(_));
    let root = source.root();
    let supply = supply(&root.at("supply"))?;
    let air = root.at("air");
    let fluid = match liquid::liquid(&root.at("liquid"), supply.temperature_k)? {
        Some(_) if air.is_written() => {
            return Err(root.error("air", "conflicts with [liquid]; keep one"));
        }
        Some(liquid) => Fluid::Liquid(liquid),
        None => Fluid::Air(valve::air(&air, supply.temperature_k)?),
    };
    let load = root.at("load");
    if about_joint && load.is_written() {
        let said = "a joint carries its load in its own file ([link], [spring])";
        return Err(root.error("load", said));
    }
    let prony: mckibben::rubber::over_time::Prony =
        root.at("rubber").get("prony").unwrap_or_default();
    let command = root.at("command");
    let until_s = command.get("until").unwrap_or_default();
    Ok(DriveFile {
        subject,
        supply,
        actuator: valve::actuator(&root, fluid.is_liquid())?,
        fluid,
        load: line(&load, tables)?,
        held: held(&load)?,
        start: load.get("start"),
        damping_n_s_per_m: load.get("damping").unwrap_or(0.0),
        stops_mm: load
            .get("stops")
            .unwrap_or((f64::NEG_INFINITY, f64::INFINITY)),
        friction_coefficient: root.at("friction").get("coefficient"),
        presliding_mm: root.at("friction").get("presliding"),
        rubber: Prony(prony.branches),
        target: command::target(&command, &root.at("controller"), about_joint, tables)?,
        until_s,
        output_step_s: command.get("output_step").unwrap_or(until_s / 1000.0),
    })
}

/// The files that a drive file names, before they are there.
///
/// # Errors
/// [`FileError`] for a text that is not valid TOML, or moves nothing.
pub fn drive_names(text: &str) -> Result<Names, FileError> {
    let (source, subject) = source(text)?;
    let root = source.root();
    let line = root.at("load").get("line").map(Load::tables);
    let load = line.into_iter().flatten().map(str::to_owned);
    Ok(Names {
        subject,
        tables: load.chain(command::tables(&root.at("command"))).collect(),
    })
}

/// The file, and what it moves.
fn source(text: &str) -> Result<(Source<'_>, Subject), FileError> {
    let source = Source::parse(text)?;
    let missing = |why: &str| Err(source.error("", format!("muscle is missing; {why}")));
    let kind = match (source.has("muscle"), source.has("joint")) {
        (true, false) => "drive-of-muscle",
        (false, true) => "drive-of-joint",
        (true, true) => {
            return Err(source.error(
                "joint",
                "conflicts with muscle: a drive moves one or the other",
            ));
        }
        (false, false) if source.has("tube") || source.has("braid") => {
            return missing(
                "this is a muscle file, and a motion needs a drive file: one that names it (muscle \
                 = \"muscle.toml\") and has [load], [valve] and [command]; docs/motion.md \
                 describes it, examples/drive.toml is one",
            );
        }
        (false, false) => return missing("what moves: a muscle or a joint"),
    };
    let source = source.checked(&format!("drive-file {kind} people"))?;
    let root = source.root();
    let joint = root.get("joint").map(Subject::Joint);
    let subject = joint.unwrap_or_else(|| Subject::Muscle(root.get("muscle").unwrap_or_default()));
    Ok((source, subject))
}

/// The text of a drive file with another value at a dotted key: a number, `true` or `false`, or
/// else a text.
///
/// # Errors
/// [`FileError`] for a text that is not valid TOML, or a key whose parents are no tables.
pub fn with_value(text: &str, dotted: &str, value: &str) -> Result<String, FileError> {
    // Errors of syntax with their places.
    let source = Source::parse(text)?;
    let wrong = |what: &str| source.error(dotted, what);
    let mut document: toml_edit::DocumentMut = text
        .parse()
        .map_err(|_| wrong("is in a text that is not valid TOML"))?;
    let mut table: &mut dyn toml_edit::TableLike = document.as_table_mut();
    let (parents, last) = dotted.rsplit_once('.').unwrap_or(("", dotted));
    for part in parents.split('.').filter(|p| !p.is_empty()) {
        let item = table.entry(part).or_insert_with(toml_edit::table);
        table = item
            .as_table_like_mut()
            .ok_or_else(|| wrong("is not a key of a table"))?;
    }
    let item = match (value.parse::<f64>(), value.parse::<bool>()) {
        (Ok(number), _) if number.is_finite() => toml_edit::value(number),
        (_, Ok(yes)) => toml_edit::value(yes),
        _ => toml_edit::value(value),
    };
    table.insert(last, item);
    Ok(document.to_string())
}

/// The dimension of the number at a dotted key of a drive file, and the number in the unit used
/// inside, where it is written.
///
/// # Errors
/// [`FileError`] for a text that is no drive file, or a key that has no number.
pub fn number_at(text: &str, dotted: &str) -> Result<(Dimension, Option<f64>), FileError> {
    let (source, _) = source(text)?;
    let (table, name) = dotted.split_once('.').unwrap_or(("", dotted));
    let tables = keys("drive-file");
    let inside = tables
        .iter()
        .find(|key| key.name == table)
        .and_then(|key| key.table(None));
    let key = inside.into_iter().flatten().find(|key| key.name == name);
    let dimension = key.and_then(|key| match key.kind.rsplit(' ').next()? {
        "number" => Some(Dimension::Ratio),
        word => dimension(word),
    });
    let dimension = dimension.ok_or_else(|| {
        source.error(
            dotted,
            "is not a number of a drive file; one is valve.sonic_conductance",
        )
    })?;
    Ok((dimension, source.root().at(table).get(name)))
}

fn supply(section: &Section<'_>) -> Result<Supply, FileError> {
    let default = Supply::default();
    let celsius: Option<f64> = section.get("temperature");
    if celsius.is_some_and(|t| t <= -273.15) {
        return Err(section.error("temperature", "must be above absolute zero"));
    }
    Ok(Supply {
        pressure_mpa: section.get("pressure").unwrap_or(default.pressure_mpa),
        temperature_k: celsius.map_or(default.temperature_k, |t| t + 273.15),
    })
}

/// Mass and line as one load.
fn line(section: &Section<'_>, tables: &Tables) -> Result<Option<Load>, FileError> {
    let level = section.get("level").unwrap_or(false);
    let mass = section
        .get("mass")
        .map(|mass_kg| Load::Mass { mass_kg, level });
    let Some(text) = section.get::<&str>("line") else {
        return Ok(mass);
    };
    let wrong = |error: String| section.error("line", format!("is not a valid load: {error}"));
    let mut read = BTreeMap::new();
    for name in Load::tables(text) {
        let Some(table) = tables.texts.get(name) else {
            continue;
        };
        let points = read_load(table, tables.rest_length_mm);
        let points = points.map_err(|error| wrong(format!("{name}: {error}")))?;
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

/// The contraction at which both ends are held; it goes with no other key of the load.
fn held(section: &Section<'_>) -> Result<Option<f64>, FileError> {
    let Some(contraction) = section.get::<f64>("held") else {
        return Ok(None);
    };
    let mut others = ["mass", "level", "line", "damping", "stops", "start"].into_iter();
    if let Some(key) = others.find(|key| section.has(key)) {
        return Err(section.error(
            key,
            "conflicts with held: a muscle with fixed ends moves no load",
        ));
    }
    if contraction.abs() >= 1.0 {
        return Err(section.error("held", "must be a contraction below 1, such as \"10 %\""));
    }
    Ok(Some(contraction))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::air::Heat;
    use crate::command::Command;
    use crate::liquid::Syringe;
    use crate::orifice::Orifice;

    const MUSCLE: &str = "muscle = 'm.toml'\n";
    const HEAD: &str = "muscle = 'm.toml'\n[valve]\nsonic_conductance = '0.5 L/(s bar)'\n";
    const TAIL: &str = "[command]\npressure = '3 bar'\nuntil = '1 s'\n";

    #[test]
    fn the_file_of_the_contract_is_read() {
        let drive = parse_drive(
            "muscle = \"muscle.toml\"\n[supply]\npressure = \"6 bar\"\ntemperature = \"20 degC\"\n\
             [valve]\nsonic_conductance = \"0.5 L/(s bar)\"\ncritical_ratio = 0.3\n\
             [air]\ndead_volume = \"10 cm3\"\nheat = \"25 W/(m2 K)\"\n\
             [load]\nmass = \"10 kg\"\ndamping = \"400 N s/m\"\nstops = \"-5..80 mm\"\n\
             [command]\npressure = [[\"0 s\", \"0 bar\"], [\"0.1 s\", \"3 bar\"]]\nuntil = \"5 \
             s\"\n",
            &Tables::default(),
        )
        .unwrap();
        assert_eq!(
            drive.supply,
            Supply {
                pressure_mpa: 0.6,
                temperature_k: 293.15
            }
        );
        let Actuator::Valve(valve) = drive.actuator else {
            panic!()
        };
        assert_eq!(valve.supply, Orifice::new(0.5, 0.3).unwrap());
        let Fluid::Air(air) = &drive.fluid else {
            panic!()
        };
        assert_eq!((air.heat, air.dead_volume_mm3), (Heat::Transfer(25.0), 1e4));
        assert_eq!(drive.presliding_mm, None);
        assert_eq!(
            (drive.damping_n_s_per_m, drive.stops_mm),
            (400.0, (-5.0, 80.0))
        );
        assert_eq!(
            drive.target,
            Target::Pressure(vec![Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)])])
        );
        assert_eq!((drive.until_s, drive.output_step_s), (5.0, 0.005));
    }

    #[test]
    fn liquids_have_valves_pumps_and_syringes() {
        let read = |text: &str| {
            parse_drive(
                &format!("muscle = 'm.toml'\n[liquid]\nname = 'oil'\n{text}"),
                &Tables::default(),
            )
            .unwrap()
        };
        let drive = read(&format!(
            "gas_share = '1 %'\n[valve]\nflow_coefficient = '0.36 m3/h'\nhose_length = '1 \
             m'\nhose_diameter = '4 mm'\n{TAIL}"
        ));
        let Fluid::Liquid(fill) = &drive.fluid else {
            panic!()
        };
        assert_eq!((fill.liquid.name, fill.liquid.gas_share), ("oil", 0.01));
        // 0.36 m³/h is 0.1 L/s.
        let Actuator::LiquidValve(valve) = drive.actuator else {
            panic!()
        };
        assert!((valve.supply.kv_mm3_per_s - 1e5).abs() < 1e-6 && valve.tank == valve.supply);
        assert!(valve.line.is_some());
        let drive = read(
            "[syringe]\nvolume = '20 mL'\n[command]\nvolume = 'ramp 0..15 mL in 2 s'\nuntil = '3 \
             s'\n",
        );
        assert_eq!(
            drive.actuator,
            Actuator::Syringe(Syringe {
                volume_mm3: 20e3,
                time_constant_s: 0.05
            })
        );
        assert_eq!(
            drive.target,
            Target::Volume(vec![Command::Ramps(vec![(0.0, 0.0), (2.0, 15e3)])])
        );
    }

    #[test]
    fn files_say_where_they_are_wrong() {
        for (text, words) in [
            (format!("[valve]\nname = 'x'\n{TAIL}"), "muscle"),
            (format!("{MUSCLE}{TAIL}"), "[regulator]"),
            (
                format!("{HEAD}[regulator]\ntime_constant = '20 ms'\n{TAIL}"),
                "conflicts with [valve]",
            ),
            (
                format!("{MUSCLE}[valve]\nsonic_conductance = '0 L/(s bar)'\n{TAIL}"),
                "above zero",
            ),
            (
                format!("{MUSCLE}[valve]\nname = 'festo-mh3'\n{TAIL}"),
                "festo-mh2",
            ),
            (format!("{HEAD}critical_ratio = 1.5\n{TAIL}"), "critical"),
            (
                format!("{HEAD}[friction]\npresliding = '0 mm'\n{TAIL}"),
                "above zero",
            ),
            (format!("{HEAD}[air]\nheat = 'warm'\n{TAIL}"), "isothermal"),
            (format!("{HEAD}[command]\npressure = '3 bar'\n"), "until"),
            (
                format!("{HEAD}[command]\nuntil = '1 s'\n"),
                "what is commanded",
            ),
            (
                format!(
                    "{HEAD}[command]\npressure = [['1 s', '1 bar'], ['0 s', '2 bar']]\nuntil = '1 \
                     s'\n"
                ),
                "must increase",
            ),
            (
                format!("{HEAD}[command]\npressure = [['1 s']]\nuntil = '1 s'\n"),
                "pairs",
            ),
            (
                format!("{HEAD}[command]\npressure = 'NaN bar'\nuntil = '1 s'\n"),
                "command",
            ),
            (
                format!("{HEAD}[supply]\ntemperature = '-300 degC'\n{TAIL}"),
                "absolute zero",
            ),
            (
                format!("{HEAD}hose_length = '1 m'\n{TAIL}"),
                "hose_diameter",
            ),
            (
                format!("{HEAD}[command]\nposition = '10%'\nuntil = '1 s'\n"),
                "proportional",
            ),
            (
                format!("{HEAD}[liquid]\nname = 'water'\n{TAIL}"),
                "flow_coefficient alone",
            ),
            (
                format!("{HEAD}flow_coefficient = '0.1 m3/h'\n{TAIL}"),
                "no [liquid]",
            ),
            (
                format!("{MUSCLE}[liquid]\nname = 'beer'\n[pump]\nflow = '1 L/min'\n{TAIL}"),
                "glycol",
            ),
            (
                format!("{MUSCLE}[liquid]\nname = 'oil'\n[air]\nheat = 'adiabatic'\n{TAIL}"),
                "keep one",
            ),
            (
                format!("{MUSCLE}[pump]\nflow = '1 L/min'\n[syringe]\nvolume = '1 mL'\n{TAIL}"),
                "keep one",
            ),
            (
                format!("{MUSCLE}[liquid]\nname = 'oil'\n[pump]\n{TAIL}"),
                "Largest flow",
            ),
            (
                format!(
                    "joint = 'j.toml'\n[valve]\nname = 'festo-mh2'\n[load]\nmass = '1 kg'\n{TAIL}"
                ),
                "own file",
            ),
        ] {
            let error = parse_drive(&text, &Tables::default())
                .map(|_| String::new())
                .unwrap_or_else(|e| e.to_string());
            assert!(error.contains(words), "{text}: {error}");
        }
    }
}
