//! D. Torsion of a solid cylinder (Rivlin 1949 \[rivlin1949\]): M = πR⁴ψ(C1 + C2), N = −½πR⁴ψ²(C1 +
//! 2 C2).
//!
//! Loaded and held: both ends by the rotation about the axis, length and plane sections held, the
//! side free.

use super::{block::Block, body, push};
use crate::verification::{Rows, rubber};
use mckibben_core::muscle::Bulk;
use mckibben_fem::{
    solver::newton::NewtonSystem as _,
    three_dimensional::{Brick, Freedom},
};

const RADIUS: f64 = 5.0;
/// ψ in rad/mm.
const TWIST: f64 = 0.05;
const HEIGHT: f64 = 2.0;

/// Moment and axial force on the top.
fn loads(elements: usize) -> Option<(f64, f64)> {
    let block = Block {
        brick: Brick::Quadratic,
        elements: [elements, elements, 1],
    };
    // The square becomes a disc (the elliptical map).
    let mut problem = block.problem(rubber(), Bulk::Incompressible, |[x, y, z]| {
        let u = 2.0 * x - 1.0;
        let v = 2.0 * y - 1.0;
        [
            RADIUS * u * (1.0 - 0.5 * v * v).sqrt(),
            RADIUS * v * (1.0 - 0.5 * u * u).sqrt(),
            HEIGHT * z,
        ]
    });
    let last = block.grid()[2] - 1;
    let places = block.places();
    for (node, [_, _, k]) in places.iter().enumerate() {
        if [0, last].contains(k) {
            problem.freedom[node] = [Freedom::Held; 3];
        }
    }
    let nodes = problem.nodes.clone();
    let (sin, cos) = (TWIST * HEIGHT).sin_cos();
    let mut body = body(problem)?;
    push(&mut body, 1, |n, i| {
        let [x, y, z] = nodes[n];
        if z < 0.5 * HEIGHT {
            return 0.0;
        }
        [cos * x - sin * y - x, sin * x + cos * y - y, 0.0][i]
    })?;
    body.residual().ok()?;
    let mut moment = 0.0;
    let mut axial = 0.0;
    for n in (0..nodes.len()).filter(|&n| places[n][2] == last) {
        let x = [0, 1, 2].map(|i| nodes[n][i] + body.state.u[3 * n + i]);
        let f = &body.assembled.force[3 * n..];
        moment += x[0] * f[1] - x[1] * f[0];
        axial += f[2];
    }
    Some((moment, axial))
}

/// The rows of D.
pub fn torsion(rows: &mut Rows) {
    let (moment, axial) = loads(6).unzip();
    rows.add(
        "solid cylinder, torsion: M (N·mm)",
        11.780_972_45,
        moment,
        2e-4,
    );
    rows.add("solid cylinder, torsion: N (N)", -0.343_611_70, axial, 2e-3);
}
