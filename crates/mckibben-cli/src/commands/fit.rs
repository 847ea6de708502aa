//! `fit`: from a table of points to a formula.

use crate::{
    Bar, Format, NO_ANSWER, Problem, Units, check_ending, listed, number, output::show, overwrite,
    pairs, place, print_text, save, save_inside, shown, tabled, value,
};
use mckibben::formula::Document;
use mckibben_app::{FitAnswer, FitReportRequest, FitRequest, NamedFigure, TextFile, fit_report};
use mckibben_campaign::fit::results::Results;
use mckibben_campaign::fit::signs::signs;
use mckibben_campaign::fit::{FittedFormula, PaperMethod};
use mckibben_report::FigureError;
use serde_json::{Map, Value, json};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// A formula from a table of points.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben fit data/campaign/paper.csv --method paper --hold-out 35 \\
    -o formula.json --tables tables --plots plots
  mckibben fit data/campaign/paper.csv --method global --hold-out 35 \\
    -o global.json
  mckibben force -D 35 -s 2 -p 2bar -e 10% --model global.json
  mckibben fit --report")]
pub struct Fit {
    /// Table of points (CSV with columns outer_diameter_mm, wall_mm, length_mm, angle_deg,
    /// pressure_mpa, contraction, force_n, status)
    #[arg(
        required_unless_present = "report",
        conflicts_with = "report",
        help_heading = "Question"
    )]
    file: Option<PathBuf>,
    /// Compute the paper's campaign again and print all comparisons, without a table
    #[arg(
        long,
        conflicts_with_all = [
            "method", "hold_out_mm", "thin_rule", "slack_rule", "name", "rubber", "stiffness",
            "muscle", "table_folder", "plots"
        ],
        help_heading = "Question"
    )]
    report: bool,
    #[command(flatten)]
    request: FitRequest,
    /// Write the intermediate tables of the paper's method (CSV and JSON) into a folder
    #[arg(
        id = "table_folder",
        long = "tables",
        value_name = "DIR",
        help_heading = "Output"
    )]
    tables: Option<PathBuf>,
    /// Write figures into a folder: figures 5 to 12 of the paper, or with `global` figure 12
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    plots: Option<PathBuf>,
    /// Write the formula
    #[arg(short, long, value_name = "FILE.json", help_heading = "Output")]
    output: Option<PathBuf>,
}

impl Fit {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        let target = self.output.as_deref();
        let Some(path) = self.file else {
            return report(target, format);
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
            write_tables(folder, &mut answer)?;
        }
        if let Some(folder) = &self.plots {
            let drawn =
                |named: &NamedFigure| Ok((format!("{}.svg", named.name), named.figure.to_svg()?));
            let figures = answer
                .figures
                .iter()
                .map(drawn)
                .collect::<Result<Vec<_>, FigureError>>()?;
            save_inside(folder, figures, overwrite())?;
        }
        save(target, answer.formula_file().as_bytes())?;
        print_text(format, &answer, "terms", |answer, _| {
            as_text(answer, target)
        })
    }
}

fn write_tables(folder: &Path, answer: &mut FitAnswer) -> Result<(), Problem> {
    let (mut tables, mut files) = (Map::new(), vec![]);
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
    save_inside(folder, files, overwrite())
}

/// What a formula is and where it holds.
const FORMULA: &str = "name kind form equation range made_for.length_mm=L0 made_for.angle_deg=θ0 \
    made_for.rubber.name=rubber made_for.rubber.law=law made_for.rubber.constants=constants \
    made_for.braid=braid provenance.method=method provenance.points=points provenance.table=table \
    provenance.data_hash=data provenance.plan_hash=plan provenance.version=mckibben";
const ERRORS: &str = "name=points_that_pull points=number muscles rms_of_blocked=rms:3% \
    p95_of_blocked=95_%_of_them:3% p99_of_blocked=99_%:3% max_of_blocked=largest:3% \
    max_of_isobar=(12):3% max_n=largest:3~";

/// A formula with its errors, and with its terms if `terms` is true. All is in the units of the
/// formula.
pub fn formula_text(formula: &Document, terms: bool) -> String {
    let (f, u) = (value(formula), Units::default());
    let mut out = pairs(&listed(&f, FORMULA, &u));
    if terms {
        let list = f["terms"].as_array().into_iter().flatten();
        out += &format!("\nTerms\n\n{}", tabled(list, "value:7~ unit name", &u));
    }
    let errors = &f["errors"];
    let against = errors["against"].as_str().unwrap_or_default();
    out + &format!(
        "\nErrors against {against}\n\n{}",
        tabled(error_rows(errors), ERRORS, &u)
    )
}

