//! A motion back and forth: the air that it takes, and the valve.

use super::{answer::muscle_file, request::DesignRequest};
use crate::{MotionRequest, Problem, ProblemKind, Result, StepFields, above_zero, motion, number};
use mckibben_core::{
    by_number::ByNumber,
    extremes::peak,
    load::GRAVITY_M_PER_S2,
    progress::Progress,
    units::typed::{Pressure, Time},
};
use mckibben_design::{Candidate, Spec};
use mckibben_motion::{NamedValve, valves};
use schemars::JsonSchema;
use serde::Serialize;

/// Share of a period within which the muscle rises (10 to 90 %).
const RISE: f64 = 0.25;
/// Sonic conductance from which the search of a valve begins, L/(s bar).
const FIRST: &str = "1 L/(s bar)";

/// The air that a motion back and forth takes, and the valve.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CycleAnswer {
    /// Strokes a second.
    pub frequency_hz: f64,
    /// Air of all muscles, normal litres a minute.
    pub air_normal_litres_per_min: Option<f64>,
    /// Sonic conductance of the valve of each muscle, at least, with which it rises within a
    /// quarter of the period, L/(s bar).
    pub sonic_conductance_l_per_s_bar: Option<f64>,
    /// The smallest valve of the catalogue that has it.
    pub valve: Option<String>,
    /// Why there is none.
    pub reason: Option<String>,
}

impl DesignRequest {
    /// Of the best muscle: a mass of the required weight is lifted from its stop.
    pub fn cycle_of(
        &self,
        winner: &Candidate,
        spec: &Spec,
        progress: &dyn Progress,
    ) -> Result<Option<CycleAnswer>> {
        let Some(frequency) = self.cycle_hz else {
            return Ok(None);
        };
        let frequency_hz = above_zero(ProblemKind::Range, "cycle_hz", frequency)?;
        if spec.wanted.joint().is_some() || spec.liquid.is_some() {
            return Err(Problem::usage(
                "`cycle_hz` sizes the valve of muscles that air fills, without a joint",
                "`motion` computes a drive",
            ));
        }
        let force_n = peak(winner.points.iter().map(|q| q.required_n));
        let step = StepFields {
            pressure_mpa: Some(Pressure(winner.pressure_mpa)),
            load: Some(format!("mass:{}kg", force_n / GRAVITY_M_PER_S2)),
            valve: Some(FIRST.into()),
            supply_mpa: Some(Pressure(spec.max_pressure_mpa)),
            until_s: Some(Time(2.0 / frequency_hz)),
            ..StepFields::default()
        };
        let sized = motion(
            &MotionRequest {
                step: Some(step),
                rise_time_s: Some(Time(RISE / frequency_hz)),
                muscle: Some(muscle_file(0, winner, spec)),
                model: self.model.clone(),
                ..MotionRequest::default()
            },
            progress,
        );
        let (needed, reason) = match sized {
            Ok(answer) => (answer.sonic_conductance_l_per_s_bar, None),
            Err(problem) if problem.kind == ProblemKind::Cancelled => return Err(problem),
            Err(problem) => (None, Some(problem.message)),
        };
        let size = |v: &&NamedValve| v.supply.conductance_l_per_s_bar;
        let is_enough = |v: &&NamedValve| needed.is_some_and(|c| size(v) >= c);
        let valve = valves().iter().filter(is_enough).min_by_number(size);
        Ok(Some(CycleAnswer {
            frequency_hz,
            air_normal_litres_per_min: winner
                .largest(|q| q.air_normal_litres)
                .map(|litres| 60.0 * frequency_hz * litres * f64::from(winner.count)),
            sonic_conductance_l_per_s_bar: needed,
            valve: valve.map(|v| v.name.clone()),
            reason,
        }))
    }
}

impl CycleAnswer {
    /// The line of the decision.
    pub fn line(&self) -> String {
        let air = self.air_normal_litres_per_min.map(|l| number(l, 3));
        let air = air.map(|l| format!(": {l} normal L of air a minute"));
        let valve = match self.sonic_conductance_l_per_s_bar {
            Some(c) => {
                let size = number(c, 3);
                let name = match &self.valve {
                    Some(name) => format!(" ({name})"),
                    None => ", and none of the catalogue has it".into(),
                };
                format!("a valve of {size} L/(s bar) or more{name}")
            }
            None => {
                let reason = self.reason.as_deref().unwrap_or_default();
                format!("no valve is quick enough: {reason}")
            }
        };
        format!(
            "Cycles {} a second{}; {valve}",
            number(self.frequency_hz, 3),
            air.unwrap_or_default()
        )
    }
}
