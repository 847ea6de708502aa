//! A. Simple shear (Rivlin 1948 \[rivlin1948\]) with bricks whose inner nodes are out of place: x = X + γ Y.
//!
//! σ12 = 2(C1 + C2)γ, σ11 − σ33 = 2 C1 γ², σ22 − σ33 = −2 C2 γ². The mean nominal stress P = Σ f⊗X/V over the nodes (virtual work of
//! an affine displacement) gives σ = P Fᵀ at J = 1. The far face z = 1 is free along z, so that the pressure is determined.
//!
//! Loaded and held: all faces by x = X + γ Y, the far face z = 1 free along z.

// Components are counted: several arrays share an index.
#![allow(clippy::needless_range_loop)]

use super::block::bent_cube;
use super::{BRICKS, body, push};
use crate::three_dimensional::{Brick, Freedom};
use crate::verification::VerificationRow;

const SOURCE: &str = "A: Rivlin 1948 [rivlin1948], simple shear (bricks)";
const GAMMA: f64 = 1.0;

/// (σ12, σ11 − σ33, σ22 − σ33) in MPa, and the largest distance of a node from where the homogeneous state has it.
fn sheared(brick: Brick) -> Option<([f64; 3], f64)> {
    let (block, mut problem) = bent_cube(brick);
    let last = block.grid()[0] - 1;
    for (node, place) in block.places().iter().enumerate() {
        if place.iter().any(|&i| i == 0 || i == last) {
            problem.freedom[node] = [Freedom::Held; 3];
        }
        if place[2] == last {
            problem.freedom[node][2] = Freedom::Free;
        }
    }
    let rest = problem.nodes.clone();
    let mut body = body(problem)?;
    push(&mut body, 10, |n, i| if i == 0 { GAMMA * rest[n][1] } else { 0.0 })?;
    body.evaluate().ok()?;
    let (mut p, mut worst) = ([[0.0; 3]; 3], 0.0_f64);
    for (n, x) in rest.iter().enumerate() {
        for i in 0..3 {
            let exact = if i == 0 { GAMMA * x[1] } else { 0.0 };
            worst = worst.max((body.state.u[3 * n + i] - exact).abs());
            for (j, x) in x.iter().enumerate() {
                p[i][j] += body.assembled.force[3 * n + i] * x;
            }
        }
    }
    let f = [[1.0, GAMMA, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let sigma = |i: usize, j: usize| (0..3).map(|k| p[i][k] * f[j][k]).sum::<f64>();
    Some(([sigma(0, 1), sigma(0, 0) - sigma(2, 2), sigma(1, 1) - sigma(2, 2)], worst))
}

/// The rows of simple shear.
pub fn shear() -> Vec<VerificationRow> {
    let mut rows = Vec::new();
    for (brick, name) in BRICKS {
        let got = sheared(brick);
        for (i, (what, exact)) in [
            ("σ12", 2.0 * (0.10 + 0.02) * GAMMA),
            ("σ11 − σ33", 2.0 * 0.10 * GAMMA * GAMMA),
            ("σ22 − σ33", -2.0 * 0.02 * GAMMA * GAMMA),
        ]
        .into_iter()
        .enumerate()
        {
            let title = format!("{name}, simple shear γ = 1: {what} (MPa)");
            rows.push(VerificationRow::new(title, SOURCE, exact, got.map(|g| g.0[i]), 1e-9));
        }
        let title = format!("{name}, simple shear γ = 1: largest displacement off (mm)");
        rows.push(VerificationRow::new(title, SOURCE, 0.0, got.map(|g| g.1), 1e-10));
    }
    rows
}
