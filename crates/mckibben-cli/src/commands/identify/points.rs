//! The points: files, formulas, branches, weights.

use crate::cli::{BranchesWord, IdentifyArgs};
use crate::failure::Failure;
use crate::flags::MuscleFlags;
use crate::kind::{Kind, MeshFlags};
use crate::resolve;
use mckibben::compare::MeasuredPoint;
use mckibben::identify::{DataPoint, Section, mean_of_branches, read_data};
use mckibben::model::Workspace;
use mckibben::muscle::Muscle;
use mckibben::units::Dimension;
use std::path::Path;

/// Diameters and walls of `--formula`, where they are lists.
pub struct Measures {
    diameters: Vec<Option<f64>>,
    walls: Vec<Option<f64>>,
}

/// The flags of the muscle, and what of them is a list for `--formula`.
pub fn measures(args: &IdentifyArgs) -> Result<(MuscleFlags, Measures), Failure> {
    let mut flags = args.muscle.clone();
    flags.muscle = args.file.clone().or(flags.muscle);
    let mut out = Measures { diameters: vec![None], walls: vec![None] };
    if args.formula.is_some() {
        let list = |flag: &str, text: &mut Option<String>| -> Result<Vec<Option<f64>>, Failure> {
            let Some(values) = resolve::values(flag, text.as_deref(), Dimension::Length)? else {
                return Ok(vec![None]);
            };
            let values = values.sampled(4);
            if values.len() < 2 {
                return Ok(vec![None]);
            }
            *text = None;
            Ok(values.into_iter().map(Some).collect())
        };
        out.diameters = list("--outer-diameter", &mut flags.outer_diameter)?;
        out.walls = list("--wall", &mut flags.wall)?;
    }
    Ok((flags, out))
}

/// All points, and where they come from.
pub fn read(
    args: &IdentifyArgs,
    muscle: &Muscle,
    measures: &Measures,
) -> Result<(Vec<DataPoint>, String), Failure> {
    let mut points: Vec<DataPoint> = vec![];
    let mut origin: Vec<String> = vec![];
    for path in &args.data {
        let set = origin.len();
        points.extend(file(path)?.into_iter().map(|p| DataPoint { set, ..p }));
        origin.push(path.display().to_string());
    }
    if let Some(name) = &args.formula {
        let set = origin.len();
        points.extend(formula(args, name, muscle, measures)?.into_iter().map(|p| DataPoint { set, ..p }));
        origin.push(format!("the formula {name}"));
    }
    if origin.is_empty() {
        let hint = "give --data FILE.csv with pressure_mpa, contraction and force_n, or --formula paper";
        return Err(Failure::input("missing_input", "there is nothing to identify from", hint));
    }
    weigh(args, &mut points, origin.len())?;
    if args.branches == BranchesWord::Mean {
        points = mean_of_branches(&points);
    }
    Ok((points, origin.join(", ")))
}

fn file(path: &Path) -> Result<Vec<DataPoint>, Failure> {
    let file = std::fs::File::open(path).map_err(|e| Failure::unreadable(path, &e))?;
    let meta = file.metadata().map_err(|e| Failure::unreadable(path, &e))?;
    if !meta.is_file() {
        return Err(Failure::input("file", format!("{} is not a file", path.display()), "give a CSV file"));
    }
    read_data(file).map_err(|e| Failure::measured(path, &e))
}

/// A formula's pulls as if they had been measured.
fn formula(
    args: &IdentifyArgs,
    name: &str,
    muscle: &Muscle,
    measures: &Measures,
) -> Result<Vec<DataPoint>, Failure> {
    let kind = Kind::parse(name, &MeshFlags::default())?;
    let pressures =
        resolve::points("--pressure", args.pressure.as_deref(), Dimension::Pressure, "0.05..0.25:0.05", 5)?;
    let contractions = resolve::contractions(args.contraction.as_deref(), "0..0.2:0.05")?;
    let count = [pressures.len(), contractions.len(), measures.diameters.len(), measures.walls.len()];
    let count = count.iter().fold(1usize, |a, b| a.saturating_mul(*b));
    if count > 100_000 {
        let message = format!("{count} points are more than 100000");
        return Err(Failure::input("range", message, "take larger steps"));
    }
    let mut points = vec![];
    for &outer_diameter_mm in &measures.diameters {
        for &wall_mm in &measures.walls {
            let section = Section { outer_diameter_mm, wall_mm, ..Section::default() };
            let model = kind.build(&section.apply(muscle)?)?;
            let w = &mut Workspace::new();
            for &contraction in &contractions {
                for &pressure_mpa in &pressures {
                    let force_n = model.force_n(w, pressure_mpa, contraction)?;
                    let at = MeasuredPoint { pressure_mpa, contraction, force_n, branch: None };
                    points.push(DataPoint { section, line: points.len() as u64 + 2, ..DataPoint::of(at) });
                }
            }
        }
    }
    Ok(points)
}

/// `--weights`: one number a set.
fn weigh(args: &IdentifyArgs, points: &mut [DataPoint], sets: usize) -> Result<(), Failure> {
    if args.weights.is_empty() {
        return Ok(());
    }
    if args.weights.len() != sets {
        let message = format!("--weights: {} numbers for {sets} sets of data", args.weights.len());
        return Err(Failure::input("usage", message, "one for each --data, then one for --formula"));
    }
    let mut factors = vec![];
    for text in &args.weights {
        let w = resolve::quantity("--weights", Some(text), Dimension::Ratio)?.unwrap_or(1.0);
        if w < 0.0 {
            let message = format!("--weights: {w} is below zero");
            return Err(Failure::input("usage", message, "a weight of 0 leaves a set out"));
        }
        factors.push(w);
    }
    for p in points {
        p.weight *= factors.get(p.set).copied().unwrap_or(1.0);
    }
    Ok(())
}
