//! `fit`: from a table of points to a formula.

use crate::{Bar, Context, NO_ANSWER, Problem, check_ending, examples::examples, path_on_one_line};
use mckibben_app::{
    FitAnswer, FitReportRequest, FitRequest, NamedFigure, TextFile, fit_report, print::Page,
};
use serde_json::{Map, json};
use std::{
    ffi::OsStr,
    path::{Path, PathBuf},
};

/// A formula from a table of points.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "fit data/campaign/paper.csv --method paper --hold-out 35 -o formula.json --tables tables --plots plots",
    "fit data/campaign/paper.csv --method global --hold-out 35 -o global.json",
    "force -D 35 -s 2 -p 2bar -e 10% --model global.json",
    "fit --report"
]))]
pub struct Fit {
    /// Table of points (CSV with columns outer_diameter_mm, wall_mm, length_mm, angle_deg,
    /// pressure_mpa, contraction, force_n, status)
    #[arg(required_unless_present = "report", conflicts_with = "report")]
    file: Option<PathBuf>,
    /// Compute the paper's campaign again and print all comparisons, without a table
    #[arg(
        long,
        conflicts_with_all = [
            "method", "hold_out_mm", "hold_out_share", "thin_rule", "slack_rule", "name", "rubber", "stiffness",
            "muscle", "tables", "plots"
        ]
    )]
    report: bool,
    #[command(flatten)]
    request: FitRequest,
    /// Write the intermediate tables of the paper's method (CSV and JSON) into a folder
    #[arg(
        id = "tables",
        long = "tables",
        value_name = "DIR",
        help_heading = "Output"
    )]
    tables: Option<PathBuf>,
    /// Write figures into a folder: figures 5 to 12 of the paper, or with `global` figure 12
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    plots: Option<PathBuf>,
    /// Formats of the figures
    #[arg(
        long,
        value_delimiter = ',',
        value_parser = ["svg", "png", "pdf"],
        default_value = "svg",
        help_heading = "Output"
    )]
    plots_format: Vec<String>,
    /// Write the formula
    #[arg(short, long, value_name = "FILE.json", help_heading = "Output")]
    output: Option<PathBuf>,
}

impl Fit {
    pub fn run(self, context: &Context) -> Result<u8, Problem> {
        let target = self.output.as_deref();
        let Some(path) = self.file else {
            return report(target, context);
        };
        check_ending(target, &["json"])?;
        let mut request = self.request;
        let is_campaign = |end: &OsStr| end.eq_ignore_ascii_case("parquet");
        if path.is_dir() || path.extension().is_some_and(is_campaign) {
            request.campaign = Some(path);
        } else {
            request.table = Some(TextFile::table(&path)?);
        }
        (request.tables, request.figures) = (self.tables.is_some(), self.plots.is_some());
        let mut answer = mckibben_app::fit(&request, &Bar::new("steps"))?;
        if let Some(folder) = &self.tables {
            write_tables(folder, &mut answer, context)?;
        }
        if let Some(folder) = &self.plots {
            let mut figures = vec![];
            for NamedFigure { name, figure } in &answer.figures {
                for ending in &self.plots_format {
                    let file = PathBuf::from(format!("{name}.{ending}"));
                    let bytes = figure.bytes(&file)?;
                    figures.push((file, bytes));
                }
            }
            context.save_inside(folder, figures)?;
        }
        context.save(target, answer.formula_file().as_bytes())?;
        let add = |page: &mut Page| {
            if let Some(path) = target.map(path_on_one_line) {
                page.paragraph(format!("The formula is in {path}: --model {path}"));
            }
        };
        context.print(&answer, add, None)?;
        Ok(0)
    }
}

fn write_tables(folder: &Path, answer: &mut FitAnswer, context: &Context) -> Result<(), Problem> {
    let mut tables = Map::new();
    let mut files = vec![];
    for table in std::mem::take(&mut answer.tables) {
        files.push((format!("{}.csv", table.name), table.to_csv()));
        tables.insert(table.name.into(), table.to_value());
    }
    let method = answer
        .fitted
        .as_ref()
        .map_or("", |f| &f.formula.provenance.method);
    files.push((
        "tables.json".into(),
        format!("{:#}\n", json!({ "method": method, "tables": tables })),
    ));
    context.save_inside(folder, files)
}

/// The paper's results, computed again.
fn report(target: Option<&Path>, context: &Context) -> Result<u8, Problem> {
    let answer = fit_report(&FitReportRequest {}, &Bar::new("steps"))?;
    context.print(&answer, |_| (), target)?;
    Ok(if answer.findings.iter().all(|f| f.ok) {
        0
    } else {
        NO_ANSWER
    })
}
