//! Tables of points: CSV with the words of the contract, and campaigns on disk.

use crate::{Problem, ProblemKind, TextFile};
use mckibben::formula::Made;
use mckibben_campaign::fit::data::FitPoint;
use mckibben_fit::measured::{DataPoint, PointOptions, read_points};
use std::path::Path;

/// What a table holds.
pub(super) struct Points {
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

/// What every row says of its muscle and its point, in this order.
pub(crate) const COLUMNS: [&str; 7] =
    ["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "pressure_mpa", "contraction", "force_n"];

/// The last part of a path or name.
pub(super) fn file_name(name: &Path) -> Option<String> {
    name.file_name().map(|n| n.to_string_lossy().into_owned())
}

/// The rows of a campaign's file, or of its folder of parts.
#[cfg(feature = "files")]
pub(super) fn rows(path: &Path) -> Result<(Vec<mckibben_campaign::PointRow>, Origin), Problem> {
    let table = mckibben_campaign::campaign::rows(path)?;
    let origin = Origin {
        name: path.display().to_string(),
        table: file_name(path),
        plan_hash: Some(table.provenance().plan_sha256.clone()),
        seed: table.provenance().seed,
    };
    Ok((table.collect::<Result<_, _>>()?, origin))
}

#[cfg(feature = "files")]
pub(super) fn of_campaign(path: &Path) -> Result<Points, Problem> {
    use mckibben_campaign::fit::{data::points, made_for};
    let (rows, origin) = rows(path)?;
    let points = points(&rows);
    let made_for = made_for(&rows).map_err(|e| Problem::new(ProblemKind::Fit, e.to_string(), ""))?;
    Ok(Points { failed: rows.len() - points.len(), points, made_for: Some(made_for), origin })
}

/// The points of a table, in any form that people write them; each row says all of its muscle.
pub(super) fn of_csv(file: &TextFile) -> Result<Points, Problem> {
    let (read, understood) = read_points(file.text.as_bytes(), &PointOptions::default())
        .map_err(|e| Problem::of_table(&file.name, &e))?;
    let point = |p: DataPoint| {
        let there = |name: &str, value: Option<f64>| {
            let message = format!("{}: line {}: {name} is missing", file.name, p.line);
            let hint = format!("every row needs {}", COLUMNS.join(", "));
            value.ok_or_else(|| Problem::new(ProblemKind::Data, message, hint))
        };
        Ok(FitPoint {
            outer_diameter_mm: there(COLUMNS[0], p.section.outer_diameter_mm)?,
            wall_mm: there(COLUMNS[1], p.section.wall_mm)?,
            length_mm: there(COLUMNS[2], p.section.length_mm)?,
            angle_deg: there(COLUMNS[3], p.section.angle_deg)?,
            pressure_mpa: p.at.pressure_mpa,
            contraction: p.at.contraction,
            force_n: p.at.force_n,
        })
    };
    let points = read.into_iter().map(point).collect::<Result<_, Problem>>()?;
    let (name, table) = (file.name.clone(), file_name(Path::new(&file.name)));
    let origin = Origin { name, table, plan_hash: None, seed: None };
    Ok(Points { points, failed: understood.left_out, made_for: None, origin })
}
