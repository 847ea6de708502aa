//! How the pull answers to the muscle's constants and measures, at fixed pressure and contraction.
//!
//! With x the unknowns and R(x, θ) = ∂Π/∂x, equilibrium gives dx/dθ = −K⁻¹ ∂R/∂θ, and dF/dθ = ∂F/∂θ + ∂F/∂x dx/dθ is
//! what arrives at the terminal when ∂R/∂θ is forward-substituted with the factorised tangent: one substitution each.
//! ∂R/∂θ itself comes from fourth-order central differences of the residual at the fixed state; it is exact but for
//! rounding in constants that enter linearly.

use super::assembly::{Assembled, assemble};
use super::body::Body;
use super::discretisation::{BraidSpec, Discretisation, Problem};
use super::mesh::Mesh;
use crate::FemError;
use crate::results::Sensitivity;
use crate::solver::body::State;
use mckibben::muscle::{Crimp, Muscle, StrandLay};
use mckibben::rubber::Law;

/// A law with `change` added to its constant number `index`.
fn changed(law: &Law, index: usize, change: f64) -> Law {
    law.with_constants(|i, value| if i == index { value + change } else { value })
}

/// The measures of a muscle that are varied.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Measures {
    outer_diameter: f64,
    wall: f64,
    length: f64,
    angle_deg: f64,
    thickness: f64,
    diameter: Option<f64>,
    crimp: Option<Crimp>,
    stiffness: Option<f64>,
}

impl Measures {
    fn lay(&self) -> StrandLay {
        let diameter = self.diameter.unwrap_or(self.outer_diameter);
        StrandLay::new(self.angle_deg.to_radians(), diameter, self.thickness)
    }
}

/// The body with other measures; the mesh keeps its proportions.
fn rebuilt(d: &Discretisation, law: Law, from: &Measures, to: &Measures) -> Result<Discretisation, FemError> {
    let mut mesh: Mesh = d.mesh.clone();
    let (outer, stretch) = (0.5 * to.outer_diameter, to.length / from.length);
    let inner = outer - to.wall;
    for node in &mut mesh.nodes {
        let share = (node[0] - (0.5 * from.outer_diameter - from.wall)) / from.wall;
        *node = [inner + share * (outer - inner), node[1] * stretch];
    }
    let braid =
        d.problem.braid.map(|b| BraidSpec { lay: to.lay(), crimp: to.crimp, stiffness: to.stiffness, ..b });
    let mut out = Discretisation::new(mesh, Problem { law, braid, ..d.problem.clone() })?;
    // The scale of the multipliers' equations must not change with the law.
    (out.augment, out.augment_strand) = (d.augment, d.augment_strand);
    Ok(out)
}

/// Steps of the fourth-order difference: (step, weight).
const STENCIL: [(f64, f64); 4] =
    [(-2.0, 1.0 / 12.0), (-1.0, -8.0 / 12.0), (1.0, 8.0 / 12.0), (2.0, -1.0 / 12.0)];
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
    let law = d.problem.law.clone();
    let here = Measures {
        outer_diameter: muscle.outer_diameter_mm(),
        wall: muscle.wall_mm(),
        length: muscle.length_mm(),
        angle_deg: muscle.braid().angle_deg,
        thickness: muscle.braid().thickness_mm,
        diameter: muscle.braid().diameter_mm,
        crimp: muscle.braid().crimp,
        stiffness: muscle.family_stiffness_n_per_mm(),
    };
    let mut out = Vec::new();
    let mut add = |name: String, value: f64, unit: &'static str, make: &dyn Fn(f64) -> (Law, Measures)| {
        if !wanted(&name) {
            return Ok(());
        }
        let step = STEP * if value == 0.0 { d.shear } else { value.abs() };
        let mut change = vec![0.0; state.u.len()];
        for (k, weight) in STENCIL {
            let (law, to) = make(k * step);
            let residual = residual(&d, &state, law, &here, &to)?;
            for (c, r) in change.iter_mut().zip(&residual) {
                *c += weight * r / step;
            }
        }
        out.push(Sensitivity { name, value, unit, force_n_per_unit: body.force_change(&mut change) });
        Ok::<(), FemError>(())
    };
    for (index, c) in law.constants().into_iter().enumerate() {
        let name = format!("tube.material.{}", c.name);
        add(name, c.value, c.constant.unit(), &|h| (changed(&law, index, h), here))?;
    }
    let same = |to: Measures| (law.clone(), to);
    if let Some(k) = here.stiffness {
        let make = |h: f64| same(Measures { stiffness: Some(k + h), ..here });
        add("braid.stiffness".into(), k, "N/mm", &make)?;
    }
    let make = |h: f64| same(Measures { outer_diameter: here.outer_diameter + h, ..here });
    add("tube.outer_diameter".into(), here.outer_diameter, "mm", &make)?;
    let make = |h: f64| same(Measures { wall: here.wall + h, ..here });
    add("tube.wall_thickness".into(), here.wall, "mm", &make)?;
    let make = |h: f64| same(Measures { length: here.length + h, ..here });
    add("tube.length".into(), here.length, "mm", &make)?;
    let make = |h: f64| same(Measures { angle_deg: here.angle_deg + h, ..here });
    add("braid.angle".into(), here.angle_deg, "deg", &make)?;
    if here.thickness > 0.0 {
        let make = |h: f64| same(Measures { thickness: here.thickness + h, ..here });
        add("braid.thickness".into(), here.thickness, "mm", &make)?;
    }
    if let Some(crimp) = here.crimp {
        let strained = |h: f64| Crimp { strain: crimp.strain + h, ..crimp };
        let make = |h: f64| same(Measures { crimp: Some(strained(h)), ..here });
        add("braid.crimp".into(), crimp.strain, "", &make)?;
    }
    if let Some(diameter) = here.diameter {
        let make = |h: f64| same(Measures { diameter: Some(diameter + h), ..here });
        add("braid.diameter".into(), diameter, "mm", &make)?;
    }
    Ok(out)
}

/// The residual of a neighbouring muscle at the same unknowns and the same contraction.
fn residual(
    d: &Discretisation,
    state: &State,
    law: Law,
    from: &Measures,
    to: &Measures,
) -> Result<Vec<f64>, FemError> {
    let other = rebuilt(d, law, from, to)?;
    let mut state = state.clone();
    // At fixed ε the terminal moves with L0. All axial displacements go with it: what is added to free unknowns does
    // not change what arrives at the terminal, and the terminal's move alone would be too rough for differences.
    let ratio = to.length / from.length;
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
