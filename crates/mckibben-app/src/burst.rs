//! The burst pressure in answers: one value for each muscle and model, and the sentence that comes
//! before all others.

use crate::{Model, Problem, ProblemKind, Result, Units, number, print::Rows};
pub use mckibben_core::analysis::PressureLimits;
use mckibben_core::{
    analysis::{AnalysisError, Burst, Evaluation, NoBurst, RELIEF, burst},
    cancel,
    model::{ForceModel, ModelError},
    muscle::Muscle,
    units::rounded,
};
use std::sync::Mutex;

/// Muscles whose burst pressure is kept.
const KEPT: usize = 32;

/// Burst pressures that were solved for, the last one last. They follow from model and muscle
/// alone.
static KNOWN: Mutex<Vec<(Model, Muscle, Burst)>> = Mutex::new(vec![]);

/// The burst pressure of a muscle by the model that answers.
pub fn burst_of(choice: &Model, model: &dyn ForceModel) -> Result<Burst> {
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

/// The same, whose allowed pressure is raised where that is asked.
pub fn burst_with(overpressure: bool, choice: &Model, model: &dyn ForceModel) -> Result<Burst> {
    Ok(Burst {
        overpressure,
        ..burst_of(choice, model)?
    })
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

/// The pressure in MPa up to which a muscle is used where none is given: that of the supply of its
/// job, else that of the paper; the allowed one where that is lower.
pub fn supply_mpa(found: &Burst, muscle: &Muscle) -> f64 {
    let allowed_mpa = found.allowed().map(|allowed| allowed.mpa);
    let Some(job) = muscle.job() else {
        return usual_mpa(found, muscle);
    };
    let supply_mpa = job
        .supply
        .map(f64::from)
        .or(allowed_mpa)
        .unwrap_or_else(|| job.pressure.into());
    allowed_mpa.map_or(supply_mpa, |allowed_mpa| supply_mpa.min(allowed_mpa))
}

/// What is handed out for a pressure that is not allowed is refused.
pub fn borne(found: &Burst, pressure_mpa: f64) -> Result<()> {
    let allowed = found.allowed().map(|allowed| allowed.mpa);
    if allowed.is_none_or(|allowed_mpa| pressure_mpa <= allowed_mpa) {
        return Ok(());
    }
    let said = found
        .warnings(pressure_mpa)
        .first()
        .map_or_else(String::new, ToString::to_string);
    let raised = Burst {
        overpressure: true,
        ..*found
    };
    let higher = raised
        .allowed()
        .filter(|raised| allowed.is_some_and(|mpa| raised.mpa > mpa));
    let hint = match higher {
        Some(_) => {
            "give a lower `pressure_mpa`; `overpressure` allows more, up to a proof test at three \
             quarters of the burst pressure"
        }
        None => "give a lower `pressure_mpa`",
    };
    Err(Problem::new(ProblemKind::OutOfRange, said, hint).in_field("pressure_mpa"))
}

/// The pressure in MPa of the proof test of a muscle that works at one in MPa.
pub fn proof_mpa(found: &Burst, evaluation: &mut Evaluation<'_>, pressure_mpa: f64) -> Result<f64> {
    let proof_mpa = found.stretched_proof_mpa(evaluation, pressure_mpa)?;
    if Burst::is_proof(proof_mpa, pressure_mpa) {
        return Ok(proof_mpa);
    }
    let message = format!(
        "no proof test fits above {pressure_mpa}\u{a0}MPa: a tenth more loads strands or ends beyond \
         their limit"
    );
    let most = rounded(proof_mpa / RELIEF, 3, f64::floor);
    let hint = format!("give a `pressure_mpa` of at most {most}\u{a0}MPa, or stronger strands");
    Err(ProblemKind::OutOfRange
        .problem(message)
        .in_field("pressure_mpa")
        .with_hint(hint))
}

/// What a muscle bears, in rows.
pub trait LimitRows {
    /// The rows with a note behind the burst pressure.
    fn rows_with(&self, note: &str, u: &Units) -> Rows;

    /// The rows.
    fn rows(&self, u: &Units) -> Rows {
        self.rows_with("", u)
    }

    /// The same as lines.
    fn lines(&self, u: &Units) -> impl Iterator<Item = String> {
        self.rows(u)
            .into_iter()
            .map(|(name, value)| format!("{name} {value}"))
    }
}

impl LimitRows for PressureLimits {
    fn rows_with(&self, note: &str, u: &Units) -> Rows {
        let pressure = |p: f64| u.pressure.show(p);
        let burst = self.burst_pressure_mpa.map(|least| {
            let by = self
                .burst_by
                .map(|by| format!("; there {by}"))
                .unwrap_or_default();
            match self.nominal_burst_pressure_mpa {
                Some(nominal) => format!(
                    "{} at least, {} by nominal numbers of its strands{by}{note}",
                    pressure(least),
                    pressure(nominal)
                ),
                None => pressure(least) + &by + note,
            }
        });
        let allowed = self
            .allowed_pressure_mpa
            .zip(self.allowed_by)
            .map(|(p, by)| {
                let factor = self.allowed_factor.filter(|factor| *factor > 1.0);
                let factor =
                    factor.map(|factor| format!("safety factor {} where ", number(factor, 3)));
                let raised = if self.overpressure {
                    " (overpressure)"
                } else {
                    ""
                };
                let ends = if self.ends_included {
                    ""
                } else {
                    "; its ends are NOT INCLUDED"
                };
                format!(
                    "{}{raised}; {}{by}{ends}",
                    pressure(p),
                    factor.unwrap_or_default()
                )
            });
        Rows::default()
            .text("burst pressure", burst)
            .text("allowed pressure", allowed)
    }
}
