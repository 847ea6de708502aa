//! The burst pressure in answers: one value for each muscle and model, and the sentence that comes
//! before all others.

use crate::{Model, Problem, ProblemKind, Units, number, print::Rows};
use mckibben_build::highest_mpa;
pub use mckibben_core::analysis::QUIET_MPA;
use mckibben_core::{
    analysis::{AnalysisError, Burst, FailureMode, FailurePressure, NoBurst, burst},
    cancel,
    model::{ForceModel, ModelError},
    muscle::Muscle,
};
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::Mutex;

/// Muscles whose burst pressure is kept.
const KEPT: usize = 32;

/// Burst pressures that were solved for, the last one last. They follow from model and muscle
/// alone.
static KNOWN: Mutex<Vec<(Model, Muscle, Burst)>> = Mutex::new(vec![]);

/// The burst pressure of a muscle by the model that answers.
pub fn burst_of(choice: &Model, model: &dyn ForceModel) -> Result<Burst, Problem> {
    // Whoever panicked with the list left it whole.
    let list = || {
        KNOWN
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    };
    let of = |known: &&(Model, Muscle, Burst)| known.0 == *choice && known.1 == *model.muscle();
    if let Some(known) = list().iter().find(of) {
        return Ok(known.2);
    }
    let failures = match burst(model) {
        Ok(failures) => failures,
        Err(AnalysisError::Model(ModelError::Cancelled(cancelled))) => return Err(cancelled.into()),
        Err(_) => Burst::unknown(NoBurst::NO_ANSWER),
    };
    cancel::check()?;
    let mut list = list();
    if list.len() >= KEPT {
        drop(list.remove(0));
    }
    list.push((choice.clone(), model.muscle().clone(), failures));
    Ok(failures)
}

/// Working pressure in MPa where none is given, and nothing forbids it: that of the paper.
const USUAL_MPA: f64 = 0.25;

/// The working pressure in MPa where none is given: that for which the muscle was designed, else
/// that of the paper, or the allowed one where that is lower.
pub fn usual_mpa(found: &Burst, muscle: &Muscle) -> f64 {
    // Down to a hundredth, which a regulator shows.
    let lower = |p: f64| {
        if p >= 0.01 {
            (100.0 * p).floor() / 100.0
        } else {
            p
        }
    };
    muscle.pressure_to_set_mpa().unwrap_or_else(|| {
        let allowed = found.allowed();
        allowed.map_or(USUAL_MPA, |allowed| lower(allowed.mpa).min(USUAL_MPA))
    })
}

/// What is handed out for a pressure that the muscle does not bear is refused: up to the allowed
/// one, with `overpressure` up to that of a proof test.
pub fn borne(found: &Burst, pressure_mpa: f64, overpressure: bool) -> Result<(), Problem> {
    let most_mpa = match (overpressure, found.least(), found.allowed()) {
        (true, Some((_, burst_mpa)), _) => highest_mpa(burst_mpa),
        (false, _, Some(allowed)) => allowed.mpa,
        _ => f64::INFINITY,
    };
    if pressure_mpa <= most_mpa {
        return Ok(());
    }
    let said = found
        .warnings(pressure_mpa, f64::INFINITY)
        .first()
        .map_or_else(String::new, ToString::to_string);
    let hint = "give a lower `pressure_mpa`; `overpressure` allows up to three quarters of the \
        burst pressure";
    Err(Problem::new(ProblemKind::OutOfRange, said, hint).in_field("pressure_mpa"))
}

/// The pressures that a muscle bears.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct PressureLimits {
    /// Burst pressure, MPa: the least at which a part of the muscle fails, of several muscles that
    /// of the weakest; none where no number for it is stated.
    #[serialize_always]
    pub burst_pressure_mpa: Option<f64>,
    /// How it fails there.
    pub burst_by: Option<FailureMode>,
    /// The least that the burst pressure may be, MPa, where number or strength of the strands are
    /// estimates; the allowed pressure follows from it.
    pub least_burst_pressure_mpa: Option<f64>,
    /// Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at
    /// which the tube does, two thirds of the least that each may be by estimates of the strands,
    /// and at most that for which the fittings are rated.
    pub allowed_pressure_mpa: Option<f64>,
    /// The failure that it keeps its distance from; none where the fittings are rated for it.
    pub allowed_by: Option<FailureMode>,
    /// The pressure of that failure over the allowed one.
    pub allowed_factor: Option<f64>,
    /// Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    pub ends_included: bool,
}

impl From<&Burst> for PressureLimits {
    fn from(found: &Burst) -> Self {
        let first = found.first();
        let allowed = found.allowed();
        let least_mpa = found.least().map(|f| f.1);
        Self {
            burst_pressure_mpa: first.map(|f| f.1),
            burst_by: first.map(|f| f.0),
            least_burst_pressure_mpa: least_mpa.filter(|p| first.is_some_and(|f| *p < f.1)),
            allowed_pressure_mpa: allowed.map(|a| a.mpa),
            allowed_by: allowed.and_then(|a| a.by),
            allowed_factor: allowed.map(|a| a.factor),
            ends_included: !matches!(found.ends, FailurePressure::Unknown(_)),
        }
    }
}

impl PressureLimits {
    /// What the muscle bears.
    pub fn rows(&self, u: &Units) -> Rows {
        self.rows_with("", u)
    }

    /// The same as lines.
    pub(crate) fn lines(&self, u: &Units) -> impl Iterator<Item = String> {
        self.rows(u)
            .into_iter()
            .map(|(name, value)| format!("{name} {value}"))
    }

    /// The rows with a note behind the burst pressure.
    pub(crate) fn rows_with(&self, note: &str, u: &Units) -> Rows {
        let burst = self.burst_pressure_mpa.map(|p| {
            let by = self.burst_by.map(|by| format!("; there {by}"));
            let least = self.least_burst_pressure_mpa.map(|least| {
                format!(
                    "; {} at least, by what is known of its strands",
                    u.pressure.show(least)
                )
            });
            u.pressure.show(p) + &by.unwrap_or_default() + &least.unwrap_or_default() + note
        });
        let allowed = self.allowed_pressure_mpa.map(|p| {
            let why = match self.allowed_by {
                Some(by) => format!(
                    "safety factor {} where {by}",
                    number(self.allowed_factor.unwrap_or(1.0), 3)
                ),
                None => "the fittings are rated for it".into(),
            };
            let ends = if self.ends_included {
                ""
            } else {
                "; its ends are NOT INCLUDED"
            };
            format!("{}; {why}{ends}", u.pressure.show(p))
        });
        Rows::default()
            .text("burst pressure", burst)
            .text("allowed pressure", allowed)
    }

    /// Those of the weakest of several muscles; none where that of one of them is not known.
    pub(crate) fn of_all(all: &[Burst]) -> Self {
        let known: Option<Vec<&Burst>> = all.iter().map(|b| b.pressure_mpa().map(|_| b)).collect();
        known
            .into_iter()
            .flatten()
            .reduce(|a, b| {
                if b.pressure_mpa() < a.pressure_mpa() {
                    b
                } else {
                    a
                }
            })
            .map_or_else(Self::default, Self::from)
    }
}
