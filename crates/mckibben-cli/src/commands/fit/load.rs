//! Tables of points: campaigns in Parquet, and CSV with the words of the contract.

use crate::failure::Failure;
use mckibben::formula::Made;
use mckibben_campaign::campaign::rows;
use mckibben_campaign::fit::data::{FitPoint, points};
use mckibben_campaign::fit::made_for;
use std::path::Path;

/// What a table holds.
pub struct Loaded {
    /// The answered points.
    pub points: Vec<FitPoint>,
    /// Rows without an answer.
    pub failed: usize,
    /// Rubber and braid, where the table says them.
    pub made_for: Option<Made>,
    /// Hash of the campaign's plan, where it is known.
    pub plan_hash: Option<String>,
    /// Seed of the plan, where it has one.
    pub seed: Option<u64>,
}

const COLUMNS: [&str; 7] =
    ["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "pressure_mpa", "contraction", "force_n"];

/// The table in a file.
pub fn load(path: &Path) -> Result<Loaded, Failure> {
    let ending = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    if path.is_dir() || ending == "parquet" {
        return campaign(path);
    }
    let file = std::fs::File::open(path).map_err(|e| Failure::unreadable(path, &e))?;
    csv(path, file)
}

/// A campaign's file, or its folder of parts.
fn campaign(path: &Path) -> Result<Loaded, Failure> {
    let table = rows(path)?;
    let (plan_hash, seed) = (Some(table.provenance().plan_sha256.clone()), table.provenance().seed);
    let rows = table.collect::<Result<Vec<_>, _>>()?;
    let points = points(&rows);
    let made_for = Some(made_for(&rows)?);
    Ok(Loaded { failed: rows.len() - points.len(), points, made_for, plan_hash, seed })
}

fn csv(path: &Path, file: impl std::io::Read) -> Result<Loaded, Failure> {
    let wrong = |message: String| {
        Failure::input("data", format!("{}: {message}", path.display()), "a CSV file with a header")
    };
    let mut reader = ::csv::ReaderBuilder::new().comment(Some(b'#')).trim(::csv::Trim::All).from_reader(file);
    let header = reader.headers().map_err(|e| wrong(e.to_string()))?.clone();
    let place = |name: &str| header.iter().position(|h| h == name);
    let mut places = [0; 7];
    for (at, name) in places.iter_mut().zip(COLUMNS) {
        *at = place(name).ok_or_else(|| {
            wrong(format!("the column {name} is missing; needed are {}", COLUMNS.join(", ")))
        })?;
    }
    let status = place("status");
    let mut out = Loaded { points: vec![], failed: 0, made_for: None, plan_hash: None, seed: None };
    for record in reader.records() {
        let record = record.map_err(|e| wrong(e.to_string()))?;
        if status.and_then(|i| record.get(i)).is_some_and(|s| s != "ok") {
            out.failed += 1;
            continue;
        }
        let line = record.position().map_or(0, ::csv::Position::line);
        let number = |k: usize| {
            let text = record.get(places[k]).unwrap_or_default();
            let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
            value.ok_or_else(|| wrong(format!("line {line}: {} is \"{text}\", not a number", COLUMNS[k])))
        };
        let above_zero = |k: usize| {
            let v = number(k)?;
            if v > 0.0 {
                Ok(v)
            } else {
                Err(wrong(format!("line {line}: {} must be above zero", COLUMNS[k])))
            }
        };
        out.points.push(FitPoint {
            outer_diameter_mm: above_zero(0)?,
            wall_mm: above_zero(1)?,
            length_mm: above_zero(2)?,
            angle_deg: above_zero(3)?,
            pressure_mpa: number(4)?,
            contraction: number(5)?,
            force_n: number(6)?,
        });
    }
    Ok(out)
}
