//! Pressure in the closed cavity of a three-dimensional body, as the potential −P V.
//!
//! V = ⅓ ∫ x·(∂x/∂ξ × ∂x/∂η) over the faces of the cavity is the volume between them and the
//! origin. Planes of symmetry through the origin add nothing, the terminal adds ⅓ A z. With
//! polynomials for x it is a cubic form in the places of the nodes, which Gauss points integrate
//! exactly: forces and tangent are its exact derivatives, and the tangent is symmetric because the
//! cavity is closed (Schweizerhof & Ramm 1984 \[schweizerhof1984\]).

use crate::element::{
    q2::{GAUSS2, GAUSS3, functions},
    spatial::Vector,
};
use std::array::from_fn;

/// Values of the shape functions of a face with N nodes at its points: (N, ∂N/∂ξ, ∂N/∂η, weight).
pub type FacePoint<const N: usize> = ([f64; N], [f64; N], [f64; N], f64);

/// The points of a face of four nodes (two rows of two: the integrand is of degree two each way) or
/// nine (three rows of three: of degree five).
pub fn face_points<const N: usize>() -> Vec<FacePoint<N>> {
    let (p, gauss): (usize, &[(f64, f64)]) = if N == 4 { (2, &GAUSS2) } else { (3, &GAUSS3) };
    let mut out = Vec::with_capacity(N);
    for (b, wb) in gauss {
        for (a, wa) in gauss {
            let (x, dx) = functions(p, *a);
            let (y, dy) = functions(p, *b);
            out.push((
                from_fn(|k| x[k % p] * y[k / p]),
                from_fn(|k| dx[k % p] * y[k / p]),
                from_fn(|k| x[k % p] * dy[k / p]),
                wa * wb,
            ));
        }
    }
    out
}

/// Volume under a face and its derivatives.
#[derive(Debug)]
pub struct Volume<const N: usize> {
    /// V in mm³.
    pub value: f64,
    /// ∂V/∂x in mm².
    pub first: [Vector; N],
    /// ∂²V/∂x_a∂x_b is the skew matrix of this vector in mm: δa·(w × δb). See [`skew`].
    pub second: [[Vector; N]; N],
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The volume under a face whose nodes are at `x`.
///
/// With t = ∂x/∂ξ, e = ∂x/∂η: 3 V = ∫ x·(t × e); first derivatives N (t × e) + N_ξ (e × x) + N_η (x
/// × t). The second derivatives in x_a and x_b are the skew matrix W(w) with w = −(N_a N_ξb − N_ξa
/// N_b) e + (N_a N_ηb − N_ηa N_b) t − (N_ξa N_ηb − N_ηa N_ξb) x, taken as δx_a·(w × δx_b).
pub fn volume<const N: usize, const TANGENT: bool>(
    points: &[FacePoint<N>],
    x: &[Vector; N],
) -> Volume<N> {
    let mut out = Volume {
        value: 0.0,
        first: [[0.0; 3]; N],
        second: [[[0.0; 3]; N]; N],
    };
    for (n, nx, ny, weight) in points {
        let sum = |w: &[f64; N]| -> Vector {
            let mut s = [0.0; 3];
            for a in 0..N {
                for i in 0..3 {
                    s[i] += w[a] * x[a][i];
                }
            }
            s
        };
        let p = sum(n);
        let t = sum(nx);
        let e = sum(ny);
        let te = cross(t, e);
        let ep = cross(e, p);
        let pt = cross(p, t);
        let w = weight / 3.0;
        out.value += w * (p[0] * te[0] + p[1] * te[1] + p[2] * te[2]);
        for a in 0..N {
            for i in 0..3 {
                out.first[a][i] += w * (n[a] * te[i] + nx[a] * ep[i] + ny[a] * pt[i]);
            }
            if TANGENT {
                for b in 0..N {
                    let se = w * (n[a] * nx[b] - nx[a] * n[b]);
                    let st = w * (n[a] * ny[b] - ny[a] * n[b]);
                    let sp = w * (nx[a] * ny[b] - ny[a] * nx[b]);
                    for i in 0..3 {
                        out.second[a][b][i] += -se * e[i] + st * t[i] - sp * p[i];
                    }
                }
            }
        }
    }
    out
}

/// ∂²V/∂x_a∂x_b as a matrix from its vector w: δa·(w × δb).
pub fn skew(w: &Vector) -> [Vector; 3] {
    [[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]]
}
