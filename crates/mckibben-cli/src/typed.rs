//! The command that was typed: the names of its flags, and the texts behind them.

use clap::parser::ValueSource;
use clap::{ArgMatches, Command};
use mckibben::muscle::Measure;
use std::sync::OnceLock;

/// A flag of the command that runs.
#[derive(Debug, Clone)]
pub struct Flag {
    /// The field of the request that it fills.
    pub field: String,
    /// Its name, with hyphens.
    pub name: String,
    /// The texts behind it, each with its place on the command line.
    pub texts: Vec<(usize, String)>,
}

static FLAGS: OnceLock<Vec<Flag>> = OnceLock::new();

/// Takes the flags of the command that runs, for its messages and units; of a command line that
/// clap refuses their names alone.
pub fn take(root: &Command, matches: Option<&ArgMatches>) {
    let (mut command, mut leaf) = (root, matches);
    for word in std::env::args_os().skip(1) {
        if let Some(sub) = command.find_subcommand(&word) {
            command = sub;
            leaf = leaf.and_then(ArgMatches::subcommand).map(|(_, sub)| sub);
        }
    }
    let texts = |id: &str| -> Vec<(usize, String)> {
        let is_typed = |leaf: &&ArgMatches| leaf.value_source(id) == Some(ValueSource::CommandLine);
        let Some(leaf) = leaf.filter(is_typed) else {
            return vec![];
        };
        let raw = leaf.try_get_raw(id).ok().flatten().into_iter().flatten();
        let texts = raw.map(|text| text.to_string_lossy().into_owned());
        leaf.indices_of(id)
            .into_iter()
            .flatten()
            .zip(texts)
            .collect()
    };
    let flags = command.get_arguments().filter_map(|arg| {
        let id = arg.get_id().as_str();
        Some(Flag {
            field: id.to_owned(),
            name: format!("--{}", arg.get_long()?),
            texts: texts(id),
        })
    });
    FLAGS.get_or_init(|| flags.collect());
}

/// The flags of the command that runs.
pub fn flags() -> &'static [Flag] {
    FLAGS.get().map_or(&[], Vec::as_slice)
}

/// The flag of a request's field.
pub fn flag_of(field: &str) -> Option<String> {
    // Of every command.
    if field == "overwrite" {
        return Some("--overwrite".into());
    }
    let fills = |flag: &&Flag| flag.field == field;
    let flag = flags().iter().find(fills).map(|flag| flag.name.clone());
    flag.or_else(|| Some(format!("--with {}", Measure::of_field(field)?.key)))
}

/// A sentence with flags in place of the fields that it names in backquotes.
pub fn in_flags(sentence: &str) -> String {
    let one = |(i, part): (usize, &str)| match flag_of(part).filter(|_| i % 2 == 1) {
        Some(flag) => flag,
        None if i % 2 == 1 => format!("`{part}`"),
        None => part.to_owned(),
    };
    sentence.split('`').enumerate().map(one).collect()
}
