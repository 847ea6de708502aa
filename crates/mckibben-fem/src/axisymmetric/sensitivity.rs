//! How the pull answers to the muscle's constants and measures, at fixed pressure and contraction.
//!
//! With x the unknowns and R(x, θ) = ∂Π/∂x, equilibrium gives dx/dθ = −K⁻¹ ∂R/∂θ, and dF/dθ = ∂F/∂θ + ∂F/∂x dx/dθ is
//! what arrives at the terminal when ∂R/∂θ is forward-substituted with the factorised tangent: one substitution each.
//! ∂R/∂θ itself comes from fourth-order central differences of the residual at the fixed state; it is exact but for
//! rounding in constants that enter linearly.

use super::assembly::{Assembled, assemble};
use super::body::Body;
use super::discretisation::{Discretisation, Problem};
use super::mesh::Mesh;
use crate::FemError;
use crate::results::Sensitivity;
use crate::solver::body::State;
use mckibben::differences::STENCIL;
use mckibben::muscle::measures::{STIFFNESS, of_section};
use mckibben::muscle::{Muscle, Parts};
use mckibben::rubber::Law;

/// A law with `change` added to its constant number `index`.
fn changed(law: &Law, index: usize, change: f64) -> Law {
    law.with_constants(|i, value| if i == index { value + change } else { value })
}

/// The body with other measures; the mesh keeps its proportions.
fn rebuilt(d: &Discretisation, from: &Parts, to: &Parts) -> Result<Discretisation, FemError> {
    let mut mesh: Mesh = d.mesh.clone();
    let (outer, stretch) = (to.tube.outer_radius_mm(), to.tube.length_mm / from.tube.length_mm);
    let inner = outer - to.tube.wall_mm;
    for node in &mut mesh.nodes {
        let share = (node[0] - from.tube.inner_radius_mm()) / from.tube.wall_mm;
        *node = [inner + share * (outer - inner), node[1] * stretch];
    }
    let problem = Problem { ends: d.problem.ends, ..Problem::of_parts(to) };
    let mut out = Discretisation::new(mesh, problem)?;
    // The scale of the multipliers' equations must not change with the law.
    (out.augment, out.augment_strand) = (d.augment, d.augment_strand);
    Ok(out)
}

/// Step of the differences, over the value.
const STEP: f64 = 1e-3;

/// All sensitivities at the body's equilibrium, whose tangent must stand factorised.
///
/// # Errors
/// [`FemError`] where a neighbouring muscle cannot be assembled.
pub fn all(body: &mut Body, muscle: &Muscle) -> Result<Vec<Sensitivity>, FemError> {
    of(body, muscle, |_| true)
}

/// Those whose name is wanted.
///
/// # Errors
/// As [`all`].
pub fn of(
    body: &mut Body,
    muscle: &Muscle,
    wanted: impl Fn(&str) -> bool,
) -> Result<Vec<Sensitivity>, FemError> {
    let d = std::sync::Arc::clone(&body.discretisation);
    let state = body.state.clone();
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
        let mut change = vec![0.0; state.u.len()];
        for (k, weight) in STENCIL {
            let residual = residual(&d, &state, &here, &make(k * step))?;
            for (c, r) in change.iter_mut().zip(&residual) {
                *c += weight * r / step;
            }
        }
        out.push(Sensitivity { name, value, unit, force_n_per_unit: body.force_change(&mut change) });
        Ok::<(), FemError>(())
    };
    for (index, c) in law.constants().into_iter().enumerate() {
        let name = format!("tube.material.{}", c.name);
        let make = |h: f64| {
            let mut to = here.clone();
            to.tube.rubber.law = changed(&law, index, h);
            to
        };
        add(name, c.value, c.constant.unit(), &make)?;
    }
    // Ends that give way are around this body, friction is added to its pull.
    let measures = ["tube", "braid"].into_iter().flat_map(of_section).filter(|m| m.identify.is_some());
    for measure in [&STIFFNESS].into_iter().chain(measures) {
        let Some(value) = (measure.get)(&here) else { continue };
        let make = |h: f64| {
            let mut to = here.clone();
            (measure.set)(&mut to, value + h);
            to
        };
        add(measure.key.into(), value, measure.unit(), &make)?;
    }
    Ok(out)
}

/// The residual of a neighbouring muscle at the same unknowns and the same contraction.
fn residual(d: &Discretisation, state: &State, from: &Parts, to: &Parts) -> Result<Vec<f64>, FemError> {
    let other = rebuilt(d, from, to)?;
    let mut state = state.clone();
    // At fixed ε the terminal moves with L0. All axial displacements go with it: what is added to free unknowns does
    // not change what arrives at the terminal, and the terminal's move alone would be too rough for differences.
    let ratio = to.tube.length_mm / from.tube.length_mm;
    for j in 0..=2 * d.layout.along {
        let at = d.layout.at(j);
        for i in 0..d.layout.nodes() {
            state.u[at + 2 * i + 1] *= ratio;
        }
    }
    let mut work = Assembled::new(&other);
    assemble::<false>(&other, &state, &mut work)
        .map_err(|reason| FemError::Force { force_n: f64::NAN, reason })?;
    Ok(work.residual)
}
