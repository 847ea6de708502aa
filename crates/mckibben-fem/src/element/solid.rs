//! One Q2/P−1 element of rubber: forces, volume defects and exact tangent.
//!
//!   Π_e = ∫ W(F) + p (J − 1) − p²/(2K) dV,   p = Σ p_k ψ_k
//!
//! r: residual ∂Π/∂u, g_k = ∂Π/∂p_k = ∫ ψ_k (J − 1) dV − p_k V/K, B = ∂²Π/∂u∂p. K → ∞ for
//! incompressible rubber.

use super::{
    lanes::four_at_a_time,
    plane::{AnyPlaneLaw, Gradient, Stress},
    q2::{Geometry, MODES, NODES, PADDED, POINTS, Point},
    softened::soften,
};
use mckibben_core::rubber::over_time::OgdenRoxburgh;

/// A row of nodal values.
pub type NodalRow = [f64; PADDED];

/// Nodal displacements (mm) and pressure modes (MPa) of an element.
#[derive(Debug, Default)]
pub struct Unknowns {
    /// u_r
    pub r: NodalRow,
    /// u_z
    pub z: NodalRow,
    /// p_k
    pub p: [f64; MODES],
}

/// What an element contributes.
#[derive(Debug, Clone, Default)]
pub struct Contribution {
    /// Forces on the nodes, r.
    pub fr: NodalRow,
    /// Forces on the nodes, z.
    pub fz: NodalRow,
    /// Volume defects g_k.
    pub g: [f64; MODES],
    /// B, r.
    pub br: [NodalRow; MODES],
    /// B, z.
    pub bz: [NodalRow; MODES],
    /// Tangent r × r.
    pub rr: [NodalRow; NODES],
    /// Tangent r × z.
    pub rz: [NodalRow; NODES],
    /// Tangent z × z.
    pub zz: [NodalRow; NODES],
    /// Energy of the rubber in N·mm.
    pub energy: f64,
    /// Smallest volume ratio at an integration point.
    pub smallest_j: f64,
}

/// The rubber of an element.
#[derive(Clone)]
pub struct Material<'a> {
    /// The law of the first loading.
    pub law: &'a dyn AnyPlaneLaw,
    /// 1/K in 1/MPa.
    pub compliance: f64,
    /// How it softens, and the largest energy W_m in MPa that every integration point has seen.
    pub memory: Option<(OgdenRoxburgh, &'a [f64; POINTS])>,
}

impl Material<'_> {
    fn stresses<const TANGENT: bool>(
        &self,
        f: &[Gradient; POINTS],
        p: &[f64; POINTS],
        out: &mut [Stress; POINTS],
    ) {
        let Some((softening, seen_mpa)) = self.memory else {
            return self.law.stresses(TANGENT, f, p, out);
        };
        self.law.stresses(TANGENT, f, &[0.0; POINTS], out);
        for (k, s) in out.iter_mut().enumerate() {
            soften::<TANGENT>(&softening, seen_mpa[k], &f[k], p[k], s);
        }
    }
}

#[inline(always)]
fn dot(a: &NodalRow, b: &NodalRow) -> f64 {
    let mut lanes = [0.0; 4];
    for k in 0..PADDED / 4 {
        for (i, lane) in lanes.iter_mut().enumerate() {
            *lane += a[4 * k + i] * b[4 * k + i];
        }
    }
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3])
}

/// F at an integration point.
#[inline(always)]
pub fn gradient(p: &Point, u: &Unknowns) -> Gradient {
    Gradient {
        a: p.at_rest[0] + dot(&p.r, &u.r),
        b: dot(&p.z, &u.r),
        c: dot(&p.r, &u.z),
        d: p.at_rest[1] + dot(&p.z, &u.z),
        t: p.at_rest[0] + dot(&p.t, &u.r),
    }
}

four_at_a_time! {
    /// Fills `out`. Gives `false` where the element is turned inside out (J ≤ 0); `out` is
    /// then unfinished but for `smallest_j`.
    #[inline]
    pub fn contribute[TANGENT: bool](
        geometry: &Geometry,
        u: &Unknowns,
        material: &Material<'_>,
        out: &mut Contribution,
    ) -> bool = integrate_element
}

