//! Results that would take the place of what they are made from, and figures in the place of what this program did not draw: refused before any
//! work, whatever the command.

use crate::failure::Failure;
use crate::output::{Content, Target, check as check_lost, of_input};
use clap::ArgMatches;
use clap::parser::ValueSource;
use mckibben_report::DATA_HEAD;
use std::path::Path;

/// Flags that name files that are written; every other flag that names a file reads it.
const WRITTEN: [&str; 5] = ["output", "plot", "plot_data", "report", "export_inp"];

/// Refuses a command line that names one file as an input and as an output, or as a figure what is none, but with `--overwrite`.
pub fn check(matches: &ArgMatches) -> Result<(), Failure> {
    let mut leaf = matches;
    while let Some((_, inner)) = leaf.subcommand() {
        leaf = inner;
    }
    if leaf.try_get_one::<bool>("overwrite").ok().flatten().is_some_and(|overwrite| *overwrite) {
        return Ok(());
    }
    let given: Vec<&str> = leaf
        .ids()
        .map(|id| id.as_str())
        .filter(|id| leaf.value_source(id) == Some(ValueSource::CommandLine))
        .collect();
    let paths = |id: &str| leaf.try_get_raw(id).ok().flatten().into_iter().flatten().map(Path::new);
    let (written, read): (Vec<&str>, Vec<&str>) = given.into_iter().partition(|id| WRITTEN.contains(id));
    for path in written.iter().copied().flat_map(paths).filter(|path| path.is_file()) {
        if read.iter().flat_map(|id| paths(id)).any(|input| mckibben_files::is_same(path, input)) {
            return Err(of_input(path));
        }
    }
    let figures = written.iter().copied().filter(|id| *id == "plot").flat_map(paths);
    let refused = |path, content: &Content| check_lost(Target::file(path, false), content);
    figures.into_iter().try_for_each(|path| refused(path, &Content::Figure))?;
    let data = Content::Table { head: DATA_HEAD.into() };
    written
        .iter()
        .filter(|id| **id == "plot_data")
        .flat_map(|id| paths(id))
        .try_for_each(|path| refused(path, &data))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::{Command, CommandFactory};

    fn leaves<'c>(command: &'c Command, visit: &mut dyn FnMut(&'c Command)) {
        if !command.has_subcommands() {
            visit(command);
        }
        command.get_subcommands().for_each(|inner| leaves(inner, visit));
    }

    #[test]
    fn every_command_that_writes_a_file_can_be_told_to_overwrite() {
        let (root, mut writes) = (crate::cli::Cli::command(), 0);
        leaves(&root, &mut |command| {
            let has = |id: &str| command.get_arguments().any(|a| a.get_id() == id);
            if WRITTEN.into_iter().any(has) {
                writes += 1;
                assert!(has("overwrite"), "{}", command.get_name());
            }
        });
        assert!(writes > 10, "{writes}");
    }
}
