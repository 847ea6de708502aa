//! `fit`: from a table of points to a formula.

mod report;
mod text;

pub use text::formula_text;

use crate::{Asked, Bar, Failure, check_ending, files, output::json, overwrite, save, save_inside};
use mckibben_app::{FitAnswer, FitRequest, NamedFigure};
use mckibben_report::FigureError;
use serde::Serialize;
use serde_json::{Map, Value};
use std::path::Path;

pub const TEXT: &str = "fit: Fit a formula to a table of finite-element points, with its errors and its range
Question:
:file<FILE>!^report | Table of points (CSV with columns outer_diameter_mm, wall_mm, length_mm, angle_deg, pressure_mpa, contraction, force_n, status)
report^method,hold_out_mm,thin_rule,slack_rule,name,rubber,stiffness,muscle,folder,plots | Compute the paper's campaign again and print all comparisons, without a table
method hold_out_mm name
Muscle: rubber stiffness<STIFFNESS> muscle
Advanced: thin_rule* slack_rule*
Output:
folder=tables<DIR> | Write the intermediate tables of the paper's method (CSV and JSON) into a folder
plots<DIR> | Write figures into a folder: figures 5 to 12 of the paper, or with `global` figure 12
o/output<FILE.json> | Write the formula
Examples:
  mckibben fit data/campaign/paper.csv --method paper --hold-out 35 \\
    -o formula.json --tables tables --plots plots
  mckibben fit data/campaign/paper.csv --method global --hold-out 35 \\
    -o global.json
  mckibben force -D 35 -s 2 -p 2bar -e 10% --model global.json
  mckibben fit --report";

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let target = asked.path("output");
    let Some(path) = asked.path("file") else { return report::run(asked) };
    check_ending(target.as_deref(), &["json"])?;
    let (tables, plots) = (asked.path("folder"), asked.path("plots"));
    let mut request: FitRequest = asked.request()?;
    if path.is_dir() || path.extension().is_some_and(|e| e.eq_ignore_ascii_case("parquet")) {
        request.campaign = Some(path);
    } else {
        request.table = Some(files::table(&path)?);
    }
    (request.tables, request.figures) = (tables.is_some(), plots.is_some());
    let mut answer = mckibben_app::fit(&request, &Bar::new("steps"))?;
    if let Some(folder) = &tables {
        write_tables(folder, &mut answer)?;
    }
    if let Some(folder) = &plots {
        let drawn = |named: &NamedFigure| Ok((format!("{}.svg", named.name), named.figure.to_svg()?));
        let figures = answer.figures.iter().map(drawn).collect::<Result<Vec<_>, FigureError>>()?;
        save_inside(folder, figures, overwrite())?;
    }
    save(target.as_deref(), answer.formula_file().as_bytes())?;
    asked.print(&answer, "terms", || text::of(&answer, target.as_deref()))
}

/// All tables in one file.
#[derive(Serialize)]
struct Tables<'a> {
    method: &'a str,
    tables: Map<String, Value>,
}

fn write_tables(folder: &Path, answer: &mut FitAnswer) -> Result<(), Failure> {
    let (mut tables, mut files) = (Map::new(), vec![]);
    for table in std::mem::take(&mut answer.tables) {
        files.push((format!("{}.csv", table.name), table.to_csv()));
        tables.insert(table.name.into(), table.to_value());
    }
    let method = answer.fitted.as_ref().map_or("", |f| &f.formula.provenance.method);
    files.push(("tables.json".into(), format!("{:#}\n", json(&Tables { method, tables })?)));
    save_inside(folder, files, overwrite())
}
