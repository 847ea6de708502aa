//! What to mind about a row: as columns, so that a table can be filtered by them.

use super::plan::{Plan, Testing};
use crate::columns::{COLUMNS, Column, PointRow, Role, Slot};
use mckibben_core::{
    analysis::{Burst, NoBurst, SAFETY, burst_below},
    built::not_measured,
    extremes::peak,
    model::{ForceModel, Response},
    muscle::Muscle,
    warning::VALIDATED_STRAND_STRAIN,
};
use schemars::JsonSchema;
use serde::Serialize;

/// What the warnings of one muscle's rows need.
pub struct Heeded<'m> {
    muscle: &'m Muscle,
    burst: Burst,
    /// The stretch up to which the constants of its rubber have data.
    data_to_stretch: Option<f64>,
}

impl<'m> Heeded<'m> {
    /// The muscle of a model, at the pressures of a plan.
    pub fn new(
        plan: &Plan,
        data_to_stretch: Option<f64>,
        muscle: &'m Muscle,
        model: &dyn ForceModel,
    ) -> Self {
        let highest_mpa = highest_mpa(&plan.testing);
        Self {
            muscle,
            // Beyond it nothing is forbidden at the plan's pressures.
            burst: burst_below(model, highest_mpa, SAFETY)
                .unwrap_or(Burst::unknown(NoBurst::NO_ANSWER)),
            data_to_stretch,
        }
    }

    /// A row with what is known of its pressure, whether it has an answer or not.
    pub fn at_pressure(&self, row: PointRow) -> PointRow {
        let pressure_mpa = row.pressure_mpa;
        let known = self.burst.not_checked().is_none();
        let over = |limit: Option<f64>| match limit {
            Some(limit_mpa) if pressure_mpa >= limit_mpa => Some(true),
            _ => known.then_some(false),
        };
        let mut outside = not_measured(self.muscle, pressure_mpa);
        PointRow {
            warning_burst: over(self.burst.least().map(|(_, mpa)| mpa)),
            warning_allowed_pressure: over(self.burst.allowed().map(|most| most.mpa.next_up())),
            warning_not_measured: Some(outside.next().is_some()),
            ..row
        }
    }

    /// The same with what an answer says.
    pub fn of_answer(&self, row: PointRow, response: &Response) -> PointRow {
        let strain = response
            .braid_tension_n
            .and_then(|tension_n| self.muscle.strand_strain(tension_n));
        let beyond = response.rubber_stretch().zip(self.data_to_stretch);
        PointRow {
            warning_strand_strain: strain.map(|strain| strain > VALIDATED_STRAND_STRAIN),
            warning_rubber_stretch: beyond.map(|(stretch, data)| stretch > data),
            ..row
        }
    }
}

/// The highest pressure of a plan in MPa.
pub fn highest_mpa(testing: &Testing) -> f64 {
    peak(testing.pressures_mpa.iter().copied())
}

/// How often a warning stands in rows.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, JsonSchema)]
pub struct Warned {
    /// Its column.
    pub name: String,
    /// Muscles that have it at some of their points.
    pub muscles: u64,
    /// Points that have it.
    pub points: u64,
    /// Points with an answer of which it is not known.
    pub points_unknown: u64,
    #[serde(skip)]
    last_muscle: Option<u64>,
}

/// The columns of warnings.
fn columns() -> impl Iterator<Item = &'static Column> {
    COLUMNS.iter().filter(|c| c.role == Role::Warning)
}

impl Warned {
    /// One for each column of warnings.
    pub fn none() -> Vec<Self> {
        let named = |column: &Column| Self {
            name: column.name.into(),
            ..Self::default()
        };
        columns().map(named).collect()
    }

    /// Counts a row, with those of its muscle one after another.
    pub fn count(all: &mut [Self], row: &mut PointRow) {
        let answered = row.status.is_ok();
        let muscle = Some(row.muscle);
        for (warned, column) in all.iter_mut().zip(columns()) {
            let Slot::Flag(flag) = (column.slot)(row) else {
                continue;
            };
            match *flag {
                Some(true) => {
                    warned.points += 1;
                    warned.muscles += u64::from(warned.last_muscle != muscle);
                    warned.last_muscle = muscle;
                }
                Some(false) => {}
                None => warned.points_unknown += u64::from(answered),
            }
        }
    }
}
