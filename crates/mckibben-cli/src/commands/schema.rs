//! `schema`: the JSON Schema of requests, answers and files.

use crate::{Context, Result, check_ending, examples::examples};
use mckibben_app::{COMMANDS, bundle, file_schema, schema};
use std::path::PathBuf;

/// The JSON Schema of a command, or of a file.
#[derive(clap::Args)]
#[command(next_help_heading = "Options", after_long_help = examples(&[
    "schema force",
    "schema --file muscle -o muscle.schema.json"
]))]
pub struct Schema {
    /// Command, its words joined by a hyphen (force, parts-list) [all commands in one document with
    /// shared `$defs`]
    command: Option<String>,
    /// Schema of a file that people write: muscle, joint, drive or plan
    ///
    /// For TOML editors, which complete and check with it. Files that this program writes name it in
    /// the line `#:schema`.
    #[arg(long, value_name = "KIND", conflicts_with = "command")]
    file: Option<String>,
    /// Write to a file instead of standard output; without COMMAND: into a folder, one file per
    /// command
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    output: Option<PathBuf>,
}

impl Schema {
    pub fn run(self, context: &Context) -> Result<u8> {
        let target = self.output;
        let one = match (self.file, self.command) {
            (Some(kind), _) => file_schema(&kind)?,
            (None, Some(command)) => schema(&command)?,
            (None, None) => {
                let Some(folder) = &target else {
                    return context.emit(format!("{:#}\n", bundle()), None).map(|()| 0);
                };
                let files = COMMANDS
                    .iter()
                    .map(|c| (format!("{}.json", c.name), format!("{:#}\n", c.schema())));
                return context.save_inside(folder, files).map(|()| 0);
            }
        };
        check_ending(target.as_deref(), &["json"])?;
        context
            .emit(format!("{one:#}\n"), target.as_deref())
            .map(|()| 0)
    }
}
