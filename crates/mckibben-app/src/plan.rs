//! `plan`: a plan of a moderate size, computed in memory; the table comes back as text. For front ends without files.

use crate::fields::TextFile;
use crate::fit::table::COLUMNS;
use crate::many::{AnswerColumns, Column};
use crate::problem::{Problem, ProblemKind};
use mckibben::progress::Progress;
use mckibben_campaign::PointRow;
use mckibben_campaign::campaign::{self, Plan};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;
use std::path::Path;

/// A plan to be computed.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct PlanRequest {
    /// The plan (TOML).
    pub plan: Option<TextFile>,
}

/// Its table.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
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

pub fn plan(request: &PlanRequest, progress: &dyn Progress) -> Result<PlanAnswer, Problem> {
    let (mut answer, rows) = computed(request, progress)?;
    let mut text = format!("{},status\n", COLUMNS.join(","));
    for r in &rows {
        let force = r.force_n.map_or_else(String::new, |f| f.to_string());
        let [d, s, l, a, p, e] = set(r);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{d},{s},{l},{a},{p},{e},{force},{}", r.status);
    }
    answer.table.text = text;
    Ok(answer)
}

/// The same as columns; the text of the answer's table is empty.
pub fn plan_columns(request: &PlanRequest, progress: &dyn Progress) -> Result<AnswerColumns, Problem> {
    let (answer, rows) = computed(request, progress)?;
    let mut numbers = COLUMNS.map(|_| Vec::with_capacity(rows.len()));
    for r in &rows {
        let force_n = r.force_n.unwrap_or(f64::NAN);
        numbers.iter_mut().zip(set(r).into_iter().chain([force_n])).for_each(|(list, v)| list.push(v));
    }
    let status = rows.iter().map(|r| Some(r.status.to_string())).collect();
    let numbers = COLUMNS.into_iter().zip(numbers.map(Column::Numbers));
    let wrong = |e: serde_json::Error| Problem::new(ProblemKind::Internal, e.to_string(), "");
    Ok(AnswerColumns {
        head: serde_json::to_value(&answer).map_err(wrong)?,
        columns: numbers.chain([("status", Column::Texts(status))]).collect(),
    })
}

/// What a row was asked for, in the order of [`COLUMNS`].
fn set(r: &PointRow) -> [f64; 6] {
    [r.outer_diameter_mm, r.wall_mm, r.length_mm, r.angle_deg, r.pressure_mpa, r.contraction]
}

/// The answer without the text of its table, and its rows.
fn computed(request: &PlanRequest, progress: &dyn Progress) -> Result<(PlanAnswer, Vec<PointRow>), Problem> {
    let file = request.plan.as_ref().ok_or_else(|| Problem::missing("plan", "a plan file (TOML)"))?;
    let plan = Plan::parse(&file.text).map_err(|e| e.of(Path::new(&file.name)))?;
    let points = plan.muscles().saturating_mul(plan.points_per_muscle() as u64);
    if points > MOST_POINTS {
        let message = format!("{points} points exceed the limit of {MOST_POINTS} points in memory");
        return Err(Problem::new(
            ProblemKind::Range,
            message,
            "`campaign` computes plans of any size, into files",
        ));
    }
    let rows = campaign::compute(&plan, progress)?;
    let name = Path::new(&file.name).file_stem().map_or("plan".into(), |stem| stem.to_string_lossy());
    let answer = PlanAnswer {
        table: TextFile { name: format!("{name}.csv"), text: String::new() },
        muscles: plan.muscles(),
        points: rows.len(),
        failed: rows.iter().filter(|r| r.force_n.is_none()).count(),
    };
    Ok((answer, rows))
}
