//! Two strand families ±θ0 on a line element of the tube's outer surface.
//!
//!   λf² = cos²θ0 λm² + sin²θ0 λθ²,   λm² = r'² + z'² (per length at rest),  λθ = (r + t/2)/Rs
//!
//! i.e. λf = |v| with v = (cosθ0 r', cosθ0 z', sinθ0 λθ), linear in the unknowns; Rs and t as
//! [`StrandLay`] has them (Rs = R, t = 0 of strands on the surface). Per family and area of the
//! sleeve as made the energy is ½k (λf − 1)² (or that of a [`Crimp`](mckibben_core::muscle::Crimp)),
//! written with the tension q per width as a separate variable:
//!
//!   Π_s = Σ_points 2 w [q c − q²/(2k)],   c = λf − 1,  w = 2πRs dZ.
//!
//! On plugs that are not as wide as the bore the braid is laid over the mounted tube, and its
//! strands carry nothing there. Its crossings keep their distance along the strands, sinθ = sinθ0
//! r0/Rs with r0 the radius at which the braid is laid; cosθ0 and dZ are then those of that shape,
//! and as many strands pass there, w = 2πRs cosθ0/cosθ ds0.
//!
//! For k → ∞ q is the Lagrange multiplier of λf = 1. Two Gauss points: as many conditions as a
//! quadratic line can follow without locking. The tangent takes the curvature of λf with q as it
//! was extrapolated by the last step, not with k c: Newton's method then takes far larger steps
//! with stiff strands (Magisano, Leonetti & Garcea 2017 \[magisano2017\]).

use super::q2::{GAUSS2, along};
use mckibben_core::muscle::StrandLay;
use std::f64::consts::PI;

/// Integration points of a line element.
pub const STRAND_POINTS: usize = 2;

/// A point of the line at rest.
#[derive(Debug, Clone)]
pub struct StrandPoint {
    /// cosθ0 dN/dZ, nodes in the order middle, left, right.
    pub slope: [f64; 3],
    /// sinθ0 N/Rs
    pub hoop: [f64; 3],
    /// Values at rest of the vector v: (0, cosθ0, sinθ0 (R + t/2)/Rs) on a cylinder.
    pub rest: [f64; 3],
    /// 2πRs dZ in mm².
    pub area: f64,
    /// Place Z at rest in mm.
    pub place: f64,
}

/// λf at a point and its derivatives in the six unknowns (r, z of middle, left, right).
#[derive(Debug, Default)]
pub struct Stretch {
    /// λf
    pub value: f64,
    /// ∂λf/∂u
    pub first: [f64; 6],
    /// v
    pub vector: [f64; 3],
}

/// The points of a line element with its nodes at rest (middle, left, right), of a tube with the
/// outer radius R in mm.
pub fn strand_points(
    nodes: [[f64; 2]; 3],
    radius: f64,
    lay: &StrandLay,
) -> [StrandPoint; STRAND_POINTS] {
    let (sin, cos0) = lay.angle_rad.sin_cos();
    let filled = lay.hoop_stretch(radius);
    let [middle, left, right] = nodes;
    GAUSS2.map(|(eta, weight)| {
        let (n, d) = along(eta);
        // r or z, and its slope along the element; without rounding on a cylinder.
        let [(r, r1), (z, z1)] = [0, 1].map(|c| {
            let half = 0.5 * (right[c] - left[c]);
            let bend = left[c] + right[c] - 2.0 * middle[c];
            (
                middle[c] + eta * half + 0.5 * eta * eta * bend,
                half + eta * bend,
            )
        });
        let half = r1.hypot(z1);
        let hoop = lay.hoop_stretch(r);
        // A sleeve that is wider than the tube lies on it only where plugs fill it.
        let laid = if hoop < filled {
            hoop / filled
        } else {
            hoop.max(1.0)
        };
        let cos = cos0 * ((1.0 - (sin * laid).powi(2)) / (1.0 - sin * sin)).sqrt();
        StrandPoint {
            slope: d.map(|x| cos * x / half),
            hoop: n.map(|x| sin * x / lay.radius_mm),
            rest: [cos * (r1 / half), cos * (z1 / half), sin * hoop],
            area: 2.0 * PI * lay.radius_mm * half * weight * (cos0 / cos),
            place: z,
        }
    })
}

impl StrandPoint {
    /// v with what displacements `u` = (r, z of middle, left, right) add.
    #[inline(always)]
    pub fn moved(&self, mut v: [f64; 3], u: &[f64; 6]) -> [f64; 3] {
        for a in 0..3 {
            v[0] += self.slope[a] * u[2 * a];
            v[1] += self.slope[a] * u[2 * a + 1];
            v[2] += self.hoop[a] * u[2 * a];
        }
        v
    }

    /// λf for the displacements `u` = (r, z of middle, left, right).
    #[inline(always)]
    pub fn stretch(&self, u: &[f64; 6]) -> Stretch {
        let v = self.moved(self.rest, u);
        let value = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
        let e = v.map(|x| x / value);
        let mut first = [0.0; 6];
        for a in 0..3 {
            first[2 * a] = e[0] * self.slope[a] + e[2] * self.hoop[a];
            first[2 * a + 1] = e[1] * self.slope[a];
        }
        Stretch {
            value,
            first,
            vector: v,
        }
    }

    /// ∂²λf/∂u_i∂u_j = (∂v/∂u_i·∂v/∂u_j − ∂λf/∂u_i ∂λf/∂u_j)/λf.
    #[inline(always)]
    pub fn curvature(&self, s: &Stretch, i: usize, j: usize) -> f64 {
        let a = i / 2;
        let b = j / 2;
        let mut product = 0.0;
        if i % 2 == j % 2 {
            product = self.slope[a] * self.slope[b];
            if i.is_multiple_of(2) {
                product += self.hoop[a] * self.hoop[b];
            }
        }
        (product - s.first[i] * s.first[j]) / s.value
    }

    /// Angle of the strands to the axis now, in radians: tanθ = sinθ0 λθ/(cosθ0 λm).
    pub fn angle_rad(&self, s: &Stretch) -> f64 {
        s.vector[2].atan2(s.vector[0].hypot(s.vector[1]))
    }
}
