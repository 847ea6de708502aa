//! `fit`: from a table of points to a formula.

mod report;
mod text;

pub use text::formula_text;

use crate::asked::Asked;
use crate::failure::Failure;
use crate::output::{check_ending, json, save};
use crate::progress::Bar;
use crate::{files, plot};
use mckibben_app::{FitAnswer, FitRequest};
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
        make(folder)?;
        for named in std::mem::take(&mut answer.figures) {
            plot::save_as(named.figure, &folder.join(format!("{}.svg", named.name)))?;
        }
    }
    save(target.as_deref(), answer.formula_file().as_bytes())?;
    asked.print(&answer, "terms", || text::of(&answer, target.as_deref()))
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
