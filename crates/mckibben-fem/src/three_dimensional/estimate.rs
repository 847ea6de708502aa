//! What a mesh of bricks will need, before it is made.

use super::mesh::{BrickMesh, BrickSpec, Quarter};
use crate::Result;
use mckibben_core::{muscle::Muscle, size};

/// Nodes through the wall, around and along, and bytes, of one mesh of bricks that was
/// measured.
const MEASURED: ([f64; 3], f64) = ([5.0, 81.0, 258.0], 1.6e9);
/// Bytes of an unknown beside the factor: elements, maps and state.
const BYTES_BESIDE: f64 = 1500.0;

/// What the factor's entries grow with: nested dissection of a sheet of n points with w unknowns
/// each has w² n log n entries (George 1973 \[george1973\]).
fn dissected([through, around, along]: [f64; 3]) -> f64 {
    let sheet = around * along;
    through.powi(2) * sheet * sheet.ln()
}

/// Refuses a mesh of a muscle that does not fit into memory, before anything is allocated.
///
/// # Errors
/// [`FemError::Large`], or where the numbers give no valid mesh.
pub fn admit(spec: &BrickSpec, muscle: &Muscle) -> Result<()> {
    let [through, around, along, bonded] = BrickMesh::count(&Quarter::from_muscle(muscle), spec)?;
    let bricks = [through, around, along + bonded].map(|n| n as f64);
    size::elements("mesh", bricks.iter().product())?;
    let nodes = bricks.map(|n| n * spec.brick.order() as f64 + 1.0);
    let (mesh, bytes) = MEASURED;
    let beside = BYTES_BESIDE * 3.0 * nodes.iter().product::<f64>();
    Ok(size::bytes(
        "mesh",
        beside + bytes * dissected(nodes) / dissected(mesh),
    )?)
}
