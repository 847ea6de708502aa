//! `models`: the force models.

use crate::cli::ModelsArgs;
use crate::failure::Failure;
use crate::flags::Format;
use crate::kind::Kind;
use crate::output::{csv, emit, json};
use serde_json::json;

/// Lists the models.
pub fn run(args: &ModelsArgs) -> Result<u8, Failure> {
    let all = Kind::all();
    let width = all.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    let list: Vec<_> =
        all.iter().map(|(name, about)| json!({ "name": name, "description": about })).collect();
    let text = match args.output.format {
        Format::Json => json::print(&json!({ "models": list })),
        Format::Csv => csv::rows(&list)?,
        Format::Text => all.iter().map(|(name, about)| format!("  {name:<width$}   {about}\n")).collect(),
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(0)
}
