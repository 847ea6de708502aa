//! Where nodes are now, and what bricks and strands do between them.

use super::{body::Body, saddle::dot};
use crate::element::{
    brick::{ShapePoint, adjugate, determinant, jacobian},
    spatial::{PAIRS, Vector},
    spatial_stretches::principal_axes,
};
use mckibben_core::extremes::peak;

/// Place now of a node in mm.
pub fn now(body: &Body, node: usize) -> Vector {
    let x = &body.discretisation.problem.nodes[node];
    let u = &body.state.u[3 * node..3 * node + 3];
    [x[0] + u[0], x[1] + u[1], x[2] + u[2]]
}

/// b = F Fᵀ
pub fn left(f: &[Vector; 3]) -> [f64; 6] {
    PAIRS.map(|(i, j)| dot(&f[i], &f[j]))
}

/// Largest principal stretch at F.
pub fn largest_principal(f: &[Vector; 3]) -> f64 {
    peak(principal_axes(&left(f)).0).sqrt()
}

/// F at a point of a brick, and its place in the reference configuration.
pub fn gradient(body: &Body, brick: usize, p: &ShapePoint) -> Option<([Vector; 3], Vector)> {
    let problem = &body.discretisation.problem;
    let nodes = &problem.bricks[brick];
    let rest: Vec<Vector> = nodes
        .iter()
        .map(|node| problem.rest(brick, *node))
        .collect();
    let here: Vec<Vector> = nodes.iter().map(|node| now(body, *node as usize)).collect();
    let before = jacobian(&rest, &p.dn);
    let after = jacobian(&here, &p.dn);
    let volume = determinant(&before);
    let inverse = adjugate(&before);
    let f = after
        .map(|row| [0, 1, 2].map(|j| (0..3).map(|k| row[k] * inverse[k][j]).sum::<f64>() / volume));
    (volume != 0.0).then_some((f, p.place(&rest)))
}
