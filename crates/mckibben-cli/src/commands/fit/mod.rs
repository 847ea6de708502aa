//! `fit`: from a table of points to a formula.

mod args;
mod load;
mod present;
mod report;
mod universal;

pub use args::{FitArgs, FormulaShowArgs};
pub use present::{error_rows, errors_table, made_text, range_text};
pub use universal::as_text as universal_text;

use crate::failure::Failure;
use crate::figure;
use crate::flags::Format;
use crate::kind::Kind;
use crate::output::{csv, emit, json, save};
use crate::resolve;
use mckibben::formula::Made;
use mckibben::units::Dimension;
use mckibben_campaign::fit::tables::tables;
use mckibben_campaign::fit::{Fitted, Method, Request, make};
use serde_json::{Map, Value, json};
use std::path::Path;

/// Runs the command.
pub fn run(args: &FitArgs) -> Result<u8, Failure> {
    let Some(path) = &args.file else { return report::run(args.format, args.output.as_deref()) };
    if let Some(form) = args.universal() {
        return universal::run(args, path, form);
    }
    let method = args.chosen();
    if let (Method::Global(_), Some(_)) = (method, &args.tables) {
        let message = "--tables: the method global has no intermediate tables";
        return Err(Failure::input("usage", message, "take --method paper"));
    }
    free_name(args)?;
    let hold_out = match &args.hold_out {
        Some(text) => resolve::points("--hold-out", Some(text), Dimension::Length, "", 1)?,
        None => vec![],
    };
    let table = load::load(path)?;
    let made_for = match &table.made_for {
        Some(made) => made.clone(),
        None => Made::of(&resolve::muscle(&args.muscle_flags())?),
    };
    let usual = match method {
        Method::Paper(_) => "paper-method",
        Method::Global(_) => "global",
    };
    let fitted = make(&Request {
        points: &table.points,
        made_for,
        method,
        hold_out: &hold_out,
        name: args.name.clone().unwrap_or_else(|| usual.into()),
        table: path.file_name().map(|n| n.to_string_lossy().into_owned()),
        plan_hash: table.plan_hash.clone(),
        seed: table.seed,
    })
    .map_err(|e| Failure::input("fit", format!("{}: {e}", path.display()), ""))?;
    if !hold_out.is_empty() && fitted.formula.errors.held_out.is_none() {
        let message = format!("--hold-out: {} has no such diameter", path.display());
        return Err(Failure::input("usage", message, ""));
    }
    if let Some(folder) = &args.tables {
        write_tables(folder, &fitted)?;
    }
    if let Some(folder) = &args.plots {
        write_plots(folder, &fitted)?;
    }
    if let Some(file) = &args.output {
        save(file, fitted.formula.to_json().as_bytes())?;
    }
    let text = match args.format {
        Format::Json => json::print(&json!(fitted.formula)),
        Format::Csv => csv::rows(&terms(&json!(fitted.formula)))?,
        Format::Text => present::as_text(&fitted, table.failed, args.output.as_deref()),
    };
    emit(&text, None)?;
    Ok(0)
}

/// A formula does not take the name of a model.
fn free_name(args: &FitArgs) -> Result<(), Failure> {
    match args.name.as_deref().filter(|n| Kind::is_taken(n) || n.trim().is_empty()) {
        None => Ok(()),
        Some(name) => {
            let message = format!("--name: \"{name}\" cannot be told from a model that exists already");
            Err(Failure::input("usage", message, "take another name"))
        }
    }
}

/// The terms of a formula's JSON.
pub fn terms(formula: &Value) -> Vec<Value> {
    formula["terms"].as_array().cloned().unwrap_or_default()
}

fn folder(path: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(path).map_err(|e| Failure::unwritable(path, &e))
}

fn write_tables(path: &Path, fitted: &Fitted) -> Result<(), Failure> {
    let Some(method) = &fitted.paper else { return Ok(()) };
    folder(path)?;
    let mut all = Map::new();
    for table in tables(method) {
        save(&path.join(format!("{}.csv", table.name)), table.to_csv().as_bytes())?;
        all.insert(table.name.into(), table.to_value());
    }
    let all = json!({ "method": fitted.formula.provenance.method, "tables": all });
    save(&path.join("tables.json"), json::print(&all).as_bytes())
}

fn write_plots(path: &Path, fitted: &Fitted) -> Result<(), Failure> {
    folder(path)?;
    let mut all = fitted.paper.as_ref().map_or_else(Vec::new, |m| figure::paper_figures(m, &fitted.formula));
    all.push(("figure_12_formula_and_points", figure::against_points(&fitted.formula, &fitted.compared)));
    for (name, figure) in all {
        figure.save(&path.join(format!("{name}.svg")))?;
    }
    Ok(())
}
