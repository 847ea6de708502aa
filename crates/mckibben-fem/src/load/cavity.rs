//! Pressure in the closed cavity, as the potential −P V.
//!
//! V = π ∫ r² dz along the line of the cavity's wall. With quadratic r and z the integrand is a
//! polynomial of degree five, which three Gauss points integrate exactly: forces and tangent are
//! the exact derivatives of V, and the tangent is symmetric because the cavity is closed by the
//! symmetry plane and the terminal (Schweizerhof & Ramm 1984 \[schweizerhof1984\]).

use crate::element::q2::{GAUSS3, along};
use std::f64::consts::PI;

/// Volume under a quadratic line element of the cavity and its derivatives in the six unknowns
/// (r, z of middle, left, right).
#[derive(Debug, Default)]
pub struct Volume {
    /// V in mm³
    pub value: f64,
    /// ∂V/∂x in mm²
    pub first: [f64; 6],
    /// ∂²V/∂x∂x in mm
    pub second: [[f64; 6]; 6],
}

/// `x`: places now (r, z of middle, left, right) in mm.
#[inline]
pub fn volume<const TANGENT: bool>(x: &[f64; 6]) -> Volume {
    let mut out = Volume::default();
    for (eta, weight) in GAUSS3 {
        let (n, d) = along(eta);
        let r = n[0] * x[0] + n[1] * x[2] + n[2] * x[4];
        let slope = d[0] * x[1] + d[1] * x[3] + d[2] * x[5];
        let w = PI * weight;
        out.value += w * r * r * slope;
        for a in 0..3 {
            out.first[2 * a] += w * 2.0 * r * slope * n[a];
            out.first[2 * a + 1] += w * r * r * d[a];
            if TANGENT {
                for b in 0..3 {
                    out.second[2 * a][2 * b] += w * 2.0 * slope * n[a] * n[b];
                    out.second[2 * a][2 * b + 1] += w * 2.0 * r * n[a] * d[b];
                    out.second[2 * a + 1][2 * b] += w * 2.0 * r * d[a] * n[b];
                }
            }
        }
    }
    out
}
