//! `models`: the force models.

use crate::failure::Failure;
use crate::flags::{Format, OutputFlags};
use crate::output::show;
use clap::Args;
use mckibben_app::{ModelsRequest, models};

/// `models`.
#[derive(Debug, Args)]
pub struct ModelsArgs {
    #[command(flatten)]
    pub output: OutputFlags,
}

/// Lists the models.
pub fn run(args: &ModelsArgs, format: Format) -> Result<u8, Failure> {
    let answer = models(&ModelsRequest {});
    let width = answer.models.iter().map(|m| m.name.len()).max().unwrap_or(0);
    let line = |m: &mckibben_app::ModelEntry| format!("  {:<width$}   {}\n", m.name, m.description);
    let text = || answer.models.iter().map(line).collect();
    show(&answer, format, "models", text, args.output.output.as_deref())?;
    Ok(0)
}
