//! The rubber law that the points prefer.
//!
//! Each law is identified in turn with all of its constants free, and with whatever else is free;
//! they are compared by [`aicc`], which takes the errors of the points as independent. Where a
//! model does not follow the data, neighbours on one curve err together: their correlation says how
//! far the differences can be trusted. A muscle is a poor test of rubber: strands that lock and
//! compliant ends change the pull as a rubber that stiffens does, and the constants that follow can
//! be ones that no rubber has.

use super::{
    Identification, IdentificationRequest, IdentifyError, Parameter, Result, Target,
    advice::neighbours, identify,
};
use crate::least_squares::aicc;
use mckibben_core::{
    analysis::find_root,
    by_number::SortByNumber,
    cancel::Cancelled,
    muscle::{Rubber, Tube},
    rubber::{Law, LawKind, RubberLaw},
};

/// A rubber whose chains lock in tension below this stretch is not among the measured ones that
/// ship: they stretch to 3 and more.
const EARLY_LOCK: f64 = 3.0;

/// The identification with one law.
#[derive(Debug)]
pub struct LawTrial {
    pub law: &'static str,
    pub result: Result<Identification>,
    /// AICc; infinite without a result.
    pub aicc: f64,
    /// Correlation of neighbouring residuals, −1 to 1; 0 for errors that are independent.
    pub neighbours: f64,
    /// Why its constants are implausible.
    pub doubt: Option<String>,
}

/// Every law with a fixed number of constants, lowest AICc first.
pub fn try_laws(request: &IdentificationRequest<'_>) -> Result<Vec<LawTrial>> {
    let mut trials = vec![];
    for kind in Law::KINDS.iter().filter(|kind| !kind.is_sum) {
        if let Some(trial) = trial(request, kind) {
            if matches!(trial.result, Err(IdentifyError::Cancelled(_))) {
                return Err(Cancelled.into());
            }
            trials.push(trial);
        }
    }
    trials.sort_by_number(|a| a.aicc);
    Ok(trials)
}

/// One law from its example, scaled to the muscle's modulus at rest.
fn trial(request: &IdentificationRequest<'_>, kind: &'static LawKind) -> Option<LawTrial> {
    let tube = request.muscle.tube();
    let known = &tube.rubber.law;
    let law = if known.kind().name == kind.name {
        known.clone()
    } else {
        let example = Law::examples()
            .into_iter()
            .find(|law| law.name() == kind.name)?;
        example.scaled(known.shear_modulus_mpa() / example.shear_modulus_mpa())
    };
    let constants = law.values().len();
    let rubber = Rubber {
        bulk: tube.rubber.bulk,
        ..Rubber::new(law)
    };
    let muscle = request
        .muscle
        .with_tube(Tube {
            rubber,
            ..tube.clone()
        })
        .ok()?;
    let rest = request
        .free
        .iter()
        .filter(|p| !p.target.is_of_law())
        .copied();
    let free: Vec<Parameter> = (0..constants)
        .map(|i| Parameter::free(Target::Law(i)))
        .chain(rest)
        .collect();
    let fixed: Vec<(Target, f64)> = request
        .fixed
        .iter()
        .filter(|f| !f.0.is_of_law())
        .copied()
        .collect();
    let result = identify(&IdentificationRequest {
        muscle: &muscle,
        free: &free,
        fixed: &fixed,
        ..*request
    });
    let identified = result.as_ref().ok();
    Some(LawTrial {
        law: kind.name,
        aicc: identified.map_or(f64::INFINITY, |i| {
            let n = i.points.len();
            aicc(
                n,
                free.len(),
                i.deviation * i.deviation * i.freedom as f64 / n as f64,
            )
        }),
        neighbours: identified.map_or(0.0, |i| neighbours(&i.points).1),
        doubt: identified.and_then(|i| doubt(&i.muscle.tube().rubber.law)),
        result,
    })
}

/// Constants that no rubber has.
fn doubt(law: &Law) -> Option<String> {
    // In tension I1 − 3 = λ² + 2/λ − 3.
    let stretch = law.locks_at().and_then(|j| {
        let beyond = |l: f64| Ok::<f64, Cancelled>(l * l + 2.0 / l - 3.0 - j);
        find_root(beyond, 1.0, (j + 3.0).sqrt(), 1e-9)
            .ok()
            .flatten()
    });
    if let Some(stretch) = stretch.filter(|s| *s < EARLY_LOCK) {
        return Some(format!(
            "no rubber of the library locks at a stretch of {stretch:.1} in tension; a jammed \
             braid, strands that lift off the tube or compliant ends have the same effect"
        ));
    }
    let values = law.constants();
    let negative = values
        .iter()
        .find(|c| c.constant.is_modulus() && c.value < 0.0)?;
    let name = &negative.name;
    let value = negative.value;
    Some(format!(
        "{name} is {value:.3} MPa, below zero: the law may lose its stability"
    ))
}
