//! Shape functions and integration points of bricks with eight and twenty-seven nodes.
//!
//! Nodes run like the grid's: ξ first, then η, then ζ, from −1 to 1.

use super::brick::ShapePoint;
use super::q2::{GAUSS2, GAUSS3, functions};

/// Nodes of the linear brick.
pub const NODES8: usize = 8;
/// Nodes of the quadratic brick.
pub const NODES27: usize = 27;

/// The brick of NN nodes at a place.
pub fn at<const NN: usize>(at: [f64; 3], weight: f64) -> ShapePoint<NN> {
    let p = if NN == NODES8 { 2 } else { 3 };
    let [(x, dx), (y, dy), (z, dz)] = at.map(|x| functions(p, x));
    let place = |a: usize| (a % p, a / p % p, a / (p * p));
    ShapePoint {
        at,
        n: std::array::from_fn(|a| {
            let (i, j, k) = place(a);
            x[i] * y[j] * z[k]
        }),
        dn: std::array::from_fn(|a| {
            let (i, j, k) = place(a);
            [dx[i] * y[j] * z[k], x[i] * dy[j] * z[k], x[i] * y[j] * dz[k]]
        }),
        weight,
    }
}

/// 2 × 2 × 2 points of the linear brick, 3 × 3 × 3 of the quadratic one.
pub fn points<const NN: usize>() -> Vec<ShapePoint<NN>> {
    let rule: &[(f64, f64)] = if NN == NODES8 { &GAUSS2 } else { &GAUSS3 };
    let mut out = Vec::with_capacity(rule.len().pow(3));
    for (z, wz) in rule {
        for (y, wy) in rule {
            out.extend(rule.iter().map(|(x, wx)| at([*x, *y, *z], wx * wy * wz)));
        }
    }
    out
}
