//! `schema`: the JSON Schema of requests and answers.

use crate::failure::Failure;
use crate::output::{Content, Target, check, emit};
use clap::Args;
use mckibben_app::{COMMANDS, schema};
use std::path::PathBuf;

/// `schema`.
#[derive(Debug, Args)]
pub struct SchemaArgs {
    /// Which command, in its words joined by a hyphen (force, rubber-fit); all of them where none is named
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
    /// Write to a file instead of standard output; without COMMAND into a folder, a file for each command
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

/// Prints a schema.
pub fn run(args: &SchemaArgs) -> Result<u8, Failure> {
    if let Some(command) = &args.command {
        check(Target { path: args.output.as_deref(), overwrite: true }, &Content::Json)?;
        return emit(&text(command)?, args.output.as_deref()).map(|()| 0);
    }
    let Some(folder) = &args.output else {
        let all: serde_json::Map<String, serde_json::Value> = COMMANDS
            .iter()
            .map(|c| Ok((c.name.to_owned(), schema(c.name)?)))
            .collect::<Result<_, Failure>>()?;
        return emit(format!("{:#}\n", serde_json::Value::Object(all)), None).map(|()| 0);
    };
    for command in COMMANDS.iter() {
        emit(&text(command.name)?, Some(&folder.join(format!("{}.json", command.name))))?;
    }
    Ok(0)
}

fn text(command: &str) -> Result<String, Failure> {
    Ok(format!("{:#}\n", schema(command)?))
}
