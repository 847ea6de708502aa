//! Bricks with pressure modes: forces, volume defects and exact symmetric tangent.
//!
//!   Π_e = ∫ W̄(F) + p (J − 1) dV − p²V/(2K),   p = Σ p_k ψ_k,   ∫ ψ_k ψ_l dV = V δ_kl
//!   r = ∂Π/∂u,   c_k = ∂Π/∂p_k = ∫ ψ_k (J − 1) dV − p_k V/K,   G_k = ∂c_k/∂u = ∫ ψ_k J g dV
//!
//! with gradients g of the shape functions in the present places. One pressure mode on eight nodes
//! is the mean dilatation of Nagtegaal, Parks & Rice (1974) \[nagtegaal1974\], also called Q1P0;
//! four on twenty-seven nodes are Q2/P−1. The pressure is condensed with the part γ of the bulk
//! modulus (all of it where K ≤ γ):
//!
//!   K_e = ∂²Π/∂u∂u + (γ/V) Σ G_k G_kᵀ,   r_e = r + (γ/V) Σ c_k G_k
//!
//! The same code serves one, four or eight elements at a time ([`super::lanes`]).

use super::lanes::Real;
use super::spatial::{AT, PAIRS, SpatialLaw};

/// A shape function's values at an integration point of the parent cube.
#[derive(Debug, Clone)]
pub struct ShapePoint {
    /// N_a
    pub n: Vec<f64>,
    /// ∂N_a/∂(ξ, η, ζ)
    pub dn: Vec<[f64; 3]>,
    /// Weight.
    pub weight: f64,
}

/// Pressure modes at rest: ψ_k = Σ_{m ≤ k} a_km (1, X − Xc, Y − Yc, Z − Zc)_m.
#[derive(Debug, Clone, Copy, Default)]
pub struct Modes {
    /// Xc in mm.
    pub centre: [f64; 3],
    /// a_km
    pub factors: [[f64; 4]; 4],
    /// V in mm³.
    pub volume: f64,
}

/// What a kernel reads, one element a lane.
#[derive(Debug, Clone)]
pub struct Input<R, const NN: usize, const NM: usize> {
    /// Places at rest in mm.
    pub rest: [[R; 3]; NN],
    /// Places now in mm.
    pub now: [[R; 3]; NN],
    /// p_k in MPa.
    pub p: [R; NM],
    /// V in mm³.
    pub volume: R,
    /// See [`Modes`].
    pub centre: [R; 3],
    /// See [`Modes`].
    pub factors: [[R; 4]; 4],
    /// 1/K in 1/MPa.
    pub compliance: f64,
    /// γ in MPa.
    pub augment: f64,
}

/// What a kernel writes, one element a lane.
#[derive(Debug, Clone)]
pub struct Output<R, const NN: usize, const NM: usize> {
    /// r_e, with the condensed pressure.
    pub force: [[R; 3]; NN],
    /// G_k
    pub gradient: [[[R; 3]; NN]; NM],
    /// c_k
    pub defect: [R; NM],
    /// ∫ W̄ dV in N·mm.
    pub energy: R,
    /// Smallest J at an integration point.
    pub smallest_j: R,
    /// 3 × 3 blocks of K_e for node pairs a ≤ b, row after row.
    pub tangent: Vec<[R; 9]>,
}

impl<R: Real, const NN: usize, const NM: usize> Output<R, NN, NM> {
    /// Zeros.
    pub fn zero() -> Self {
        let o = R::splat(0.0);
        Self {
            force: [[o; 3]; NN],
            gradient: [[[o; 3]; NN]; NM],
            defect: [o; NM],
            energy: o,
            smallest_j: o,
            tangent: vec![[o; 9]; NN * (NN + 1) / 2],
        }
    }
}

