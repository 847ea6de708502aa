//! `schema`: the JSON Schema of requests, answers and files.

use crate::failure::Failure;
use crate::flags::OverwriteFlag;
use crate::output::{Content, Target, emit, save};
use clap::Args;
use mckibben_app::{COMMANDS, bundle, file_schema, schema};
use std::path::{Path, PathBuf};

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
    #[command(flatten)]
    pub replace: OverwriteFlag,
}

pub fn run(args: &SchemaArgs) -> Result<u8, Failure> {
    let put = |path: &Path, text: &str| {
        save(Target::file(path, args.replace.overwrite), Content::json(text.as_bytes()), text.as_bytes())
    };
    if args.command.is_some() || args.file.is_some() {
        let text = match (&args.file, &args.command) {
            (Some(kind), _) => format!("{:#}\n", file_schema(kind)?),
            (None, command) => text(command.as_deref().unwrap_or_default())?,
        };
        let written = args.output.as_ref().map_or_else(|| emit(&text, None), |path| put(path, &text));
        return written.map(|()| 0);
    }
    let Some(folder) = &args.output else {
        return emit(format!("{:#}\n", bundle()), None).map(|()| 0);
    };
    std::fs::create_dir_all(folder).map_err(|e| Failure::unwritable(folder, &e))?;
    for command in COMMANDS.iter() {
        put(&folder.join(format!("{}.json", command.name)), &text(command.name)?)?;
    }
    Ok(0)
}

fn text(command: &str) -> Result<String, Failure> {
    Ok(format!("{:#}\n", schema(command)?))
}
