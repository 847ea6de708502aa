//! Shape functions and integration points of bricks with eight nodes (of order 1) and twenty-seven
//! (of order 2).
//!
//! Nodes run like the grid's: ξ first, then η, then ζ, from −1 to 1.

use super::{
    brick::ShapePoint,
    q2::{GAUSS2, GAUSS3, functions},
};

/// The brick of an order at a place.
pub fn shape_at(order: usize, place: [f64; 3], weight: f64) -> ShapePoint {
    let p = order + 1;
    let [(x, dx), (y, dy), (z, dz)] = place.map(|x| functions(p, x));
    let nodes = || (0..p.pow(3)).map(|a| (a % p, a / p % p, a / (p * p)));
    ShapePoint {
        n: nodes().map(|(i, j, k)| x[i] * y[j] * z[k]).collect(),
        dn: nodes()
            .map(|(i, j, k)| {
                [
                    dx[i] * y[j] * z[k],
                    x[i] * dy[j] * z[k],
                    x[i] * y[j] * dz[k],
                ]
            })
            .collect(),
        weight,
    }
}

/// 2 × 2 × 2 points of the linear brick, 3 × 3 × 3 of the quadratic one.
pub fn integration_points(order: usize) -> Vec<ShapePoint> {
    let rule: &[(f64, f64)] = if order == 1 { &GAUSS2 } else { &GAUSS3 };
    let mut out = Vec::with_capacity(rule.len().pow(3));
    for (z, wz) in rule {
        for (y, wy) in rule {
            out.extend(
                rule.iter()
                    .map(|(x, wx)| shape_at(order, [*x, *y, *z], wx * wy * wz)),
            );
        }
    }
    out
}
