//! What a campaign will be: size, time and warnings, before it is run.

use super::{file::part, provenance::Provenance, run::RunOptions, table::Table};
use crate::{
    campaign::{
        error::Result,
        plan::{Inputs, Plan},
        solve,
        warnings::{Heeded, Warned, highest_mpa},
    },
    columns::PointRow,
    fit::{Fits, Fittable},
};
use mckibben_core::{
    cancel,
    formula::MadeRubber,
    model::{ForceModel, ThickWall, Workspace},
    muscle::Muscle,
    progress::Progress,
    status::Status,
    threads::Threads,
};
use schemars::JsonSchema;
use serde::Serialize;
use std::time::{Duration, Instant};

/// Muscles that are solved for a forecast.
const TRIED: u64 = 10;
/// No further one is begun after this time.
const PATIENCE: Duration = Duration::from_secs(10);
/// Muscles whose warnings are counted.
const CHECKED: u64 = 1000;

/// What a campaign will be, before it is run.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Forecast {
    /// The share of the plan, i/n; nothing where it is all of it.
    pub shard: Option<String>,
    /// Muscles of the plan, or of the share of it.
    pub muscles: u64,
    /// Points of each muscle.
    pub points_per_muscle: u64,
    /// Rows of the table.
    pub points: u64,
    /// The rubbers of its muscles, each with the one law that they all get.
    pub rubbers: Vec<MadeRubber>,
    /// Muscles that were solved for this forecast, spread over the plan.
    pub muscles_tried: u64,
    /// Their points without an answer.
    pub points_failed: u64,
    /// Threads.
    pub threads: usize,
    /// Time of the run on these threads of this machine in s, from the muscles that were solved.
    pub time_s: f64,
    /// Size of the table, from theirs.
    pub bytes: u64,
    /// Muscles whose warnings were counted by the thick-wall model at the highest pressure, spread
    /// over the plan.
    pub muscles_checked: u64,
    /// Those among them whose sizes make no muscle.
    pub muscles_impossible: u64,
    /// Warnings among the checked muscles, by their column.
    pub warnings: Vec<Warned>,
    /// What can be fitted to its table.
    #[serde(flatten)]
    pub fits: Fits,
    /// SHA-256 of the plan's text.
    pub plan_sha256: String,
}

/// Foresees a run of a plan.
///
/// # Errors
/// [`CampaignError`](crate::campaign::CampaignError) where the caller ends it.
pub fn forecast(plan: &Plan, options: &RunOptions, progress: &dyn Progress) -> Result<Forecast> {
    let provenance = Provenance::for_plan(plan);
    let parts: Vec<u64> = options.share(&provenance).collect();
    let numbers = || parts.iter().flat_map(|&part| provenance.muscles_of(part));
    let muscles = provenance.muscles_in(parts.iter().copied());
    let threads = options.threads.unwrap_or_else(|| Threads::shared().count());
    let spread = |most: u64| numbers().step_by(muscles.div_ceil(most).max(1) as usize);
    let tried = Tried::new(plan, &provenance, spread(TRIED), progress)?;
    let checked = Checked::new(plan, spread(CHECKED))?;
    let share = muscles as f64 / tried.muscles.max(1) as f64;
    Ok(Forecast {
        shard: options.shard.map(|shard| shard.to_string()),
        muscles,
        points_per_muscle: provenance.points_per_muscle,
        points: muscles * provenance.points_per_muscle,
        rubbers: plan.rubbers.iter().map(|r| (&r.rubber).into()).collect(),
        muscles_tried: tried.muscles,
        points_failed: tried.failed,
        threads,
        time_s: share * tried.time.as_secs_f64() / threads.min(parts.len()).max(1) as f64,
        bytes: (share * tried.bytes as f64) as u64,
        muscles_checked: checked.muscles,
        muscles_impossible: checked.impossible,
        warnings: checked.warnings,
        fits: checked.fittable.fits(),
        plan_sha256: provenance.plan_sha256,
    })
}

/// Muscles that were solved.
#[derive(Default)]
struct Tried {
    muscles: u64,
    failed: u64,
    time: Duration,
    /// Of their rows, without what a file has beside them.
    bytes: usize,
}

impl Tried {
    fn new(
        plan: &Plan,
        provenance: &Provenance,
        numbers: impl Iterator<Item = u64>,
        progress: &dyn Progress,
    ) -> Result<Self> {
        let empty = || Table::new(provenance.layout.fields());
        let mut out = Self::default();
        let mut table = empty();
        let from = Instant::now();
        for number in numbers {
            if out.muscles > 0 && from.elapsed() > PATIENCE {
                break;
            }
            progress.report(out.muscles as usize, TRIED as usize);
            let rows = solve::rows(plan, number);
            progress.check()?;
            for row in rows {
                out.failed += u64::from(!row.status.is_ok());
                table.push(row);
            }
            out.muscles += 1;
            out.time = from.elapsed();
        }
        out.bytes = part(provenance, 0, table)?.len() - part(provenance, 0, empty())?.len();
        Ok(out)
    }
}

/// Muscles whose warnings were counted.
struct Checked {
    muscles: u64,
    impossible: u64,
    warnings: Vec<Warned>,
    fittable: Fittable,
}

impl Checked {
    fn new(plan: &Plan, numbers: impl Iterator<Item = u64>) -> Result<Self> {
        let mut out = Self {
            muscles: 0,
            impossible: 0,
            warnings: Warned::none(),
            fittable: Fittable::default(),
        };
        for number in numbers {
            cancel::check()?;
            out.muscles += 1;
            let inputs = plan.inputs(number);
            let Ok(muscle) = inputs.muscle() else {
                out.impossible += 1;
                continue;
            };
            for mut row in highest_rows(plan, number, &inputs, &muscle) {
                Warned::count(&mut out.warnings, &mut row);
                if row.status.is_ok() {
                    out.fittable.add(&row);
                }
            }
        }
        Ok(out)
    }
}

/// The rows of a muscle at the highest pressure of a plan by the thick-wall model, with their
/// warnings alone.
fn highest_rows(plan: &Plan, number: u64, inputs: &Inputs, muscle: &Muscle) -> Vec<PointRow> {
    let model = ThickWall::between_ends(muscle);
    let heeded = Heeded::new(plan, inputs.data_to_stretch, muscle, &model);
    let pressure_mpa = highest_mpa(&plan.testing);
    let mut workspace = Workspace::new();
    let row = |contraction: f64| {
        let row = solve::blank(number, inputs, pressure_mpa, contraction);
        let row = heeded.at_pressure(row);
        match model.response(&mut workspace, pressure_mpa, contraction) {
            Ok(response) => heeded.of_answer(row, &response),
            Err(_) => PointRow {
                status: Status::NotConverged,
                ..row
            },
        }
    };
    solve::contractions(&plan.testing, inputs)
        .map(row)
        .collect()
}
