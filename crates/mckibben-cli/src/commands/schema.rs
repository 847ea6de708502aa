//! `schema`: the JSON Schema of requests and answers.

use crate::failure::Failure;
use crate::output::emit;
use clap::Args;
use mckibben_app::{COMMANDS, schema};
use std::path::PathBuf;

/// `schema`.
#[derive(Debug, Args)]
pub struct SchemaArgs {
    /// Which command, in its words joined by a hyphen (force, rubber-fit); all of them without
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

/// Prints a schema.
pub fn run(args: &SchemaArgs) -> Result<u8, Failure> {
    let value = match &args.command {
        Some(command) => schema(command)?,
        None => COMMANDS.iter().map(|c| Ok((c.name.to_owned(), schema(c.name)?))).collect::<Result<_, Failure>>()?,
    };
    emit(&format!("{value:#}\n"), args.output.as_deref())?;
    Ok(0)
}
