//! The burst pressure in answers: one value for each muscle and model, and the sentence that comes before all others.

use crate::model::Model;
use crate::problem::Problem;
use mckibben::analysis::{AnalysisError, Burst, NoBurst, burst};
use mckibben::budget::Budget;
use mckibben::model::{ForceModel, ModelError, Workspace};
use mckibben::muscle::Muscle;
use mckibben::warning::Warning;
use std::sync::Mutex;

/// Pressure in MPa up to which a single point or a curve says nothing of a burst pressure that is not known: that of a usual supply. Whoever
/// builds (`design`, `muscle show`, `joint`, `motion`, `report`) reads of it at any pressure.
pub(crate) const QUIET_MPA: f64 = 0.6;
/// Muscles whose burst pressure is kept.
const KEPT: usize = 32;

/// Burst pressures that were solved for, the last one last. They follow from model and muscle alone.
static KNOWN: Mutex<Vec<(Model, Muscle, Burst)>> = Mutex::new(vec![]);

/// The burst pressure of a muscle by the model that answers.
///
/// # Errors
/// [`Problem`] where the budget is spent.
pub(crate) fn burst_of(choice: &Model, model: &dyn ForceModel, budget: &Budget) -> Result<Burst, Problem> {
    if let Some(missing) = Burst::missing(model.muscle()) {
        return Ok(Burst::Unknown(missing));
    }
    // Whoever panicked with the list left it whole.
    let list = || KNOWN.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let of = |known: &&(Model, Muscle, Burst)| known.0 == *choice && known.1 == *model.muscle();
    if let Some(known) = list().iter().find(of) {
        return Ok(known.2);
    }
    let found = match burst(model, &Workspace::within(budget.clone())) {
        Ok(found) => found,
        Err(AnalysisError::Model(ModelError::Exceeded(exceeded))) => return Err(exceeded.into()),
        Err(_) => Burst::Unknown(NoBurst::NoAnswer { up_to_mpa: 0.0 }),
    };
    budget.ended()?;
    let mut list = list();
    if list.len() >= KEPT {
        list.remove(0);
    }
    list.push((choice.clone(), model.muscle().clone(), found));
    Ok(found)
}

/// What is said of a burst pressure where the largest pressure is `highest_mpa`; of one that is not known only above `quiet_mpa`.
pub(crate) fn said_of(found: &Burst, highest_mpa: f64, quiet_mpa: f64) -> Option<Warning> {
    match *found {
        Burst::At { pressure_mpa: burst_mpa, .. } => {
            (highest_mpa >= burst_mpa).then_some(Warning::Burst { pressure_mpa: highest_mpa, burst_mpa })
        }
        Burst::Unknown(why) => (highest_mpa > quiet_mpa).then_some(Warning::BurstNotChecked(why)),
    }
}

/// Puts what is said of a burst before all other warnings, and takes out what it includes.
pub(crate) fn put_first(warnings: &mut Vec<Warning>, said: impl IntoIterator<Item = Warning>) {
    let first = Warning::gravest(&said.into_iter().collect::<Vec<_>>());
    if first.iter().any(|w| matches!(w, Warning::Burst { .. })) {
        warnings.retain(|w| !matches!(w, Warning::StrandsBreak { .. }));
    }
    warnings.splice(..0, first);
}

/// The least burst pressure of several muscles in MPa; none where that of one of them is not known.
pub(crate) fn least(all: &[Burst]) -> Option<f64> {
    let known: Option<Vec<f64>> = all.iter().map(Burst::pressure_mpa).collect();
    known?.into_iter().reduce(f64::min)
}
