//! The command that was typed: the names of its flags, and the texts behind them.

use clap::{ArgMatches, Command, parser::ValueSource};
use mckibben_core::muscle::Measure;
use std::sync::OnceLock;

/// A flag of the command that runs.
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
pub fn take(root: &Command, typed: &[String], matches: Option<&ArgMatches>) {
    let mut command = root;
    let mut leaf = matches;
    for word in &typed[1..] {
        if let Some(sub) = command.find_subcommand(word) {
            command = sub;
            leaf = leaf.and_then(ArgMatches::subcommand).map(|(_, sub)| sub);
        }
    }
    let texts = |id: &str| -> Vec<(usize, String)> {
        let is_typed = |leaf: &&ArgMatches| leaf.value_source(id) == Some(ValueSource::CommandLine);
        let Some(leaf) = leaf.filter(is_typed) else {
            return vec![];
        };
        let texts = leaf
            .try_get_raw(id)
            .ok()
            .flatten()
            .into_iter()
            .flatten()
            .map(|text| text.to_string_lossy().into_owned());
        leaf.indices_of(id)
            .into_iter()
            .flatten()
            .zip(texts)
            .collect()
    };
    let flags = command.get_arguments().filter_map(|arg| {
        let id = arg.get_id().as_str();
        // The name under which it was typed.
        let is_typed = |name: &&str| typed.contains(&format!("--{name}"));
        let alias = arg.get_all_aliases().into_iter().flatten().find(is_typed);
        let long = arg.get_long()?;
        Some(Flag {
            field: id.to_owned(),
            name: format!("--{}", alias.unwrap_or(long)),
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
    let both = || {
        flags()
            .iter()
            .any(|flag| flag.field == "both" && !flag.texts.is_empty())
    };
    let field = match field {
        // It selects a branch as well.
        "direction" if both() => "both",
        field => field,
    };
    let fills =
        |flag: &&Flag| flag.field == field || field == "direction" && flag.field == "branch";
    flags()
        .iter()
        .find(fills)
        .map(|flag| flag.name.clone())
        .or_else(|| Some(format!("--with {}", Measure::of_field(field)?.key)))
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
