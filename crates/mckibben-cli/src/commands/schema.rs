//! `schema`: the JSON Schema of requests, answers and files.

use crate::failure::Failure;
use crate::output::{check_ending, emit};
use clap::Args;
use mckibben_app::{COMMANDS, bundle, file_schema, schema};
use std::path::PathBuf;

/// `schema`.
#[derive(Debug, Args)]
pub struct SchemaArgs {
    /// Command, its words joined by a hyphen (force, parts-list) [all commands in one document with shared `$defs`]
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
    /// Schema of a file that people write: muscle, joint, drive or plan
    ///
    /// For TOML editors, which complete and check with it. Files that this program writes name it in the line `#:schema`.
    #[arg(long, value_name = "KIND", conflicts_with = "command")]
    pub file: Option<String>,
    /// Write to a file instead of standard output; without COMMAND: into a folder, one file per command
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

pub fn run(args: &SchemaArgs) -> Result<u8, Failure> {
    if args.command.is_some() || args.file.is_some() {
        check_ending(args.output.as_deref(), &["json"])?;
        let text = match (&args.file, &args.command) {
            (Some(kind), _) => format!("{:#}\n", file_schema(kind)?),
            (None, command) => text(command.as_deref().unwrap_or_default())?,
        };
        return emit(&text, args.output.as_deref()).map(|()| 0);
    }
    let Some(folder) = &args.output else {
        return emit(format!("{:#}\n", bundle()), None).map(|()| 0);
    };
    std::fs::create_dir_all(folder).map_err(|e| Failure::unwritable(folder, &e))?;
    for command in COMMANDS.iter() {
        emit(text(command.name)?, Some(&folder.join(format!("{}.json", command.name))))?;
    }
    Ok(0)
}

fn text(command: &str) -> Result<String, Failure> {
    Ok(format!("{:#}\n", schema(command)?))
}
