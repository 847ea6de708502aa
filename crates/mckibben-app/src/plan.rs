//! `plan`: a plan of a moderate size, computed in memory; the table comes back as text. For front
//! ends without files.

use crate::{COLUMNS, Problem, ProblemKind, Result, TextFile};
use mckibben_campaign::campaign::{self, Plan};
use mckibben_core::{muscle::file::FileError, progress::Progress};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::{fmt::Write as _, path::Path};

/// A plan to be computed.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct PlanRequest {
    /// The plan (TOML).
    pub plan: Option<TextFile>,
}

/// Its table.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlanAnswer {
    /// The table (CSV): what `fit` reads.
    pub table: TextFile,
    /// Muscles.
    pub muscles: u64,
    /// Points.
    pub points: usize,
    /// Points without an answer.
    pub failed: usize,
}

/// Most points of a plan in memory.
const MOST_POINTS: u64 = 200_000;

/// The plan of a request, and its file; a problem lists all mistakes of the plan.
pub fn plan_of<'a>(
    file: &'a Option<TextFile>,
    samples: &Option<TextFile>,
) -> Result<(Plan, &'a TextFile)> {
    let file = file
        .as_ref()
        .ok_or_else(|| Problem::missing("plan", "a plan file (TOML)"))?;
    let plan = Plan::check(&file.text, samples.as_ref().map(|table| &*table.text)).map_err(
        |mistakes| {
            let of_file = |m: FileError| m.in_file(Path::new(&file.name)).to_string();
            let mut each = mistakes.into_iter().map(of_file);
            let mut problem = ProblemKind::File.problem(each.next().unwrap_or_default());
            problem.further = each.collect();
            problem
        },
    )?;
    Ok((plan, file))
}

/// The command `campaign --dry-run`: size, cost and first rows of a plan.
pub fn plan(request: &PlanRequest, progress: &dyn Progress) -> Result<PlanAnswer> {
    let (plan, file) = plan_of(&request.plan, &None)?;
    let points = plan
        .muscles()
        .saturating_mul(plan.points_per_muscle() as u64);
    if points > MOST_POINTS {
        return Err(Problem::new(
            ProblemKind::Range,
            format!("{points} points exceed the limit of {MOST_POINTS} points in memory"),
            "`campaign` computes plans of any size, into files",
        ));
    }
    let rows = campaign::compute(&plan, progress)?;
    let mut text = format!("{},status\n", COLUMNS.join(","));
    for r in &rows {
        let force = r.force_n.map_or_else(String::new, |f| f.to_string());
        let d = r.outer_diameter_mm;
        let s = r.wall_mm;
        let l = r.length_mm;
        let a = r.angle_deg;
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{d},{s},{l},{a},{},{},{force},{}",
            r.pressure_mpa, r.contraction, r.status
        );
    }
    let name = Path::new(&file.name)
        .file_stem()
        .map_or("plan".into(), |stem| stem.to_string_lossy());
    Ok(PlanAnswer {
        table: TextFile {
            name: format!("{name}.csv"),
            text,
        },
        muscles: plan.muscles(),
        points: rows.len(),
        failed: rows.iter().filter(|r| r.force_n.is_none()).count(),
    })
}
