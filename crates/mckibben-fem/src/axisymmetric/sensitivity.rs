//! How the pull answers to the muscle's constants and measures, at fixed pressure and contraction.
//!
//! With x the unknowns and R(x, θ) = ∂Π/∂x, equilibrium gives dx/dθ = −K⁻¹ ∂R/∂θ, and dF/dθ =
//! ∂F/∂θ + ∂F/∂x dx/dθ is what arrives at the terminal when ∂R/∂θ is forward-substituted with the
//! factorised tangent: one substitution each. ∂R/∂θ itself comes from fourth-order central
//! differences of the residual at the fixed state; it is exact but for rounding in constants that
//! enter linearly. A body keeps the neighbouring muscles of these differences.

use super::{
    assembly::{Assembled, assemble},
    body::Body,
    neighbour::Neighbour,
};
use crate::{FemError, Result, results::Sensitivity, solver::body::State};
use mckibben_core::{
    differences::STENCIL,
    muscle::{
        Muscle, Parts,
        measures::{STIFFNESS, of_section},
    },
};
use std::sync::Arc;

/// Step of the differences, over the value.
const STEP: f64 = 1e-3;

/// Sensitivities at the body's equilibrium whose name is wanted; its tangent must be factorised.
///
/// # Errors
/// [`FemError`] where a neighbouring muscle cannot be assembled.
pub fn slopes(
    body: &mut Body,
    muscle: &Muscle,
    wanted: impl Fn(&str) -> bool,
) -> Result<Vec<Sensitivity>> {
    let d = Arc::clone(&body.discretisation);
    let mut room = (body.state.clone(), Assembled::new(&d));
    let mut here = muscle.parts().clone();
    let law = here.tube.rubber.law.clone();
    // k is held, also where it follows from other measures.
    if let Some(k) = muscle.family_stiffness_n_per_mm() {
        (STIFFNESS.set)(&mut here, k);
    }
    let mut out = Vec::new();
    let mut add = |name: String, value: f64, unit: &'static str, make: &dyn Fn(f64) -> Parts| {
        if !wanted(&name) {
            return Ok(());
        }
        let step = STEP * if value == 0.0 { d.shear } else { value.abs() };
        let neighbours = body
            .neighbours
            .differing_in(&name, (&d, &here), |k| make(k * step))?;
        let mut change = vec![0.0; body.state.u.len()];
        for (neighbour, (_, weight)) in neighbours.iter().zip(STENCIL) {
            let residual = residual(neighbour, &body.state, &mut room)?;
            for (c, r) in change.iter_mut().zip(residual) {
                *c += weight * r / step;
            }
        }
        out.push(Sensitivity {
            name,
            value,
            unit,
            force_n_per_unit: body.force_change(&mut change),
        });
        Ok::<(), FemError>(())
    };
    for (index, c) in law.constants().into_iter().enumerate() {
        let name = format!("tube.material.{}", c.name);
        let make = |h: f64| {
            let mut to = here.clone();
            to.tube.rubber.law = law.with_constants(|i, v| if i == index { v + h } else { v });
            to
        };
        add(name, c.value, c.constant.unit(), &make)?;
    }
    // Slipping ends are outside of this body, friction is added to its pull.
    let measures = ["tube", "braid"]
        .into_iter()
        .flat_map(of_section)
        .filter(|m| m.identify.is_some());
    for measure in [&STIFFNESS].into_iter().chain(measures) {
        let Some(value) = (measure.get)(&here) else {
            continue;
        };
        let make = |h: f64| {
            let mut to = here.clone();
            (measure.set)(&mut to, value + h);
            to
        };
        add(measure.key.into(), value, measure.unit(), &make)?;
    }
    Ok(out)
}

/// The residual of a neighbouring muscle at the same unknowns and the same contraction, in room for
/// both.
fn residual<'a>(
    Neighbour {
        discretisation: other,
        stretch,
    }: &Neighbour,
    at: &State,
    (state, work): &'a mut (State, Assembled),
) -> Result<&'a [f64]> {
    state.u.copy_from_slice(&at.u);
    // At fixed ε the terminal moves with L0. All axial displacements go with it: what is added to
    // free unknowns does not change what arrives at the terminal, and the terminal's move alone
    // would be too rough for differences.
    for j in 0..=2 * other.layout.along {
        let at = other.layout.station_offset(j);
        for i in 0..other.layout.nodes() {
            state.u[at + 2 * i + 1] *= stretch;
        }
    }
    assemble::<false>(other, state, work).map_err(|reason| FemError::Force {
        force_n: f64::NAN,
        reason,
    })?;
    Ok(&work.residual)
}
