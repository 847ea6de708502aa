//! `models`: the force models.

use crate::cli::ModelsArgs;
use crate::failure::Failure;
use crate::flags::Format;
use crate::output::{csv, emit, json};
use mckibben::model::ModelKind;
use serde_json::json;

/// Lists the models.
pub fn run(args: &ModelsArgs) -> Result<u8, Failure> {
    let width = ModelKind::ALL.iter().map(|k| k.name().len()).max().unwrap_or(0);
    let list: Vec<_> =
        ModelKind::ALL.iter().map(|k| json!({ "name": k.name(), "description": k.description() })).collect();
    let text = match args.output.format {
        Format::Json => json::print(&json!({ "models": list })),
        Format::Csv => csv::rows(&list)?,
        Format::Text => {
            let line = |k: &ModelKind| format!("  {:<width$}   {}\n", k.name(), k.description());
            ModelKind::ALL.iter().map(line).collect()
        }
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(0)
}
