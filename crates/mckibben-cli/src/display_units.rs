//! The units in which this run shows quantities to people: those of `--units`; else those of the
//! first pressure, force and length on the command line; else those of the drive file; else MPa, N
//! and mm. JSON and CSV have fixed units.

use crate::{quantities::check_unit, typed::flags};
use mckibben_app::units::Units;
use std::sync::OnceLock;

/// Flags whose unit a user wants to read, too. A modulus is not among them: pressures are not read
/// in GPa.
const FLAGS: [&str; 11] = [
    "--pressure",
    "--max-pressure",
    "--supply",
    "--force",
    "--at",
    "--stroke",
    "--outer-diameter",
    "--wall",
    "--length",
    "--max-bulged-diameter",
    "--radius",
];

static TYPED: OnceLock<Units> = OnceLock::new();
static OF_FILE: OnceLock<Units> = OnceLock::new();

/// Looks at a command line that was understood: at `--units`, else at the flags in the order in
/// which they were typed.
pub fn take() {
    let named = flags()
        .iter()
        .find(|flag| flag.name == "--units")
        .and_then(|flag| flag.texts.first()?.1.parse().ok());
    let mut texts: Vec<&(usize, String)> = vec![];
    for flag in flags().iter().filter(|flag| FLAGS.contains(&&*flag.name)) {
        texts.extend(&flag.texts);
        for (_, text) in &flag.texts {
            check_unit(&flag.name, text);
        }
    }
    texts.sort();
    let typed = Units::typed(texts.into_iter().map(|(_, text)| text.as_str()));
    let typed = Some(typed).filter(|units| *units != Units::default());
    named
        .or(typed)
        .into_iter()
        .for_each(|units| drop(TYPED.set(units)));
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
