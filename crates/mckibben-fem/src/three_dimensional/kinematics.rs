//! Where nodes are now, and what bricks and strands do between them.

use super::body::Body;
use super::share::share;
use crate::element::brick::ShapePoint;
use crate::element::spatial::PAIRS;
use crate::element::spatial_stretches::principal_axes;
use crate::element::truss::{Pull, Truss};

/// Place now of a node in mm.
pub(super) fn now(body: &Body, node: usize) -> [f64; 3] {
    let (x, u) = (&body.discretisation.problem.nodes[node], &body.state.u[3 * node..3 * node + 3]);
    [x[0] + u[0], x[1] + u[1], x[2] + u[2]]
}

/// What a piece of a strand does now.
pub(super) fn pull(body: &Body, t: usize) -> Pull {
    let d = &body.discretisation;
    let (ends, truss) = &d.problem.trusses[t];
    let [a, b] = ends.map(|n| now(body, n as usize));
    let delta = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    let (compliance, augment) = d.strand[t];
    let truss = Truss { stiffness_n: augment, ..*truss };
    truss.pull(delta, share(compliance, augment) * body.state.q[t], 0.0)
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// b = F Fᵀ
pub(super) fn left(f: &[[f64; 3]; 3]) -> [f64; 6] {
    PAIRS.map(|(i, j)| dot(f[i], f[j]))
}

/// Largest principal stretch at F.
pub(super) fn largest_principal(f: &[[f64; 3]; 3]) -> f64 {
    principal_axes(&left(f)).0.into_iter().fold(0.0, f64::max).sqrt()
}

fn inverse(m: &[[f64; 3]; 3]) -> Option<[[f64; 3]; 3]> {
    let minor = |i: usize, j: usize| {
        let (a, b, c, d) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let det: f64 = (0..3).map(|j| m[0][j] * minor(0, j)).sum();
    (det != 0.0).then(|| [0, 1, 2].map(|i| [0, 1, 2].map(|j| minor(j, i) / det)))
}

/// F at a point of a brick, and its place in the reference configuration.
pub(super) fn gradient<const NN: usize>(
    body: &Body,
    brick: usize,
    nodes: &[u32],
    p: &ShapePoint<NN>,
) -> Option<([[f64; 3]; 3], [f64; 3])> {
    let (mut rest, mut here, mut at) = ([[0.0; 3]; 3], [[0.0; 3]; 3], [0.0; 3]);
    for (a, node) in nodes.iter().enumerate() {
        let (x, y) = (body.discretisation.problem.rest(brick, *node), now(body, *node as usize));
        for i in 0..3 {
            at[i] += p.n[a] * x[i];
            for j in 0..3 {
                rest[i][j] += x[i] * p.dn[a][j];
                here[i][j] += y[i] * p.dn[a][j];
            }
        }
    }
    let inverse = inverse(&rest)?;
    Some((here.map(|row| [0, 1, 2].map(|j| (0..3).map(|k| row[k] * inverse[k][j]).sum())), at))
}