#[inline(always)]
pub(crate) fn determinant<R: Real>(m: &[[R; 3]; 3]) -> R {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

/// det(m) m⁻¹
#[inline(always)]
pub(crate) fn adjugate<R: Real>(m: &[[R; 3]; 3]) -> [[R; 3]; 3] {
    let c = |a: usize, b: usize, c: usize, d: usize| m[a][b] * m[c][d] - m[a][d] * m[c][b];
    [
        [c(1, 1, 2, 2), c(0, 2, 2, 1), c(0, 1, 1, 2)],
        [c(1, 2, 2, 0), c(0, 0, 2, 2), c(0, 2, 1, 0)],
        [c(1, 0, 2, 1), c(0, 1, 2, 0), c(0, 0, 1, 1)],
    ]
}

/// ∂x/∂ξ
#[inline(always)]
pub(crate) fn jacobian<R: Real>(x: &[[R; 3]], dn: &[[f64; 3]]) -> [[R; 3]; 3] {
    let mut m = [[R::splat(0.0); 3]; 3];
    for (x, dn) in x.iter().zip(dn) {
        for j in 0..3 {
            let d = R::splat(dn[j]);
            for i in 0..3 {
                m[i][j] = d.mul_add(x[i], m[i][j]);
            }
        }
    }
    m
}

/// Fills `out`; the tangent only where `TANGENT`.
#[inline(always)]
pub fn run<R: Real, const NN: usize, const NM: usize, const TANGENT: bool>(
    points: &[ShapePoint],
    input: &Input<R, NN, NM>,
    law: SpatialLaw<'_>,
    out: &mut Output<R, NN, NM>,
) {
    let s = R::splat;
    let o = s(0.0);
    out.force = [[o; 3]; NN];
    out.gradient = [[[o; 3]; NN]; NM];
    out.defect = [o; NM];
    out.energy = o;
    out.smallest_j = s(f64::MAX);
    if TANGENT {
        for block in &mut out.tangent {
            *block = [o; 9];
        }
    }
    for point in points {
        let Ok(dn) = <&[[f64; 3]; NN]>::try_from(&point.dn[..]) else {
            continue;
        };
        let (rest, now) = (jacobian(&input.rest, dn), jacobian(&input.now, dn));
        let (d0, d1) = (determinant(&rest), determinant(&now));
        let dv = d0 * s(point.weight);
        let j = d1 * d0.recip();
        out.smallest_j = out.smallest_j.min(j);
        // F = (∂x/∂ξ)(∂X/∂ξ)⁻¹, b = F Fᵀ
        let (adj0, adj1) = (adjugate(&rest), adjugate(&now));
        let (r0, r1) = (d0.recip(), d1.recip());
        let mut f = [[o; 3]; 3];
        for i in 0..3 {
            for k in 0..3 {
                f[i][k] =
                    (now[i][0] * adj0[0][k] + now[i][1] * adj0[1][k] + now[i][2] * adj0[2][k]) * r0;
            }
        }
        let mut b = [o; 6];
        for (k, &(x, y)) in PAIRS.iter().enumerate() {
            b[k] = f[x][0] * f[y][0] + f[x][1] * f[y][1] + f[x][2] * f[y][2];
        }
        // Spatial gradients.
        let mut g = [[o; 3]; NN];
        for a in 0..NN {
            let dn = dn[a];
            for i in 0..3 {
                let sum = s(dn[0]).mul_add(
                    adj1[0][i],
                    s(dn[1]).mul_add(adj1[1][i], s(dn[2]) * adj1[2][i]),
                );
                g[a][i] = sum * r1;
            }
        }
        let mut psi = [s(1.0); NM];
        if NM > 1 {
            let mut at = [o; 3];
            for a in 0..NN {
                let n = s(point.n[a]);
                for i in 0..3 {
                    at[i] = n.mul_add(input.rest[a][i], at[i]);
                }
            }
            for i in 0..3 {
                at[i] = at[i] - input.centre[i];
            }
            for k in 1..NM {
                let q = &input.factors[k];
                psi[k] = q[0] + q[1] * at[0] + q[2] * at[1] + q[3] * at[2];
            }
        }
        let mut pressure = input.p[0];
        for k in 1..NM {
            pressure = psi[k].mul_add(input.p[k], pressure);
        }
        let mut state = law.spatial::<R, TANGENT>(&b, j);
        out.energy = dv.mul_add(state.w, out.energy);
        for t in &mut state.tau {
            *t = *t * dv;
        }
        let tau = &state.tau;
        let jdv = j * dv;
        for k in 0..NM {
            out.defect[k] = out.defect[k] + psi[k] * (jdv - dv);
            let weight = psi[k] * jdv;
            for a in 0..NN {
                for i in 0..3 {
                    out.gradient[k][a][i] = weight.mul_add(g[a][i], out.gradient[k][a][i]);
                }
            }
        }
        for a in 0..NN {
            for i in 0..3 {
                let t = tau[AT[i][0]].mul_add(
                    g[a][0],
                    tau[AT[i][1]].mul_add(g[a][1], tau[AT[i][2]].mul_add(g[a][2], out.force[a][i])),
                );
                out.force[a][i] = t;
            }
        }
        if TANGENT {
            let pj = pressure * jdv;
            let mut c = state.c;
            let mut whole = *tau;
            for a in 0..6 {
                for b in 0..6 {
                    c[a][b] = c[a][b] * dv;
                }
            }
            for a in 0..3 {
                whole[a] = whole[a] + pj;
                for b in 0..3 {
                    c[a][b] = c[a][b] + pj;
                }
                c[a][a] = c[a][a] - pj - pj;
                c[a + 3][a + 3] = c[a + 3][a + 3] - pj;
            }
            tangent(&g, &c, &whole, &mut out.tangent);
        }
    }
    condense::<R, NN, NM, TANGENT>(input, out);
}

/// Adds Bᵀ c B + gᵀ τ g 1.
#[inline(always)]
fn tangent<R: Real, const NN: usize>(
    g: &[[R; 3]; NN],
    c: &[[R; 6]; 6],
    tau: &[R; 6],
    out: &mut [[R; 9]],
) {
    let o = R::splat(0.0);
    let mut blocks = out.iter_mut();
    for a in 0..NN {
        // left = B_aᵀ c, three rows of six; t = τ g_a.
        let (x, y, z) = (g[a][0], g[a][1], g[a][2]);
        let mut left = [[o; 6]; 3];
        for m in 0..6 {
            left[0][m] = x.mul_add(c[0][m], y.mul_add(c[3][m], z * c[5][m]));
            left[1][m] = y.mul_add(c[1][m], x.mul_add(c[3][m], z * c[4][m]));
            left[2][m] = z.mul_add(c[2][m], y.mul_add(c[4][m], x * c[5][m]));
        }
        let mut t = [o; 3];
        for i in 0..3 {
            t[i] = x.mul_add(tau[AT[i][0]], y.mul_add(tau[AT[i][1]], z * tau[AT[i][2]]));
        }
        for (b, block) in (a..NN).zip(&mut blocks) {
            let (x, y, z) = (g[b][0], g[b][1], g[b][2]);
            let straight = x.mul_add(t[0], y.mul_add(t[1], z * t[2]));
            for i in 0..3 {
                let l = &left[i];
                block[3 * i] = x.mul_add(l[0], y.mul_add(l[3], z.mul_add(l[5], block[3 * i])));
                block[3 * i + 1] =
                    y.mul_add(l[1], x.mul_add(l[3], z.mul_add(l[4], block[3 * i + 1])));
                block[3 * i + 2] =
                    z.mul_add(l[2], y.mul_add(l[4], x.mul_add(l[5], block[3 * i + 2])));
            }
            block[0] = block[0] + straight;
            block[4] = block[4] + straight;
            block[8] = block[8] + straight;
        }
    }
}

#[inline(always)]
fn condense<R: Real, const NN: usize, const NM: usize, const TANGENT: bool>(
    input: &Input<R, NN, NM>,
    out: &mut Output<R, NN, NM>,
) {
    let s = R::splat;
    let share = s(input.augment) * input.volume.recip();
    for k in 0..NM {
        out.defect[k] = out.defect[k] - input.p[k] * input.volume * s(input.compliance);
        let pressure = share.mul_add(out.defect[k], input.p[k]);
        for a in 0..NN {
            for i in 0..3 {
                out.force[a][i] = pressure.mul_add(out.gradient[k][a][i], out.force[a][i]);
            }
        }
        if TANGENT {
            let mut blocks = out.tangent.iter_mut();
            for a in 0..NN {
                let row = out.gradient[k][a];
                for (b, block) in (a..NN).zip(&mut blocks) {
                    let column = out.gradient[k][b];
                    for i in 0..3 {
                        let left = share * row[i];
                        for j in 0..3 {
                            block[3 * i + j] = left.mul_add(column[j], block[3 * i + j]);
                        }
                    }
                }
            }
        }
    }
}

/// The pressure modes of an element at rest, made orthonormal by Gram and Schmidt; `None` where the
/// element is turned inside out at rest.
pub fn modes(points: &[ShapePoint], rest: &[[f64; 3]], count: usize) -> Option<Modes> {
    let mut out = Modes {
        factors: [[0.0; 4]; 4],
        ..Modes::default()
    };
    let mut at = Vec::with_capacity(points.len());
    for p in points {
        let d = determinant(&jacobian(rest, &p.dn));
        if !(d > 0.0 && d.is_finite()) {
            return None;
        }
        let place: [f64; 3] =
            std::array::from_fn(|i| p.n.iter().zip(rest).map(|(n, x)| n * x[i]).sum());
        out.volume += d * p.weight;
        for i in 0..3 {
            out.centre[i] += d * p.weight * place[i];
        }
        at.push((d * p.weight, place));
    }
    out.centre = out.centre.map(|x| x / out.volume);
    let monomials = |x: &[f64; 3]| {
        [
            1.0,
            x[0] - out.centre[0],
            x[1] - out.centre[1],
            x[2] - out.centre[2],
        ]
    };
    let value = |row: &[f64; 4], x: &[f64; 3]| -> f64 {
        let m = monomials(x);
        (0..4).map(|i| row[i] * m[i]).sum()
    };
    let mean = |a: &[f64; 4], b: &[f64; 4]| -> f64 {
        at.iter()
            .map(|(w, x)| w * value(a, x) * value(b, x))
            .sum::<f64>()
            / out.volume
    };
    let mut factors = [[0.0; 4]; 4];
    for k in 0..count.min(4) {
        let mut row = [0.0; 4];
        row[k] = 1.0;
        for before in &factors[..k] {
            let share = mean(&row, before);
            for (x, y) in row.iter_mut().zip(before) {
                *x -= share * y;
            }
        }
        let size = mean(&row, &row).sqrt();
        factors[k] = row.map(|x| x / size);
    }
    out.factors = factors;
    Some(out)
}
