//! Tables of points: CSV with the words of the contract, and campaigns on disk.

use super::file_name;
use crate::fields::TextFile;
use crate::problem::{Problem, ProblemKind};
use mckibben::formula::Made;
use mckibben_campaign::fit::data::FitPoint;
use std::path::Path;

/// What a table holds.
pub(super) struct Points {
    /// The answered points.
    pub(super) points: Vec<FitPoint>,
    /// Rows without an answer.
    pub(super) failed: usize,
    /// Rubber and braid, where the table says them.
    pub(super) made_for: Option<Made>,
    /// Where it comes from.
    pub(super) origin: Origin,
}

/// Where a table comes from.
pub(super) struct Origin {
    /// Its path or name, for messages.
    pub(super) name: String,
    /// Its name, for the formula.
    pub(super) table: Option<String>,
    /// Hash of the campaign's plan, where it is known.
    pub(super) plan_hash: Option<String>,
    /// Seed of the plan, where it has one.
    pub(super) seed: Option<u64>,
}

const COLUMNS: [&str; 7] =
    ["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "pressure_mpa", "contraction", "force_n"];

/// The rows of a campaign's file, or of its folder of parts.
#[cfg(feature = "files")]
pub(super) fn rows(path: &Path) -> Result<(Vec<mckibben_campaign::Row>, Origin), Problem> {
    let table = mckibben_campaign::campaign::rows(path)?;
    let origin = Origin {
        name: path.display().to_string(),
        table: file_name(path),
        plan_hash: Some(table.provenance().plan_sha256.clone()),
        seed: table.provenance().seed,
    };
    Ok((table.collect::<Result<_, _>>()?, origin))
}

/// The points of a campaign.
#[cfg(feature = "files")]
pub(super) fn of_campaign(path: &Path) -> Result<Points, Problem> {
    use mckibben_campaign::fit::{data::points, made_for};
    let (rows, origin) = rows(path)?;
    let points = points(&rows);
    let made_for = made_for(&rows).map_err(|e| Problem::new(ProblemKind::Fit, e.to_string(), ""))?;
    Ok(Points { failed: rows.len() - points.len(), points, made_for: Some(made_for), origin })
}

/// The points of a CSV table.
pub(super) fn of_csv(file: &TextFile) -> Result<Points, Problem> {
    let wrong = |message: String| {
        Problem::new(ProblemKind::Data, format!("{}: {message}", file.name), "a CSV file with a header")
    };
    let mut reader =
        csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(file.text.as_bytes());
    let header = reader.headers().map_err(|e| wrong(e.to_string()))?.clone();
    let place = |name: &str| header.iter().position(|h| h == name);
    let mut places = [0; 7];
    for (at, name) in places.iter_mut().zip(COLUMNS) {
        *at = place(name).ok_or_else(|| {
            wrong(format!("the column {name} is missing; needed are {}", COLUMNS.join(", ")))
        })?;
    }
    let status = place("status");
    let (mut points, mut failed) = (vec![], 0);
    for record in reader.records() {
        let record = record.map_err(|e| wrong(e.to_string()))?;
        if status.and_then(|i| record.get(i)).is_some_and(|s| s != "ok") {
            failed += 1;
            continue;
        }
        let line = record.position().map_or(0, csv::Position::line);
        let number = |k: usize| {
            let text = record.get(places[k]).unwrap_or_default();
            let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
            value.ok_or_else(|| wrong(format!("line {line}: {} is \"{text}\", not a number", COLUMNS[k])))
        };
        let above_zero = |k: usize| match number(k)? {
            v if v > 0.0 => Ok(v),
            _ => Err(wrong(format!("line {line}: {} must be above zero", COLUMNS[k]))),
        };
        points.push(FitPoint {
            outer_diameter_mm: above_zero(0)?,
            wall_mm: above_zero(1)?,
            length_mm: above_zero(2)?,
            angle_deg: above_zero(3)?,
            pressure_mpa: number(4)?,
            contraction: number(5)?,
            force_n: number(6)?,
        });
    }
    let (name, table) = (file.name.clone(), file_name(Path::new(&file.name)));
    Ok(Points { points, failed, made_for: None, origin: Origin { name, table, plan_hash: None, seed: None } })
}
