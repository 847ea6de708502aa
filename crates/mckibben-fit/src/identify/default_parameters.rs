//! The default of the free parameters.

use super::{
    Identification, IdentificationRequest, IdentifyError, Parameter, Result, Target,
    identify, learn,
};
use crate::{
    least_squares::Loss,
    measured::{DataPoint, Quantity, distinct},
};
use mckibben_core::{
    muscle::{
        Direction, Muscle,
        measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT, FRICTION_LEVER, FRICTION_PRESLIDING},
    },
};

/// The law's modulus (its one constant, or a factor on all of them), the stiffness of strands that
/// stretch, and the friction where both branches were measured; of rows in time order the friction
/// with its presliding length.
pub fn default_targets(muscle: &Muscle, points: &[DataPoint], history: bool) -> Vec<Target> {
    let constants = muscle.tube().rubber.law.constants();
    let moduli: Vec<usize> = (0..constants.len())
        .filter(|&i| constants[i].constant.is_modulus() && constants[i].value != 0.0)
        .collect();
    let mut out = vec![match moduli.as_slice() {
        [one] => Target::Law(*one),
        _ => Target::Modulus,
    }];
    if muscle.family_stiffness_n_per_mm().is_some() {
        out.push(Target::Stiffness);
    }
    if history {
        let law = muscle.friction().is_some_and(|f| f.coefficient > 0.0);
        let level = if law {
            &FRICTION_COEFFICIENT
        } else {
            &FRICTION_LEVER
        };
        out.extend([
            Target::Measure(level),
            Target::Measure(&FRICTION_PRESLIDING),
        ]);
        return out;
    }
    let has = |branch| points.iter().any(|p| p.at.branch == Some(branch));
    if has(Direction::Contraction) && has(Direction::Elongation) {
        out.push(Target::Measure(&FRICTION_COEFFICIENT));
        if distinct(points.iter().map(|p| p.at.pressure_mpa)).len() > 2 {
            out.push(Target::Measure(&FRICTION_EXPONENT));
        }
    }
    out
}

/// The `default_targets` that are not fixed, with their bounds.
pub fn default_parameters(request: &IdentificationRequest<'_>) -> Result<Vec<Parameter>> {
    let mut targets = default_targets(request.muscle, request.points, request.history);
    targets.retain(|t| request.fixed.iter().all(|f| f.0 != *t));
    if let Some((target, _)) = request.bounds.iter().find(|b| !targets.contains(&b.0)) {
        return Err(not_free(*target, request.muscle));
    }
    let one = |target: Target| Parameter {
        bounds: request.bounds.iter().find(|b| b.0 == target).map(|b| b.1),
        ..Parameter::free(target)
    };
    Ok(targets.into_iter().map(one).collect())
}

/// Bounds of what stays as it is.
pub fn not_free(target: Target, muscle: &Muscle) -> IdentifyError {
    let name = target.name(muscle);
    IdentifyError::Refused(format!(
        "{name} has bounds and is not free: name it in `free` too"
    ))
}

/// All constants with what is known of them before ([`learn`]); of rows in time order, and of
/// volumes, [`identify`] with the `default_targets` that are not fixed: a stiffness that the data
/// do not determine keeps the value of the muscle.
pub fn identify_default(request: &IdentificationRequest<'_>) -> Result<Identification> {
    super::run::check(request.points)?;
    let has_volumes = request
        .points
        .iter()
        .any(|p| p.measured == Quantity::Volume);
    let least_squares = request.history || has_volumes || request.loss != Loss::Squares;
    if !least_squares && !request.muscle.is_extensile() {
        return learn(request);
    }
    let free = default_parameters(request)?;
    let run = |free: &[Parameter]| identify(&IdentificationRequest { free, ..*request });
    let without: Vec<Parameter> = free
        .iter()
        .copied()
        .filter(|p| p.target != Target::Stiffness)
        .collect();
    let all = run(&free);
    let identified = match &all {
        Ok(result) => result
            .parameter(Target::Stiffness)
            .is_none_or(|p| p.identifiable),
        Err(_) => without.len() == free.len(),
    };
    if identified || without.is_empty() {
        return all;
    }
    let mut result = run(&without)?;
    let note = "braid.stiffness is not identifiable from these data and was not changed; free it \
        by name to see its value";
    result.notes.push(note.into());
    Ok(result)
}
