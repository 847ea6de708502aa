//! What is free where nothing is said.

use super::data::DataPoint;
use super::error::IdentifyError;
use super::parameter::{Parameter, Target};
use super::problem::Build;
use super::result::Identification;
use super::run::{Request, distinct, identify};
use crate::compare::Branch;
use crate::muscle::Muscle;
use crate::rubber::RubberLaw;

/// The law's modulus (its one constant, or a factor on all of them), the stiffness of strands that stretch, and the friction
/// where both branches were measured.
pub fn default_targets(muscle: &Muscle, points: &[DataPoint]) -> Vec<Target> {
    let constants = muscle.tube().rubber.law.constants();
    let moduli: Vec<usize> =
        (0..constants.len()).filter(|&i| constants[i].2 == "MPa" && constants[i].1 != 0.0).collect();
    let mut out = vec![match moduli.as_slice() {
        [one] => Target::Law(*one),
        _ => Target::Modulus,
    }];
    if muscle.family_stiffness_n_per_mm().is_some() {
        out.push(Target::Stiffness);
    }
    let has = |branch| points.iter().any(|p| p.at.branch == Some(branch));
    if has(Branch::Contraction) && has(Branch::Elongation) {
        out.push(Target::FrictionCoefficient);
        if distinct(points.iter().map(|p| p.at.pressure_mpa)) > 2 {
            out.push(Target::FrictionExponent);
        }
    }
    out
}

/// [`identify`] with the [`default_targets`] that are not fixed; a stiffness that the data do not determine is left at the
/// muscle's own.
///
/// # Errors
/// [`IdentifyError`].
pub fn identify_default<B: Build>(request: &Request<'_>, build: B) -> Result<Identification, IdentifyError> {
    let fixed = |t: &Target| request.fixed.iter().any(|f| f.0 == *t);
    let targets: Vec<Target> =
        default_targets(request.muscle, request.points).into_iter().filter(|t| !fixed(t)).collect();
    let run = |targets: &[Target]| {
        let free: Vec<Parameter> = targets.iter().map(|t| Parameter::free(*t)).collect();
        identify(&Request { free: &free, ..*request }, &build)
    };
    let without: Vec<Target> = targets.iter().copied().filter(|t| *t != Target::Stiffness).collect();
    let all = run(&targets);
    let identified = match &all {
        Ok(found) => found.parameter(Target::Stiffness).is_none_or(|p| p.identifiable),
        Err(_) => without.len() == targets.len(),
    };
    if identified || without.is_empty() {
        return all;
    }
    let mut found = run(&without)?;
    found.notes.push(
        "braid.stiffness is not identifiable from these data and was left as it is; free it by name to see"
            .into(),
    );
    Ok(found)
}
