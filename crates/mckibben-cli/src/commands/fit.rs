//! `fit`: from a table of points to a formula.

mod report;
mod text;

pub use text::{error_rows, errors_table, made_text, range_text, universal as universal_text};

use crate::failure::Failure;
use crate::flags::stiffness;
use crate::format::Format;
use crate::output::{check_ending, json, save, show};
use crate::progress::Bar;
use crate::quantities::points;
use crate::word::word;
use crate::{files, plot};
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{FitAnswer, FitMethod, FitRequest};
use mckibben_campaign::fit::{SlackRule, ThinRule};
use serde::Serialize;
use serde_json::{Map, Value};
use std::path::{Path, PathBuf};

pub const EXAMPLES: &str = "Examples:
  mckibben fit data/campaign/paper.csv --method paper --hold-out 35 \\
    -o formula.json --tables tables --plots plots
  mckibben fit data/campaign/paper.csv --method global --hold-out 35 \\
    -o global.json
  mckibben force -D 35 -s 2 -p 2bar -e 10% --model global.json
  mckibben fit --report";

/// `fit`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct FitArgs {
    /// Table of points (CSV with columns outer_diameter_mm, wall_mm, length_mm, angle_deg, pressure_mpa, contraction, force_n, status)
    #[arg(value_name = "FILE", required_unless_present = "report", conflicts_with = "report")]
    pub file: Option<PathBuf>,
    /// Compute the paper's campaign again and print all comparisons, without a table
    #[arg(long, conflicts_with_all = ["method", "hold_out", "thin_rule", "slack_rule", "name", "rubber", "stiffness", "muscle", "tables", "plots"])]
    pub report: bool,
    /// Fitting method
    #[arg(long, value_parser = word::<FitMethod>(), default_value = "paper")]
    pub method: FitMethod,
    /// Diameters to leave out of the fit, to test it [none]
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub hold_out: Option<String>,
    /// Name of the formula in answers [that of the method]
    #[arg(long)]
    pub name: Option<String>,
    /// Rubber of the muscles, if the table does not state it [paper]
    #[arg(long, value_name = "NAME", help_heading = "Muscle")]
    pub rubber: Option<String>,
    /// Braid of the muscles, if the table does not state it: N/mm, `inextensible`, or `paper` [paper]
    #[arg(long, value_name = "STIFFNESS", allow_hyphen_values = true, help_heading = "Muscle")]
    pub stiffness: Option<String>,
    /// Muscle file with the rubber and the braid
    #[arg(long, value_name = "FILE", help_heading = "Muscle")]
    pub muscle: Option<PathBuf>,
    /// Treatment of thick walls of thin muscles at low pressure, in the paper's method
    #[arg(long, value_parser = word::<ThinRule>(), default_value = "leave-out", hide_short_help = true, help_heading = "Advanced")]
    pub thin_rule: ThinRule,
    /// Treatment of points where the muscle would have to push, in the paper's method
    #[arg(long, value_parser = word::<SlackRule>(), default_value = "two-sided", hide_short_help = true, help_heading = "Advanced")]
    pub slack_rule: SlackRule,
    /// Write the intermediate tables of the paper's method (CSV and JSON) into a folder
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub tables: Option<PathBuf>,
    /// Write figures into a folder: figures 5 to 12 of the paper, or with `global` figure 12
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub plots: Option<PathBuf>,
    /// Write the formula
    #[arg(short, long, value_name = "FILE.json", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

pub fn run(args: &FitArgs, format: Format) -> Result<u8, Failure> {
    let target = args.output.as_deref();
    let Some(path) = &args.file else { return report::run(format, target) };
    check_ending(target, &["json"])?;
    let mut answer = mckibben_app::fit(&request(args, path)?, &Bar::new("steps"))?;
    if let Some(folder) = &args.tables {
        write_tables(folder, &mut answer)?;
    }
    if let Some(folder) = &args.plots {
        make(folder)?;
        for named in std::mem::take(&mut answer.figures) {
            let file = folder.join(format!("{}.svg", named.name));
            plot::save_as(named.figure, &file)?;
        }
    }
    save(target, answer.formula_file().as_bytes())?;
    show(&answer, format, "terms", || text::of(&answer, args.output.as_deref()), None)?;
    Ok(0)
}

fn request(args: &FitArgs, path: &Path) -> Result<FitRequest, Failure> {
    let parquet = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("parquet"));
    let campaign = path.is_dir() || parquet;
    Ok(FitRequest {
        table: if campaign { None } else { Some(files::table(path)?) },
        campaign: campaign.then(|| path.to_owned()),
        method: args.method,
        hold_out_mm: points("--hold-out", args.hold_out.as_deref(), Dimension::Length, 1)?
            .unwrap_or_default(),
        thin_rule: args.thin_rule,
        slack_rule: args.slack_rule,
        name: args.name.clone(),
        rubber: args.rubber.clone(),
        stiffness: args.stiffness.as_deref().map(stiffness).transpose()?,
        muscle: args.muscle.as_deref().map(files::muscle).transpose()?,
        tables: args.tables.is_some(),
        figures: args.plots.is_some(),
    })
}

fn make(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|e| Failure::unwritable(folder, &e))
}

/// All tables in one file.
#[derive(Serialize)]
struct Tables<'a> {
    method: &'a str,
    tables: Map<String, Value>,
}

fn write_tables(folder: &Path, answer: &mut FitAnswer) -> Result<(), Failure> {
    make(folder)?;
    let mut tables = Map::new();
    for table in std::mem::take(&mut answer.tables) {
        let file = folder.join(format!("{}.csv", table.name));
        save(Some(&file), table.to_csv().as_bytes())?;
        tables.insert(table.name.into(), table.to_value());
    }
    let method = answer.fitted.as_ref().map_or("", |f| &f.formula.provenance.method);
    let file = folder.join("tables.json");
    let text = format!("{:#}\n", json(&Tables { method, tables })?);
    save(Some(&file), text.as_bytes())
}
