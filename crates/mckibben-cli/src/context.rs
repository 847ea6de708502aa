//! What a command knows of its command line: format, units that are shown, flags and their texts.

use crate::{Format, quantities::unit_note};
use clap::{Arg, ArgMatches, Command, parser::ValueSource};
use mckibben_app::Units;
use mckibben_core::muscle::Measure;

/// Flags whose unit a user wants to read, too. A modulus is not among them: pressures are not read
/// in GPa.
const WITH_UNITS: [&str; 11] = [
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

/// A flag of the command that runs.
pub struct Flag {
    /// The field of the request that it fills.
    field: String,
    /// Its name, with hyphens.
    pub name: String,
    /// The texts behind it, each with its place on the command line.
    pub texts: Vec<(usize, String)>,
}

impl Flag {
    fn new(arg: &Arg, args: &[String], matches: Option<&ArgMatches>) -> Option<Self> {
        let id = arg.get_id().as_str();
        // The name under which it was typed.
        let is_typed = |name: &&str| args.contains(&format!("--{name}"));
        let alias = arg.get_all_aliases().into_iter().flatten().find(is_typed);
        let name = format!("--{}", alias.or(arg.get_long())?);
        let texts = matches
            .filter(|matches: &&ArgMatches| {
                matches.value_source(id) == Some(ValueSource::CommandLine)
            })
            .and_then(|matches| {
                let texts = matches
                    .try_get_raw(id)
                    .ok()??
                    .map(|text| text.to_string_lossy().into_owned());
                Some(matches.indices_of(id)?.zip(texts).collect())
            });
        Some(Self {
            field: id.to_owned(),
            name,
            texts: texts.unwrap_or_default(),
        })
    }
}

/// What a command knows of its command line.
#[derive(Default)]
pub struct Context {
    /// The form of the output.
    pub format: Format,
    /// Whether existing files are overwritten.
    pub overwrite: bool,
    /// The units in which people are shown quantities: those of `--units`; else those of the first
    /// pressure, force and length on the command line; else those of the drive file; else MPa, N
    /// and mm. JSON and CSV have fixed units.
    pub units: Units,
    /// The flags of the command.
    pub flags: Vec<Flag>,
    /// The note on a pressure that was typed as a bare number, beside an answer or a problem.
    pub unit_note: Option<String>,
}

impl Context {
    /// Of a command line; of one that clap refuses, which has no matches, the names of flags alone.
    pub fn new(root: &Command, args: &[String], matches: Option<&ArgMatches>) -> Self {
        let mut command = root;
        let mut leaf = matches;
        for word in args.iter().skip(1) {
            if let Some(sub) = command.find_subcommand(word) {
                command = sub;
                leaf = leaf.and_then(ArgMatches::subcommand).map(|(_, sub)| sub);
            }
        }
        let flags = Vec::from_iter(
            command
                .get_arguments()
                .filter_map(|arg| Flag::new(arg, args, leaf)),
        );
        let with_units = || {
            flags
                .iter()
                .filter(|flag| WITH_UNITS.contains(&&*flag.name))
        };
        let mut texts = with_units()
            .flat_map(|flag| &flag.texts)
            .collect::<Vec<_>>();
        texts.sort();
        let named = leaf.and_then(|leaf| leaf.try_get_one::<Units>("units").ok()?.cloned());
        let note = |flag: &Flag| {
            flag.texts
                .iter()
                .find_map(|(_, text)| unit_note(&flag.name, text))
        };
        Self {
            units: named
                .unwrap_or_else(|| Units::typed(texts.into_iter().map(|(_, text)| &**text))),
            unit_note: with_units().find_map(note),
            flags,
            ..Self::default()
        }
    }

    /// Takes the units of a drive file, where no flag states any: those of the quantities behind
    /// its keys `pressure`.
    pub fn take_units(&mut self, file: &str) {
        let pressure = |line| {
            let (key, value) = str::split_once(line, '=')?;
            value.split('"').nth(1).filter(|_| key.trim() == "pressure")
        };
        if self.units == Units::default() {
            self.units = Units::typed(file.lines().filter_map(pressure));
        }
    }

    /// The flag of a request's field.
    pub fn flag_of(&self, field: &str) -> Option<String> {
        let is_both = |flag: &Flag| flag.field == "both" && !flag.texts.is_empty();
        let field = match field {
            // It selects a branch as well.
            "direction" if self.flags.iter().any(is_both) => "both",
            field => field,
        };
        let fills =
            |flag: &&Flag| flag.field == field || field == "direction" && flag.field == "branch";
        match self.flags.iter().find(fills) {
            Some(flag) => Some(flag.name.clone()),
            None => Some(format!("--with {}", Measure::of_field(field)?.key)),
        }
    }

    /// A sentence with flags in place of the fields that it names in backquotes.
    pub fn in_flags(&self, sentence: &str) -> String {
        let one = |(i, part): (usize, &str)| match self.flag_of(part).filter(|_| i % 2 == 1) {
            Some(flag) => flag,
            None if i % 2 == 1 => format!("`{part}`"),
            None => part.to_owned(),
        };
        sentence.split('`').enumerate().map(one).collect()
    }
}