#[inline(always)]
fn integrate_element<const TANGENT: bool>(
    geometry: &Geometry,
    u: &Unknowns,
    material: &Material<'_>,
    out: &mut Contribution,
) -> bool {
    let zero = [0.0; PADDED];
    out.fr = zero;
    out.fz = zero;
    out.energy = 0.0;
    out.smallest_j = f64::INFINITY;
    out.g = u.p.map(|p| -p * geometry.volume * material.compliance);
    if TANGENT {
        out.br = [zero; MODES];
        out.bz = [zero; MODES];
        out.rr = [zero; NODES];
        out.rz = [zero; NODES];
        out.zz = [zero; NODES];
    }
    let mut gradients = [Gradient::default(); POINTS];
    let mut pressures = [0.0; POINTS];
    for ((point, f), p) in geometry
        .points
        .iter()
        .zip(&mut gradients)
        .zip(&mut pressures)
    {
        *f = gradient(point, u);
        let area = f.section();
        out.smallest_j = out.smallest_j.min(area * f.t);
        if !(area > 0.0 && f.t > 0.0) {
            out.smallest_j = out.smallest_j.min(area);
            return false;
        }
        *p = u.p[0] + u.p[1] * point.psi[1] + u.p[2] * point.psi[2];
    }
    let mut stresses = [Stress::default(); POINTS];
    material.stresses::<TANGENT>(&gradients, &pressures, &mut stresses);
    for ((point, f), s) in geometry.points.iter().zip(&gradients).zip(&stresses) {
        let area = f.section();
        let weight = point.volume;
        let j = area * f.t;
        out.energy += weight * s.w;
        for k in 0..MODES {
            out.g[k] += weight * point.psi[k] * (j - 1.0);
        }
        let ra = weight * s.r[0];
        let rb = weight * s.r[1];
        let rt = weight * s.r[2];
        let zc = weight * s.z[0];
        let zd = weight * s.z[1];
        for n in 0..PADDED {
            out.fr[n] += ra * point.r[n] + rb * point.z[n] + rt * point.t[n];
            out.fz[n] += zc * point.r[n] + zd * point.z[n];
        }
        if TANGENT {
            // ∂J/∂u_r = t(d N_R − c N_Z) + D N/R,  ∂J/∂u_z = t(a N_Z − b N_R)
            let jd = weight * f.t * f.d;
            let jc = weight * f.t * f.c;
            let ja = weight * f.t * f.a;
            let jb = weight * f.t * f.b;
            let jt = weight * area;
            for n in 0..PADDED {
                let r = jd * point.r[n] - jc * point.z[n] + jt * point.t[n];
                let z = ja * point.z[n] - jb * point.r[n];
                for k in 0..MODES {
                    out.br[k][n] += point.psi[k] * r;
                    out.bz[k][n] += point.psi[k] * z;
                }
            }
            tangent(point, s, weight, out);
        }
    }
    true
}

/// Adds one point's tangent; every row is a sum of products with the three rows of gradients.
#[inline(always)]
fn tangent(point: &Point, s: &Stress, weight: f64, out: &mut Contribution) {
    let Point { r, z, t, .. } = point;
    let mut g = [[0.0; PADDED]; 3];
    let mut q = [[0.0; PADDED]; 2];
    let mut h = [[0.0; PADDED]; 2];
    let rr = s.rr.map(|row| row.map(|x| weight * x));
    let rz = s.rz.map(|row| row.map(|x| weight * x));
    let zz = s.zz.map(|row| row.map(|x| weight * x));
    for n in 0..PADDED {
        let nr = r[n];
        let nz = z[n];
        let nt = t[n];
        for i in 0..3 {
            g[i][n] = rr[i][0] * nr + rr[i][1] * nz + rr[i][2] * nt;
        }
        for i in 0..2 {
            q[i][n] = rz[0][i] * nr + rz[1][i] * nz + rz[2][i] * nt;
            h[i][n] = zz[i][0] * nr + zz[i][1] * nz;
        }
    }
    for m in 0..NODES {
        let mr = r[m];
        let mz = z[m];
        let mt = t[m];
        let rr = &mut out.rr[m];
        let rz = &mut out.rz[m];
        let zz = &mut out.zz[m];
        for n in 0..PADDED {
            rr[n] += mr * g[0][n] + mz * g[1][n] + mt * g[2][n];
            rz[n] += q[0][m] * r[n] + q[1][m] * z[n];
            zz[n] += mr * h[0][n] + mz * h[1][n];
        }
    }
}
