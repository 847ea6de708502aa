//! Results that would take the place of what they are made from: refused before any work, whatever the command.

use crate::failure::Failure;
use crate::output::of_input;
use clap::ArgMatches;
use clap::parser::ValueSource;
use std::path::Path;

/// Flags that name files that are written; every other flag that names a file reads it.
const WRITTEN: [&str; 5] = ["output", "plot", "pdf", "picture", "export_inp"];

/// Refuses a command line that names one file as an input and as an output, but with `--overwrite`.
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
    for path in written.into_iter().flat_map(paths).filter(|path| path.is_file()) {
        if read.iter().flat_map(|id| paths(id)).any(|input| mckibben_files::is_same(path, input)) {
            return Err(of_input(path));
        }
    }
    Ok(())
}
