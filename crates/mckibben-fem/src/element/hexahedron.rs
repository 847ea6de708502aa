//! Shape functions and integration points of bricks with eight and twenty-seven nodes.
//!
//! Nodes run like the grid's: ξ first, then η, then ζ, from −1 to 1.

use super::brick::ShapePoint;
use super::q2::{GAUSS2, GAUSS3};

/// Nodes of the linear brick.
pub const NODES8: usize = 8;
/// Nodes of the quadratic brick.
pub const NODES27: usize = 27;

/// Linear functions on −1, 1 and their derivatives.
fn linear(x: f64) -> ([f64; 2], [f64; 2]) {
    ([0.5 * (1.0 - x), 0.5 * (1.0 + x)], [-0.5, 0.5])
}

/// Quadratic functions on −1, 0, 1 and their derivatives.
fn quadratic(x: f64) -> ([f64; 3], [f64; 3]) {
    ([0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)], [x - 0.5, -2.0 * x, x + 0.5])
}

fn product<const P: usize, const NN: usize>(
    rule: impl Fn(f64) -> ([f64; P], [f64; P]),
    at: [f64; 3],
    weight: f64,
) -> ShapePoint<NN> {
    let [(x, dx), (y, dy), (z, dz)] = at.map(rule);
    let place = |a: usize| (a % P, a / P % P, a / (P * P));
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

/// The linear brick at a place.
pub fn at8(at: [f64; 3], weight: f64) -> ShapePoint<NODES8> {
    product(linear, at, weight)
}

/// The quadratic brick at a place.
pub fn at27(at: [f64; 3], weight: f64) -> ShapePoint<NODES27> {
    product(quadratic, at, weight)
}

fn cube<const N: usize, const NN: usize>(
    rule: &[(f64, f64); N],
    point: impl Fn([f64; 3], f64) -> ShapePoint<NN>,
) -> Vec<ShapePoint<NN>> {
    let mut out = Vec::with_capacity(N * N * N);
    for (z, wz) in rule {
        for (y, wy) in rule {
            for (x, wx) in rule {
                out.push(point([*x, *y, *z], wx * wy * wz));
            }
        }
    }
    out
}

/// 2 × 2 × 2 points.
pub fn points8() -> Vec<ShapePoint<NODES8>> {
    cube(&GAUSS2, at8)
}

/// 3 × 3 × 3 points.
pub fn points27() -> Vec<ShapePoint<NODES27>> {
    cube(&GAUSS3, at27)
}
