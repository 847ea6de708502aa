//! Laws written in the principal stretches, in an axisymmetric state.
//!
//! F = R(α) diag(λ1, λ2) R(β)ᵀ in the section, λ3 = t. With d = ∂W/∂λ and the dyads M_ij = R(α)e_i
//! ⊗ R(β)e_j
//!
//!   P = Σ d_i M_ii,   A = Σ ∂²W/∂λi∂λj M_ii⊗M_jj + ½(u + v)(M12⊗M12 + M21⊗M21) + ½(u − v)(M12⊗M21 + M21⊗M12)
//!   u = (d1 − d2)/(λ1 − λ2),  v = (d1 + d2)/(λ1 + λ2)        (Ogden 1984 \[ogden1984\], §6.1)

use super::plane_law::{Gradient, PlaneLaw, Stress};
use mckibben_core::rubber::RubberLaw;

/// A law in the principal stretches.
#[derive(Debug)]
pub struct ByStretches<'a, L>(pub &'a L);

/// Where two stretches are nearer than this, the divided difference is replaced by its limit.
const NEAR: f64 = 1e-5;

/// w(J^(−1/3) λ), its derivatives τ_i in ln λ_i, and theirs.
pub(crate) fn logarithmic<L: RubberLaw>(law: &L, l: [f64; 3]) -> (f64, [f64; 3], [[f64; 3]; 3]) {
    let root = (l[0] * l[1] * l[2]).cbrt();
    let bar = l.map(|x| x / root);
    let p = law.principal(bar);
    // e_i = λ̄i d_i, then the projection that takes out the mean.
    let e = [0, 1, 2].map(|i| bar[i] * p.d[i]);
    let mean = (e[0] + e[1] + e[2]) / 3.0;
    let mut ee = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            ee[i][j] = bar[i] * bar[j] * p.dd[i][j] + if i == j { e[i] } else { 0.0 };
        }
    }
    let row = [0, 1, 2].map(|i| (ee[i][0] + ee[i][1] + ee[i][2]) / 3.0);
    let all = (row[0] + row[1] + row[2]) / 3.0;
    let second = [0, 1, 2].map(|i| [0, 1, 2].map(|j| ee[i][j] - row[i] - row[j] + all));
    (p.w, e.map(|x| x - mean), second)
}

/// First and second derivatives of w(J^(−1/3) λ) in λ.
fn isochoric<L: RubberLaw>(law: &L, l: [f64; 3]) -> (f64, [f64; 3], [[f64; 3]; 3]) {
    let (w, tau, log) = logarithmic(law, l);
    let dd = [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| (log[i][j] - if i == j { tau[i] } else { 0.0 }) / (l[i] * l[j]))
    });
    (w, [0, 1, 2].map(|i| tau[i] / l[i]), dd)
}

impl<L: RubberLaw> PlaneLaw for ByStretches<'_, L> {
    fn stress<const TANGENT: bool>(&self, f: &Gradient, p: f64) -> Stress {
        let Gradient { a, b, c, d, t } = *f;
        let [l1, l2, _] = f.principal();
        let turn = (c - b).atan2(a + d);
        let double = (b + c).atan2(a - d);
        let (sa, ca) = (0.5 * (double + turn)).sin_cos();
        let (sb, cb) = (0.5 * (double - turn)).sin_cos();
        let (w, g, h) = isochoric(self.0, [l1, l2, t]);
        // Dyads in the order (a, b, c, d).
        let m11 = [ca * cb, ca * sb, sa * cb, sa * sb];
        let m22 = [sa * sb, -sa * cb, -ca * sb, ca * cb];
        let m12 = [-ca * sb, ca * cb, -sa * sb, sa * cb];
        let m21 = [-sa * cb, -sa * sb, ca * cb, ca * sb];
        let cofactor = [d, -c, -b, a];
        let area = f.section();
        let s = |i: usize| g[0] * m11[i] + g[1] * m22[i] + p * t * cofactor[i];
        let mut out = Stress {
            w,
            r: [s(0), s(1), g[2] + p * area],
            z: [s(2), s(3)],
            ..Stress::default()
        };
        if TANGENT {
            let u = if (l1 - l2).abs() < NEAR * (l1 + l2) {
                0.5 * (h[0][0] + h[1][1]) - h[0][1]
            } else {
                (g[0] - g[1]) / (l1 - l2)
            };
            let v = (g[0] + g[1]) / (l1 + l2);
            let same = 0.5 * (u + v);
            let cross = 0.5 * (u - v);
            let k = |i: usize, j: usize| {
                let curved = match (i, j) {
                    (0, 3) | (3, 0) => p * t,
                    (1, 2) | (2, 1) => -p * t,
                    _ => 0.0,
                };
                h[0][0] * m11[i] * m11[j]
                    + h[1][1] * m22[i] * m22[j]
                    + h[0][1] * (m11[i] * m22[j] + m22[i] * m11[j])
                    + same * (m12[i] * m12[j] + m21[i] * m21[j])
                    + cross * (m12[i] * m21[j] + m21[i] * m12[j])
                    + curved
            };
            let kt = |i: usize| h[0][2] * m11[i] + h[1][2] * m22[i] + p * cofactor[i];
            out.rr = [
                [k(0, 0), k(0, 1), kt(0)],
                [k(0, 1), k(1, 1), kt(1)],
                [kt(0), kt(1), h[2][2]],
            ];
            out.rz = [[k(0, 2), k(0, 3)], [k(1, 2), k(1, 3)], [kt(2), kt(3)]];
            out.zz = [[k(2, 2), k(2, 3)], [k(2, 3), k(3, 3)]];
        }
        out
    }
}
