//! The units in which this run shows quantities to people: those of `--units`; else those of the
//! first pressure, force and length on the command line; else those of the drive file; else MPa, N
//! and mm. JSON and CSV have fixed units.

use crate::{Args, Flag};
use mckibben_app::units::Units;
use std::sync::OnceLock;

/// Flags whose unit a user wants to read, too. A modulus is not among them: pressures are not read
/// in GPa.
const FLAGS: [&str; 11] = [
    "pressure",
    "max-pressure",
    "supply",
    "force",
    "at",
    "stroke",
    "outer-diameter",
    "wall",
    "length",
    "max-bulged-diameter",
    "radius",
];

static TYPED: OnceLock<Units> = OnceLock::new();
static OF_FILE: OnceLock<Units> = OnceLock::new();

/// Looks at a command line that was understood: at `--units`, else at the flags in the order in
/// which they were typed.
pub fn take(args: &Args) {
    let named = args
        .matches
        .try_get_one::<Box<Units>>("units")
        .ok()
        .flatten();
    let typed = || {
        let flags = args
            .flags
            .iter()
            .filter(|flag| FLAGS.contains(&&*flag.long));
        let one = |flag: &Flag| {
            args.matches
                .indices_of(&flag.id)
                .into_iter()
                .flatten()
                .zip(args.texts(&flag.id))
                .collect()
        };
        let mut texts: Vec<(usize, String)> =
            flags.flat_map(|flag| -> Vec<_> { one(flag) }).collect();
        texts.sort();
        Units::typed(texts.iter().map(|(_, text)| text.as_str()))
    };
    let units = named.map_or_else(typed, |units| (**units).clone());
    if named.is_some() || units != Units::default() {
        TYPED.get_or_init(|| units);
    }
}

/// Takes the units of a drive file, where no flag states any: those of the quantities behind its
/// keys `pressure`.
pub fn take_file(text: &str) {
    let pressure = |line: &str| {
        let (key, value) = line.split_once('=')?;
        let quantity = value.split('"').nth(1)?;
        (key.trim() == "pressure").then(|| quantity.to_owned())
    };
    let pressures: Vec<String> = text.lines().filter_map(pressure).collect();
    OF_FILE.get_or_init(|| Units::typed(pressures.iter().map(String::as_str)));
}

pub fn units() -> Units {
    TYPED
        .get()
        .or_else(|| OF_FILE.get())
        .cloned()
        .unwrap_or_default()
}

/// A sentence of the layers below in these units.
pub fn sentence(text: &str) -> String {
    units().sentence(text)
}