/// The errors of all points, of those that were left out, and by region.
fn error_rows(errors: &Value) -> Vec<Value> {
    let shown = |v: &Value| v.as_f64().map_or_else(String::new, |v| number(v, 4));
    let held_out = errors["held_out"]["outer_diameters_mm"]
        .as_array()
        .into_iter()
        .flatten();
    let held_out: Vec<String> = held_out.map(shown).collect();
    let named = [
        ("fit", "all fitted".to_owned()),
        ("held_out", format!("held out: D0 {}", held_out.join(", "))),
        ("left_out", "muscles left out, a fifth at a time".to_owned()),
    ];
    let mut rows: Vec<(String, Value)> =
        named.map(|(key, name)| (name, errors[key].clone())).into();
    for region in errors["regions"].as_array().into_iter().flatten() {
        let name = region["quantity"].as_str().unwrap_or_default();
        rows.push((
            format!("{name} {}", shown(&region["value"])),
            region.clone(),
        ));
    }
    rows.retain(|(_, row)| row.is_object());
    rows.iter_mut()
        .for_each(|(name, row)| row["name"] = std::mem::take(name).into());
    rows.into_iter().map(|(_, row)| row).collect()
}

/// A fitted formula, and where it was written.
fn as_text(answer: &FitAnswer, output: Option<&Path>) -> String {
    let mut out = formula_text(&answer.formula, answer.fitted.is_none());
    out.extend(
        answer
            .fitted
            .as_ref()
            .map(|fitted| intermediate(fitted, answer.failed)),
    );
    if let Some(path) = output {
        out.push_str(&format!(
            "\nThe formula is in {0}: --model {0}\n",
            place(path)
        ));
    }
    out
}

/// Intermediate results of a formula for muscles of one make.
fn intermediate(f: &FittedFormula, failed: usize) -> String {
    let mut out = format!(
        "\n{} points were not used, {failed} had no answer\n",
        f.unused
    );
    if let Some(g) = &f.global {
        out += &format!(
            "{} of {} candidate terms",
            g.terms.terms.len(),
            g.candidates
        );
        let step = g.steps.get(g.terms.terms.len().saturating_sub(1));
        let left_out = step.and_then(|step| step.left_out).map(|v| 100.0 * v);
        out.extend(left_out.map(|v| {
            format!(", chosen by rms {v:.3} % on inner diameters left out one at a time")
        }));
        out.push('\n');
    }
    out.extend(f.paper.as_ref().map(signs_text));
    out
}

/// R² of the steps, curves that a rule changed, and the signs of section 3.3.1.
fn signs_text(m: &PaperMethod) -> String {
    let smallest = |list: &mut dyn Iterator<Item = f64>| list.fold(1.0, f64::min);
    let steps = [
        (
            "F over ε (5)",
            smallest(&mut m.curves.iter().filter_map(|c| c.abc).map(|f| f.r2)),
        ),
        (
            "a, b, c over P (8)",
            smallest(&mut m.lines.iter().flat_map(|l| l.lines).map(|f| f.r2)),
        ),
        (
            "m, q over s (9)",
            smallest(
                &mut m
                    .walls
                    .iter()
                    .flat_map(|w| w.parabolas.into_iter().flatten())
                    .map(|f| f.r2),
            ),
        ),
        ("X over D0 (11)", smallest(&mut m.r2.into_iter().flatten())),
    ];
    let list: Vec<String> = steps
        .iter()
        .map(|(name, r2)| format!("{name} {r2:.4}"))
        .collect();
    let mut out = format!("\nSmallest R² of each step: {}\n", list.join("; "));
    for c in m.curves.iter().filter(|c| !c.rule.is_empty()) {
        let (d, s, p) = (c.outer_diameter_mm, c.wall_mm, c.pressure_mpa);
        out.push_str(&format!("Curve D0 {d}, s {s} mm at {p} MPa: {}\n", c.rule));
    }
    out.push_str(
        "\nSigns that section 3.3.1 of the paper states (pairs of neighbouring curves)\n\n",
    );
    let rows = signs(m).into_iter().map(|s| {
        json!({
            "outer_diameter_mm": s.outer_diameter_mm,
            "statement": format!("{} {} with {}", s.coefficient, if s.rises { "rises" } else { "falls" }, s.with),
            "pairs": format!("{} of {}", s.holding, s.pairs),
            "holds": s.holds(),
        })
    });
    out + &tabled(
        rows,
        "outer_diameter_mm=D0 statement pairs holds",
        &Units::default(),
    )
}

fn report(target: Option<&Path>, format: Format) -> Result<u8, Problem> {
    let answer = fit_report(&FitReportRequest {}, &Bar::new("steps"))?;
    let text = || report_text(&answer, &shown::units());
    show(&answer, format, "findings", text, target)?;
    Ok(if answer.findings.iter().all(|f| f.ok) {
        0
    } else {
        NO_ANSWER
    })
}

const FINDINGS: &str = "at_most_of_blocked=at_most:3~% max_of_blocked=largest:3% \
    rms_of_blocked=rms:3% max_of_isobar=(12):3% max_n=largest:3 points comparison \
    outer_diameter_mm=worst_at_D0 wall_mm=s pressure_mpa=P contraction=ε";

/// All is in the units of the formula.
fn report_text(r: &Results, _: &Units) -> String {
    let u = Units::default();
    let mut out = String::from(
        "In % of the finite elements' blocked force of the same muscle at 0.25 MPa, over points \
         where they pull\n\n",
    );
    out.push_str(&tabled(&r.findings, FINDINGS, &u));
    out += "\nRandom muscles of any size and material, where they pull, in % of the blocked force \
        at the same pressure\n\n";
    out + &tabled(&r.random_muscles, &format!("model {ERRORS}"), &u)
}
