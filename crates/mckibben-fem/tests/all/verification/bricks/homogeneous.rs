//! A. Homogeneous states with bricks whose inner nodes are out of place: the patch test at large
//! strains.
//!
//! Loaded and held: the faces of a block by given displacements in one or two directions, all else
//! free.

use super::{BRICKS, block::bent_cube, body, push};
use crate::verification::Rows;
use mckibben_fem::{
    element::spatial::Vector,
    solver::newton::NewtonSystem as _,
    three_dimensional::{Body, Brick, Freedom},
};

/// The bent cube; the planes through the origin held, and what `held` says of
/// (node on the far faces x, y, z; direction).
fn cube(brick: Brick, held: impl Fn([bool; 3], usize) -> bool) -> Option<(Body, Vec<[bool; 3]>)> {
    let (block, mut problem) = bent_cube(brick);
    let last = block.grid()[0] - 1;
    let places = block.places();
    let far: Vec<[bool; 3]> = places.iter().map(|p| p.map(|i| i == last)).collect();
    for (node, place) in places.iter().enumerate() {
        for (i, &at) in place.iter().enumerate() {
            if at == 0 || held(far[node], i) {
                problem.freedom[node][i] = Freedom::Held;
            }
        }
    }
    Some((body(problem)?, far))
}

/// Nominal stress on the far face x for stretches of the far faces x and, where given, y; and the
/// largest distance of a node from where the homogeneous state has it.
fn stress(brick: Brick, x: f64, y: Option<f64>) -> Option<[f64; 2]> {
    let (mut body, far) = cube(brick, |far, i| {
        far[i] && (i == 0 || (i == 1 && y.is_some()))
    })?;
    let y = y.unwrap_or(x.powf(-0.5));
    let stretch = [x, y, 1.0 / (x * y)];
    push(&mut body, 10, |n, i| {
        if far[n][i] { stretch[i] - 1.0 } else { 0.0 }
    })?;
    body.residual().ok()?;
    let sum = (0..far.len())
        .filter(|&n| far[n][0])
        .map(|n| body.assembled.force[3 * n])
        .sum();
    Some([sum, distance(&body, |rest, i| (stretch[i] - 1.0) * rest[i])])
}

/// Largest distance of a node from its displacement in the homogeneous state, of (place at rest,
/// direction).
fn distance(body: &Body, exact: impl Fn(&Vector, usize) -> f64) -> f64 {
    let mut worst = 0.0_f64;
    for (k, u) in body.state.u.iter().enumerate() {
        worst = worst.max((u - exact(&body.discretisation.problem.nodes[k / 3], k % 3)).abs());
    }
    worst
}

/// The rows of A.
pub fn homogeneous(rows: &mut Rows) {
    for (brick, name) in BRICKS {
        for (what, y, exact) in [
            ("uniaxial", None, 0.385),
            ("equibiaxial", Some(2.0), 0.708_75),
            ("planar", Some(1.0), 0.45),
        ] {
            let exact = [
                ("nominal stress (MPa)", exact),
                ("largest displacement off (mm)", 0.0),
            ];
            rows.add_each(
                &format!("{name}, patch test, {what} λ = 2: "),
                exact,
                stress(brick, 2.0, y),
                1e-10,
            );
        }
    }
}

const GAMMA: f64 = 1.0;

/// σ12, σ11 − σ33, σ22 − σ33 in MPa of simple shear, and the largest distance of a node from where
/// the homogeneous state has it.
///
/// x = X + γ Y: σ12 = 2(C1 + C2)γ, σ11 − σ33 = 2 C1 γ², σ22 − σ33 = −2 C2 γ² (Rivlin 1948). The
/// mean nominal stress P = Σ f⊗X/V over the nodes (virtual work of an affine displacement) gives σ
/// = P Fᵀ at J = 1. All faces are held at x = X + γ Y; the far face z = 1 is free along z, so that
/// the pressure is determined.
fn sheared(brick: Brick) -> Option<[f64; 4]> {
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
    let sheared = |rest: &Vector, i: usize| if i == 0 { GAMMA * rest[1] } else { 0.0 };
    let mut body = body(problem)?;
    push(&mut body, 10, |n, i| sheared(&rest[n], i))?;
    body.residual().ok()?;
    let forces = body.assembled.force.chunks_exact(3);
    let p: [Vector; 3] = [0, 1, 2]
        .map(|i| [0, 1, 2].map(|j| forces.clone().zip(&rest).map(|(f, x)| f[i] * x[j]).sum()));
    let f = [[1.0, GAMMA, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let sigma = |i: usize, j: usize| (0..3).map(|k| p[i][k] * f[j][k]).sum::<f64>();
    let [normal, second] = [sigma(0, 0) - sigma(2, 2), sigma(1, 1) - sigma(2, 2)];
    Some([sigma(0, 1), normal, second, distance(&body, sheared)])
}

/// The rows of simple shear.
pub fn shear(rows: &mut Rows) {
    for (brick, name) in BRICKS {
        let exact = [
            ("σ12 (MPa)", 2.0 * (0.10 + 0.02) * GAMMA),
            ("σ11 − σ33 (MPa)", 2.0 * 0.10 * GAMMA * GAMMA),
            ("σ22 − σ33 (MPa)", -2.0 * 0.02 * GAMMA * GAMMA),
            ("largest displacement off (mm)", 0.0),
        ];
        rows.add_each(
            &format!("{name}, simple shear γ = 1: "),
            exact,
            sheared(brick),
            1e-10,
        );
    }
}
