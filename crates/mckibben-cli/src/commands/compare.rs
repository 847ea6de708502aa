//! `compare`: models, and measured points.

use crate::cli::{BranchWord, CompareArgs};
use crate::failure::Failure;
use crate::figure;
use crate::flags::{Format, PressureUnit};
use crate::kind::{Kind, MeshFlags};
use crate::output::text::{Pressures, muscle_line, number, percent, table};
use crate::output::{csv, emit, json};
use crate::resolve;
use mckibben::answer::Options;
use mckibben::compare::{Comparison, MeasuredPoint, compare, mean_of_branches, read_measured};
use mckibben::identify::{
    DataPoint, Identification, Identified, Parameter, Request, Target, identify, matters, own_value,
};
use mckibben::least_squares::Loss;
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::{Direction, Muscle};
use mckibben::units::Dimension;
use serde_json::{Value, json};
use std::path::Path;

/// A model that could not be compared, and why.
type Skipped = (&'static str, Failure);

struct Row {
    model: Box<dyn ForceModel>,
    comparison: Comparison,
    fit: Option<Identification>,
}

/// Runs the command.
pub fn run(args: &CompareArgs) -> Result<u8, Failure> {
    figure::check(args.plot.plot.as_deref())?;
    let muscle = resolve::muscle(&args.muscle)?;
    let kinds = kinds(args)?;
    resolve::motion(&args.asking, &muscle)?;
    let options = resolve::options(&args.asking);
    let measured = match &args.data {
        Some(path) => Some(chosen_branch(read(path)?, args.branch, path)?),
        None => None,
    };
    let p_unit = args.output.units.or(PressureUnit::typed(args.pressure.as_deref()));
    let p = Pressures(p_unit.unwrap_or(PressureUnit::Mpa));
    let (pressures, contractions) = grid(args, measured.as_deref())?;
    let (rows, skipped) = match &measured {
        Some(points) => against_points(args, &kinds, &muscle, options, points)?,
        None => against_first(&kinds, &muscle, options, &pressures, &contractions),
    };
    if rows.is_empty() {
        let first = skipped.into_iter().next().map(|s| s.1);
        return Err(first.unwrap_or_else(|| Failure::input("usage", "no model to compare", "")));
    }
    if let Some(path) = &args.plot.plot {
        let models: Vec<&dyn ForceModel> = rows.iter().map(|row| row.model.as_ref()).collect();
        let points = measured.as_deref().unwrap_or(&[]);
        let fits = rows
            .iter()
            .filter_map(|r| Some(format!(". {} fitted: {}", r.comparison.model, fit_text(r.fit.as_ref()?))));
        let about = format!("{}{}", muscle_line(&muscle), fits.collect::<String>());
        figure::compare(&models, points, &pressures, &contractions, options, &about, p).save(path)?;
    }
    let list: Vec<Value> = rows.iter().map(as_json).chain(skipped.iter().map(skipped_json)).collect();
    let text = match args.output.format {
        Format::Json => {
            let reference = if measured.is_some() { "measured" } else { rows[0].model.name() };
            let points = measured.as_ref().map_or(pressures.len() * contractions.len(), Vec::len);
            json::print(
                &json!({ "reference": reference, "points": points, "muscle": json::muscle(&muscle), "models": list }),
            )
        }
        Format::Csv => csv::rows(&list)?,
        Format::Text => as_text(args, &rows, &skipped, &muscle, measured.as_deref()),
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(0)
}

fn kinds(args: &CompareArgs) -> Result<Vec<Kind>, Failure> {
    let names: Vec<&str> = match (&args.model, args.models.as_slice()) {
        (Some(one), _) => vec![one],
        (None, []) => vec!["fe", "paper", "thick-wall", "ideal"],
        (None, list) => list.iter().map(String::as_str).collect(),
    };
    let mesh = args.asking.mesh_flags();
    let solid = names.iter().any(|n| Kind::has_terminal(n));
    let mut kinds: Vec<Kind> = vec![];
    for name in names {
        // A terminal is for fe3d alone, where that is among them.
        let terminal = mesh.terminal.filter(|_| !solid || Kind::has_terminal(name));
        let kind = Kind::parse(name.trim(), &MeshFlags { terminal, ..mesh })?;
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    Ok(kinds)
}

fn read(path: &Path) -> Result<Vec<MeasuredPoint>, Failure> {
    let file = std::fs::File::open(path).map_err(|e| Failure::unreadable(path, &e))?;
    let meta = file.metadata().map_err(|e| Failure::unreadable(path, &e))?;
    if !meta.is_file() {
        return Err(Failure::input("file", format!("{} is not a file", path.display()), "give a CSV file"));
    }
    read_measured(file).map_err(|e| Failure::measured(path, &e))
}

fn chosen_branch(
    points: Vec<MeasuredPoint>,
    word: BranchWord,
    path: &Path,
) -> Result<Vec<MeasuredPoint>, Failure> {
    let wanted = match word {
        BranchWord::Mean => return Ok(mean_of_branches(&points)),
        BranchWord::Contraction => Direction::Contraction,
        BranchWord::Elongation => Direction::Elongation,
    };
    let list: Vec<MeasuredPoint> = points.into_iter().filter(|p| p.branch == wanted).collect();
    if list.is_empty() {
        let message = format!("{} has no points of that branch", path.display());
        return Err(Failure::input(
            "data",
            message,
            "its column `branch` must say contraction or elongation",
        ));
    }
    Ok(list)
}

/// Pressures and contractions of the figure (and of the comparison without data).
fn grid(args: &CompareArgs, measured: Option<&[MeasuredPoint]>) -> Result<(Vec<f64>, Vec<f64>), Failure> {
    match measured {
        Some(points) => {
            let mut pressures: Vec<f64> = points.iter().map(|m| m.pressure_mpa).collect();
            pressures.sort_by(f64::total_cmp);
            pressures.dedup();
            let ends = points.iter().map(|m| m.contraction);
            let (low, high) = ends.fold((0.0_f64, 0.0_f64), |(a, b), e| (a.min(e), b.max(e)));
            Ok((pressures, (0..=100).map(|i| low + (high - low) * f64::from(i) / 100.0).collect()))
        }
        None => Ok((
            resolve::points(
                "--pressure",
                args.pressure.as_deref(),
                Dimension::Pressure,
                "0.05..0.25:0.05",
                5,
            )?,
            resolve::contractions(args.contraction.as_deref(), "0..0.2:0.01")?,
        )),
    }
}

fn against_points(
    args: &CompareArgs,
    kinds: &[Kind],
    muscle: &Muscle,
    options: Options,
    points: &[MeasuredPoint],
) -> Result<(Vec<Row>, Vec<Skipped>), Failure> {
    let targets = targets(&args.fit)?;
    let one = |kind: Kind| -> Result<Row, Failure> {
        let build = |m: &Muscle| kind.build(m);
        let data: Vec<DataPoint> =
            points.iter().map(|p| DataPoint::of(MeasuredPoint { branch: options.direction, ..*p })).collect();
        let mut fitted = None;
        if !targets.is_empty() && targets.iter().all(|t| matters(muscle, *t, &data, build)) {
            let start = |t: &Target| Some(own_value(muscle, *t).unwrap_or(STIFF));
            let free: Vec<Parameter> =
                targets.iter().map(|t| Parameter { start: start(t), ..Parameter::free(*t) }).collect();
            let (n, least) = (points.len(), 2 * free.len() + 1);
            if n < least {
                let unknowns = free.len();
                let message =
                    format!("{n} points are too few to fit {unknowns} constants: measure at least {least}");
                return Err(Failure::input("fit", message, ""));
            }
            let request = Request {
                muscle,
                free: &free,
                fixed: &[],
                points: &data,
                loss: Loss::Squares,
                two_sided: true,
            };
            fitted = Some(identify(&request, build)?);
        }
        let model = kind.build(fitted.as_ref().map_or(muscle, |f| &f.muscle))?;
        let comparison = compare(model.as_ref(), &mut Workspace::new(), points, options)?;
        Ok(Row { model, comparison, fit: fitted })
    };
    let (mut rows, mut skipped) = (vec![], vec![]);
    for &kind in kinds {
        match one(kind) {
            Ok(row) => rows.push(row),
            Err(failure) => skipped.push((kind.name(), failure)),
        }
    }
    Ok((rows, skipped))
}

/// k in N/mm from which a fit begins where the strands do not stretch.
const STIFF: f64 = 1e5;

/// What `--fit` takes.
const FITTED: [(&str, Target); 3] =
    [("modulus", Target::Modulus), ("end-factor", Target::EndFactor), ("stiffness", Target::Stiffness)];

fn targets(words: &[String]) -> Result<Vec<Target>, Failure> {
    let known: Vec<&str> = FITTED.iter().map(|n| n.0).collect();
    words
        .iter()
        .map(|word| {
            FITTED.iter().find(|n| n.0 == word.trim()).map(|n| n.1).ok_or_else(|| {
                Failure::input(
                    "usage",
                    format!("--fit: \"{word}\" cannot be fitted"),
                    format!("one of {}", known.join(", ")),
                )
            })
        })
        .collect()
}

/// Without data: every model against the first.
fn against_first(
    kinds: &[Kind],
    muscle: &Muscle,
    options: Options,
    pressures: &[f64],
    contractions: &[f64],
) -> (Vec<Row>, Vec<Skipped>) {
    let (mut rows, mut skipped): (Vec<Row>, Vec<Skipped>) = (vec![], vec![]);
    let mut points: Vec<MeasuredPoint> = vec![];
    for &kind in kinds {
        let one = || -> Result<(Row, Vec<MeasuredPoint>), Failure> {
            let model = kind.build(muscle)?;
            // The first model that answers is what the others are held against.
            let reference = if rows.is_empty() {
                answers(model.as_ref(), pressures, contractions, options)?
            } else {
                points.clone()
            };
            let comparison = compare(model.as_ref(), &mut Workspace::new(), &reference, options)?;
            Ok((Row { model, comparison, fit: None }, reference))
        };
        match one() {
            Ok((row, reference)) => {
                points = reference;
                rows.push(row);
            }
            Err(failure) => skipped.push((kind.name(), failure)),
        }
    }
    (rows, skipped)
}

/// A model's own answers, as if they had been measured.
fn answers(
    model: &dyn ForceModel,
    pressures: &[f64],
    contractions: &[f64],
    options: Options,
) -> Result<Vec<MeasuredPoint>, Failure> {
    let w = &mut Workspace::new();
    let mut points = vec![];
    for &pressure_mpa in pressures {
        for &contraction in contractions {
            let force_n =
                mckibben::answer::point(model, w, pressure_mpa, contraction, options)?.response.force_n;
            points.push(MeasuredPoint { pressure_mpa, contraction, force_n, branch: Direction::Mean });
        }
    }
    Ok(points)
}

fn skipped_json((name, failure): &Skipped) -> Value {
    json!({ "model": name, "rms_n": null, "max_n": null, "cause": failure.message })
}

fn as_json(row: &Row) -> Value {
    let c = &row.comparison;
    let mut out = json!({
        "model": c.model, "rms_n": c.rms_n, "max_n": c.max_n, "mean_n": c.mean_n, "points": c.points,
        "unanswered": c.unanswered.as_ref().map_or(0, |u| u.0),
        "cause": c.unanswered.as_ref().map(|u| u.1.clone()),
    });
    if let (Some(map), Some(fit)) = (out.as_object_mut(), &row.fit) {
        for Identified { target, value, .. } in &fit.parameters {
            let key = match target {
                Target::Modulus => "fitted_modulus_factor",
                Target::EndFactor => "fitted_end_factor",
                _ => "fitted_stiffness_n_per_mm",
            };
            map.insert(key.into(), json!(value));
        }
    }
    out
}

fn as_text(
    args: &CompareArgs,
    rows: &[Row],
    skipped: &[Skipped],
    muscle: &Muscle,
    measured: Option<&[MeasuredPoint]>,
) -> String {
    let mut out = format!("{}\n", muscle_line(muscle));
    match (measured, &args.data) {
        (Some(points), Some(path)) => {
            let largest = points.iter().map(|m| m.force_n).fold(0.0, f64::max);
            let which =
                if args.branch == BranchWord::Mean { " (mean of the branches where both stand)" } else { "" };
            out.push_str(&format!(
                "against {} points of {}{which}, largest {} N\n\n",
                points.len(),
                path.display(),
                number(largest, 4)
            ));
        }
        _ => out.push_str(&format!("against the model {}\n\n", rows[0].model.name())),
    }
    let header = ["model", "rms [N]", "largest [N]", "mean [N]", "points"];
    let table_rows = rows.iter().map(|row| {
        let c = &row.comparison;
        vec![
            c.model.clone(),
            number(c.rms_n, 3),
            number(c.max_n, 3),
            number(c.mean_n, 3),
            c.points.to_string(),
        ]
    });
    out.push_str(&table(&header, table_rows.collect()));
    out.push_str("\nmean: above zero where the model promises too much\n");
    for (name, failure) in skipped {
        out.push_str(&format!("{name}: not compared: {}\n", failure.message));
    }
    for row in rows {
        if let Some(fit) = &row.fit {
            out.push_str(&format!("{}: fitted {}\n", row.comparison.model, fit_text(fit)));
        } else if !args.fit.is_empty() {
            out.push_str(&format!("{}: nothing of --fit to fit, taken as it is\n", row.comparison.model));
        }
        if let Some((n, cause)) = &row.comparison.unanswered {
            let share = *n as f64 / (n + row.comparison.points) as f64;
            out.push_str(&format!(
                "{}: {n} points ({}) not answered: {cause}\n",
                row.comparison.model,
                percent(share)
            ));
        }
    }
    out
}

fn fit_text(fit: &Identification) -> String {
    let one = |Identified { target, value, .. }: &Identified| match target {
        Target::Modulus => format!("modulus × {}", number(*value, 4)),
        Target::EndFactor => format!("end factor {}", number(*value, 4)),
        _ => format!("stiffness {} N/mm", number(*value, 4)),
    };
    fit.parameters.iter().map(one).collect::<Vec<_>>().join(", ")
}
