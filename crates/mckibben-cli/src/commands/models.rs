//! `models`: the force models, and the story of one.

use crate::failure::Failure;
use crate::flags::OutputFlags;
use crate::format::Format;
use crate::names::MODELS;
use crate::output::show;
use clap::Args;
use mckibben_app::{ModelsAnswer, ModelsRequest, models};

pub const EXAMPLES: &str = "Examples:
  mckibben models
  mckibben models fe";

/// `models`.
#[derive(Debug, Args)]
pub struct ModelsArgs {
    /// One model: its source, and the basis of its ±
    #[arg(value_name = "NAME", value_parser = MODELS, hide_possible_values = true)]
    pub model: Option<String>,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// Lists the models, or tells the story of one.
pub fn run(args: &ModelsArgs, format: Format) -> Result<u8, Failure> {
    let answer = models(&ModelsRequest { model: args.model.clone() })?;
    show(&answer, format, "models", || text(&answer), args.output.target())?;
    Ok(0)
}

fn text(answer: &ModelsAnswer) -> String {
    let Some(story) = &answer.story else {
        let width = answer.models.iter().map(|m| m.name.len()).max().unwrap_or(0);
        let line = |m: &mckibben_app::ModelEntry| format!("  {:<width$}   {}\n", m.name, m.description);
        return answer.models.iter().map(line).collect();
    };
    let head = answer.models.iter().map(|m| format!("{}: {}\n", m.name, m.description)).collect::<String>();
    let needs = story.needs.as_ref().map_or_else(String::new, |needs| format!("\n{needs}\n"));
    if !needs.is_empty() {
        return head + &needs;
    }
    let parts: String = story.uncertainty_basis.split("; ").map(|part| format!("  - {part}\n")).collect();
    format!(
        "{head}\nSource: {}\n\nThe ± is a 95 % half-width against a measured muscle. Its parts:\n{parts}",
        story.source
    )
}
