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

use super::{
    lanes::Real,
    spatial::{AT, PAIRS, Spatial, SpatialLaw, Symmetric, Vector},
};

/// A shape function's values at an integration point of the parent cube.
#[derive(Debug)]
pub struct ShapePoint {
    /// N_a
    pub n: Vec<f64>,
    /// ∂N_a/∂(ξ, η, ζ)
    pub dn: Vec<Vector>,
    /// Weight.
    pub weight: f64,
}

/// Pressure modes at rest: ψ_k = Σ_{m ≤ k} a_km (1, X − Xc, Y − Yc, Z − Zc)_m.
#[derive(Debug, Clone, Default)]
pub struct Modes {
    /// Xc in mm.
    pub centre: Vector,
    /// a_km
    pub factors: [[f64; 4]; 4],
    /// V in mm³.
    pub volume: f64,
}

impl ShapePoint {
    /// The place of the point in a brick with these nodes.
    pub fn place(&self, nodes: &[Vector]) -> Vector {
        [0, 1, 2].map(|i| self.n.iter().zip(nodes).map(|(n, x)| n * x[i]).sum())
    }
}

impl Modes {
    /// 1, X − Xc, Y − Yc, Z − Zc
    pub fn monomials(&self, x: &Vector) -> [f64; 4] {
        let c = &self.centre;
        [1.0, x[0] - c[0], x[1] - c[1], x[2] - c[2]]
    }
}

/// What a kernel reads, one element a lane.
#[derive(Debug)]
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

impl<R: Real, const NN: usize, const NM: usize> Input<R, NN, NM> {
    /// |∂X/∂ξ|, J, b = F Fᵀ and the gradients of the shape functions in the present places.
    #[inline(always)]
    fn deform(&self, dn: &[Vector; NN]) -> (R, R, Symmetric<R>, [[R; 3]; NN]) {
        let s = R::splat;
        let rest = jacobian(&self.rest, dn);
        let now = jacobian(&self.now, dn);
        let d0 = determinant(&rest);
        let d1 = determinant(&now);
        let adj0 = adjugate(&rest);
        let adj1 = adjugate(&now);
        let r0 = d0.recip();
        let r1 = d1.recip();
        // F = (∂x/∂ξ)(∂X/∂ξ)⁻¹
        let mut f = [[s(0.0); 3]; 3];
        for i in 0..3 {
            for k in 0..3 {
                f[i][k] =
                    (now[i][0] * adj0[0][k] + now[i][1] * adj0[1][k] + now[i][2] * adj0[2][k]) * r0;
            }
        }
        let mut b = [s(0.0); 6];
        for (k, &(x, y)) in PAIRS.iter().enumerate() {
            b[k] = f[x][0] * f[y][0] + f[x][1] * f[y][1] + f[x][2] * f[y][2];
        }
        let mut g = [[s(0.0); 3]; NN];
        for (g, dn) in g.iter_mut().zip(dn) {
            for i in 0..3 {
                let sum = s(dn[1]).mul_add(adj1[1][i], s(dn[2]) * adj1[2][i]);
                g[i] = s(dn[0]).mul_add(adj1[0][i], sum) * r1;
            }
        }
        (d0, d1 * r0, b, g)
    }

    /// ψ_k where the shape functions have the values `n`.
    #[inline(always)]
    fn pressure_modes(&self, n: &[f64]) -> [R; NM] {
        let mut psi = [R::splat(1.0); NM];
        if NM > 1 {
            let mut at = [R::splat(0.0); 3];
            for a in 0..NN {
                let n = R::splat(n[a]);
                for i in 0..3 {
                    at[i] = n.mul_add(self.rest[a][i], at[i]);
                }
            }
            for i in 0..3 {
                at[i] = at[i] - self.centre[i];
            }
            for k in 1..NM {
                let q = &self.factors[k];
                psi[k] = q[0] + q[1] * at[0] + q[2] * at[1] + q[3] * at[2];
            }
        }
        psi
    }
}

