//! The units in which this run shows quantities to people: those of `--units`; else those of the first pressure, force and length on the
//! command line; else those of the file that asks; else MPa, N and mm. JSON and CSV have units of their own.

use clap::ArgMatches;
use mckibben_app::units::Units;
use std::borrow::Cow;
use std::sync::OnceLock;

/// Flags whose unit a user wants to read, too. A modulus is not among them: nobody reads pressures in GPa.
const FLAGS: [&str; 11] = [
    "pressure",
    "max_pressure",
    "supply",
    "force",
    "at",
    "stroke",
    "outer_diameter",
    "wall",
    "length",
    "max_bulged_diameter",
    "radius",
];

static ASKED: OnceLock<Units> = OnceLock::new();
static OF_FILE: OnceLock<Units> = OnceLock::new();

/// Looks at a command line that was understood.
pub fn take(matches: &ArgMatches) {
    let mut matches = matches;
    while let Some((_, of_command)) = matches.subcommand() {
        matches = of_command;
    }
    let asked = matches.try_get_one::<Box<Units>>("units").ok().flatten();
    let units = asked.map(|units| (**units).clone()).or_else(|| typed(matches));
    if let Some(units) = units {
        ASKED.get_or_init(|| units);
    }
}

/// The units of the flags, in the order in which they were typed.
fn typed(matches: &ArgMatches) -> Option<Units> {
    let mut texts: Vec<(usize, String)> = vec![];
    for flag in FLAGS {
        let Ok(Some(values)) = matches.try_get_raw(flag) else { continue };
        let values = values.map(|text| text.to_string_lossy().into_owned());
        texts.extend(matches.indices_of(flag).into_iter().flatten().zip(values));
    }
    texts.sort();
    let units = Units::typed(texts.iter().map(|(_, text)| text.as_str()));
    (units != Units::default()).then_some(units)
}

/// Takes the units of a file that asks, where no flag says any: those of the quantities behind its keys `pressure`.
pub fn take_file(text: &str) {
    let pressure = |line: &str| {
        let (key, value) = line.split_once('=')?;
        let quantity = value.split('"').nth(1)?;
        (key.trim() == "pressure").then(|| quantity.to_owned())
    };
    let found: Vec<String> = text.lines().filter_map(pressure).collect();
    OF_FILE.get_or_init(|| Units::typed(found.iter().map(String::as_str)));
}

pub fn units() -> Units {
    ASKED.get().or_else(|| OF_FILE.get()).cloned().unwrap_or_default()
}

/// A sentence of the layers below in these units.
pub fn sentence(text: &str) -> Cow<'_, str> {
    match ASKED.get().or_else(|| OF_FILE.get()) {
        Some(units) => units.sentence(text),
        None => Cow::Borrowed(text),
    }
}
