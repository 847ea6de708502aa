//! Exports.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::too_many_lines
)]

mod files;
mod form;
mod joint;
mod memory;
mod refused;
mod rust;

use mckibben_core::{model::ForceModel, muscle::Muscle};
use mckibben_export::{BoxRequest, ExportError, ExportedMuscle};
use mckibben_fem::{axisymmetric::MeshSpec, elements::section};

/// A muscle by finite elements.
pub fn fe(muscle: &Muscle) -> Box<dyn ForceModel> {
    section(
        muscle,
        &MeshSpec {
            through: None,
            along: None,
            grading: None,
        },
    )
    .unwrap()
}

/// A muscle by finite elements, exported over the box that is usual.
pub fn exported(muscle: &Muscle, supply_mpa: f64) -> Result<ExportedMuscle, ExportError> {
    let model = fe(muscle);
    let wanted = BoxRequest {
        supply_mpa,
        contraction_low: 0.0,
        contraction_high: None,
    };
    ExportedMuscle::fit(&*model, "prototype", wanted)
}

/// Half of the hysteresis of a form at a pressure in Pa and a contraction of the box, N: by the rule of its header.
pub fn half_n(form: &mckibben_export::Form, pressure_pa: f64, e: f64) -> f64 {
    let q = pressure_pa / form.supply_pa;
    let [r0, r1, r2, q0, q1, q2] = form.friction_n;
    ((r0 + e * (r1 + e * r2)) * q.sqrt() + (q0 + e * (q1 + e * q2)) * q).max(0.0)
}