/// What a kernel writes, one element a lane.
#[derive(Debug)]
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

    #[inline(always)]
    fn condense<const TANGENT: bool>(&mut self, input: &Input<R, NN, NM>) {
        let s = R::splat;
        let share = s(input.augment) * input.volume.recip();
        for k in 0..NM {
            self.defect[k] = self.defect[k] - input.p[k] * input.volume * s(input.compliance);
            let pressure = share.mul_add(self.defect[k], input.p[k]);
            for a in 0..NN {
                for i in 0..3 {
                    self.force[a][i] = pressure.mul_add(self.gradient[k][a][i], self.force[a][i]);
                }
            }
            if TANGENT {
                let mut blocks = self.tangent.iter_mut();
                for a in 0..NN {
                    let row = self.gradient[k][a];
                    for (b, block) in (a..NN).zip(&mut blocks) {
                        let column = self.gradient[k][b];
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
pub(crate) fn jacobian<R: Real>(x: &[[R; 3]], dn: &[Vector]) -> [[R; 3]; 3] {
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
pub fn integrate_bricks<R: Real, const NN: usize, const NM: usize, const TANGENT: bool>(
    points: &[ShapePoint],
    input: &Input<R, NN, NM>,
    law: SpatialLaw<'_>,
    out: &mut Output<R, NN, NM>,
) {
    let o = R::splat(0.0);
    out.force = [[o; 3]; NN];
    out.gradient = [[[o; 3]; NN]; NM];
    out.defect = [o; NM];
    out.energy = o;
    out.smallest_j = R::splat(f64::MAX);
    if TANGENT {
        out.tangent.fill([o; 9]);
    }
    for point in points {
        let Ok(dn) = <&[Vector; NN]>::try_from(&point.dn[..]) else {
            continue;
        };
        let (d0, j, b, g) = input.deform(dn);
        out.smallest_j = out.smallest_j.min(j);
        let dv = d0 * R::splat(point.weight);
        let jdv = j * dv;
        let psi = input.pressure_modes(&point.n);
        for k in 0..NM {
            out.defect[k] = out.defect[k] + psi[k] * (jdv - dv);
            let weight = psi[k] * jdv;
            for a in 0..NN {
                for i in 0..3 {
                    out.gradient[k][a][i] = weight.mul_add(g[a][i], out.gradient[k][a][i]);
                }
            }
        }
        let mut state = law.spatial::<R, TANGENT>(&b, j);
        out.energy = dv.mul_add(state.w, out.energy);
        for t in &mut state.tau {
            *t = *t * dv;
        }
        add_forces(&g, &state.tau, &mut out.force);
        if TANGENT {
            let mut pressure = input.p[0];
            for k in 1..NM {
                pressure = psi[k].mul_add(input.p[k], pressure);
            }
            weigh_tangent(&mut state, dv, pressure * jdv);
            add_tangent(&g, &state.c, &state.tau, &mut out.tangent);
        }
    }
    out.condense::<TANGENT>(input);
}

/// Adds τ g.
#[inline(always)]
fn add_forces<R: Real, const NN: usize>(
    g: &[[R; 3]; NN],
    tau: &Symmetric<R>,
    force: &mut [[R; 3]; NN],
) {
    for a in 0..NN {
        for i in 0..3 {
            let sum = tau[AT[i][2]].mul_add(g[a][2], force[a][i]);
            let sum = tau[AT[i][1]].mul_add(g[a][1], sum);
            force[a][i] = tau[AT[i][0]].mul_add(g[a][0], sum);
        }
    }
}

/// c in a volume `dv`, and in c and τ what a pressure adds, times the volume now.
#[inline(always)]
fn weigh_tangent<R: Real>(state: &mut Spatial<R>, dv: R, pressure: R) {
    let c = &mut state.c;
    let tau = &mut state.tau;
    for row in c.iter_mut() {
        for c in row {
            *c = *c * dv;
        }
    }
    for a in 0..3 {
        tau[a] = tau[a] + pressure;
        for b in 0..3 {
            c[a][b] = c[a][b] + pressure;
        }
        c[a][a] = c[a][a] - pressure - pressure;
        c[a + 3][a + 3] = c[a + 3][a + 3] - pressure;
    }
}

/// Adds Bᵀ c B + gᵀ τ g 1.
#[inline(always)]
fn add_tangent<R: Real, const NN: usize>(
    g: &[[R; 3]; NN],
    c: &[Symmetric<R>; 6],
    tau: &Symmetric<R>,
    out: &mut [[R; 9]],
) {
    let o = R::splat(0.0);
    let mut blocks = out.iter_mut();
    for a in 0..NN {
        // left = B_aᵀ c, three rows of six; t = τ g_a.
        let x = g[a][0];
        let y = g[a][1];
        let z = g[a][2];
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
            let x = g[b][0];
            let y = g[b][1];
            let z = g[b][2];
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

/// The pressure modes of an element at rest, made orthonormal by Gram and Schmidt; `None` where the
/// element is turned inside out at rest.
pub fn modes(points: &[ShapePoint], rest: &[Vector], count: usize) -> Option<Modes> {
    let mut out = Modes::default();
    let mut at = Vec::with_capacity(points.len());
    for p in points {
        let d = determinant(&jacobian(rest, &p.dn));
        if !(d > 0.0 && d.is_finite()) {
            return None;
        }
        let weight = d * p.weight;
        let place = p.place(rest);
        out.volume += weight;
        for i in 0..3 {
            out.centre[i] += weight * place[i];
        }
        at.push((weight, place));
    }
    out.centre = out.centre.map(|x| x / out.volume);
    let value = |row: &[f64; 4], x: &Vector| -> f64 {
        let m = out.monomials(x);
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
