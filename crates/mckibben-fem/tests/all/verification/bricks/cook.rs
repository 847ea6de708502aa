//! H. Cook's membrane, nearly incompressible neo-Hooke, plane strain, mean dilatation (Q1P0): the
//! tip mesh by mesh.
//!
//! Loaded and held: the left side clamped, a dead load of 100 N upwards on the right side, z held
//! everywhere.

use super::{block::Block, body, drive};
use crate::verification::{Rows, neo_hookean};
use mckibben_core::muscle::Bulk;
use mckibben_fem::three_dimensional::{Brick, Freedom};

/// u_y of the upper right corner in mm with n × n bricks and F = 100 N.
fn tip(n: usize) -> Option<f64> {
    let block = Block {
        brick: Brick::Linear,
        elements: [1, n, n],
    };
    // First direction: the thickness (z); second and third: along and across.
    let bulk = Bulk::Modulus(400_889.806);
    let mut problem = block.problem(neo_hookean(80.1938), bulk, |[t, x, y]| {
        let low = 44.0 * x;
        let high = 44.0 + 16.0 * x;
        [48.0 * x, low + (high - low) * y, t]
    });
    problem.dead = vec![[0.0; 3]; problem.nodes.len()];
    for (node, [_, j, k]) in block.places().into_iter().enumerate() {
        problem.freedom[node][2] = Freedom::Held;
        if j == 0 {
            problem.freedom[node] = [Freedom::Held; 3];
        }
        if j == n {
            let share = if k == 0 || k == n { 0.5 } else { 1.0 };
            problem.dead[node][1] = 100.0 * 0.5 * share / n as f64;
        }
    }
    let corner = block.node(0, n, n);
    let mut body = body(problem)?;
    drive(&mut body, 1.0, 0.0, 4)?;
    Some(body.state.u[3 * corner + 1])
}

/// The rows of H.
pub fn cook(rows: &mut Rows) {
    add_meshes(
        rows,
        &[(4, 6.0199), (8, 6.6186), (16, 6.8144), (32, 6.8842)],
    );
}

/// Those of the finest meshes.
pub fn cook_fine(rows: &mut Rows) {
    add_meshes(rows, &[(64, 6.9115), (128, 6.9231)]);
}

fn add_meshes(rows: &mut Rows, meshes: &[(usize, f64)]) {
    for &(n, exact) in meshes {
        rows.add(
            format!("Cook's membrane, {n} × {n}: tip (mm)"),
            exact,
            tip(n),
            1e-5,
        );
    }
}
