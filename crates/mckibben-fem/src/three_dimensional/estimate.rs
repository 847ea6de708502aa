//! What a mesh of bricks will need, before it is made.

use super::mesh::{BrickMesh, BrickSpec};
use crate::FemError;
use mckibben::budget::{Budget, Resource};
use mckibben::muscle::Muscle;

/// Nodes through the wall, around and along, bytes, and seconds of a factorisation, of one mesh of bricks that was measured
/// (`docs/finite-elements-3d.md`).
const MEASURED: ([f64; 3], f64, f64) = ([5.0, 81.0, 258.0], 1.6e9, 1.9);
/// Bytes of an unknown beside the factor: elements, maps and state.
const BYTES_BESIDE: f64 = 1500.0;

/// What the factor's entries and the operations of a factorisation grow with: nested dissection of a sheet of n points with w unknowns each
/// has w² n log n entries and w³ n^1.5 operations (George 1973 \[george1973\]).
fn dissected([through, around, along]: [f64; 3]) -> (f64, f64) {
    let sheet = around * along;
    (through.powi(2) * sheet * sheet.ln(), through.powi(3) * sheet.powf(1.5))
}

/// Factorisations of a point.
const POINT: f64 = 10.0;

/// Refuses a mesh of a muscle that does not fit into a budget, before anything is allocated.
///
/// # Errors
/// [`FemError`]: the budget's, or where the numbers give no valid mesh.
pub(crate) fn admit(spec: &BrickSpec, muscle: &Muscle, budget: &Budget) -> Result<(), FemError> {
    let (tube, angle) = (muscle.tube(), muscle.braid().angle_rad());
    let (inner, outer) = (tube.inner_radius_mm(), tube.outer_radius_mm());
    let [through, around, along, bonded] = BrickMesh::count(inner, outer, 0.5 * tube.length_mm, angle, spec)?;
    let bricks = [through, around, along + bonded].map(|n| n as f64);
    budget.admit(Resource::Elements, bricks.iter().product())?;
    let nodes = bricks.map(|n| n * spec.brick.order() as f64 + 1.0);
    let (mesh, bytes, seconds) = MEASURED;
    let ((entries, operations), measured) = (dissected(nodes), dissected(mesh));
    let beside = BYTES_BESIDE * 3.0 * nodes.iter().product::<f64>();
    budget.admit(Resource::Bytes, beside + bytes * entries / measured.0)?;
    Ok(budget.admit(Resource::Seconds, POINT * seconds * operations / measured.1)?)
}
