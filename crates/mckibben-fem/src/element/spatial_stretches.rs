//! Laws written in the principal stretches, in any state of deformation.
//!
//! b = Σ λa² na⊗na, τ = Σ τa na⊗na with τa = ∂w/∂ln λa of the isochoric law, and (Ogden 1984
//! \[ogden1984\], §6.1; Simo & Taylor 1991 \[simo1991\])
//!
//!   c = Σ (∂τa/∂ln λb − 2 τa δab) na⊗na⊗nb⊗nb + Σ_{a<b} gab S⊗S,   S = na⊗nb + nb⊗na
//!   gab = (τa λb² − τb λa²)/(λa² − λb²)

use super::{
    lanes::Real,
    stretches::logarithmic,
    tensor::{PAIRS, Spatial, Symmetric},
};
use mckibben_core::rubber::RubberLaw;

/// A law in the principal stretches.
pub trait Stretches: Sync {
    /// τ and c at b.
    fn spatial_at(&self, b: &Symmetric<f64>) -> Spatial<f64>;
}

impl<L: RubberLaw> Stretches for L {
    fn spatial_at(&self, b: &Symmetric<f64>) -> Spatial<f64> {
        spatial_by_stretches(self, b)
    }
}

/// Where two squared stretches are nearer than this share, the divided difference is replaced by
/// its limit.
const NEAR: f64 = 1e-5;
/// Sweeps of Jacobi's method; five or six are enough for a 3 × 3 matrix.
const SWEEPS: usize = 12;

/// Eigenvalues and eigenvectors (in columns) of a symmetric tensor (Jacobi 1846).
pub(crate) fn principal_axes(b: &Symmetric<f64>) -> ([f64; 3], [[f64; 3]; 3]) {
    let mut a = [[b[0], b[3], b[5]], [b[3], b[1], b[4]], [b[5], b[4], b[2]]];
    let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..SWEEPS {
        let off = a[0][1].abs() + a[1][2].abs() + a[0][2].abs();
        if off.is_nan() || off <= 1e-18 * (a[0][0].abs() + a[1][1].abs() + a[2][2].abs()) {
            break;
        }
        for (p, q) in [(0, 1), (1, 2), (0, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            for row in &mut a {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            for k in 0..3 {
                (a[p][k], a[q][k]) = (c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]);
            }
            for row in &mut v {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
        }
    }
    ([a[0][0], a[1][1], a[2][2]], v)
}

fn spatial_by_stretches<L: RubberLaw>(law: &L, b: &Symmetric<f64>) -> Spatial<f64> {
    let (squares, n) = principal_axes(b);
    let (w, tau, log) = logarithmic(law, squares.map(f64::sqrt));
    let dyad =
        |a: usize, b: usize| PAIRS.map(|(i, j)| 0.5 * (n[i][a] * n[j][b] + n[j][a] * n[i][b]));
    let m = [dyad(0, 0), dyad(1, 1), dyad(2, 2)];
    let mut out = Spatial {
        w,
        ..Spatial::zero()
    };
    for a in 0..3 {
        for k in 0..6 {
            out.tau[k] += tau[a] * m[a][k];
        }
        for b in 0..3 {
            let value = log[a][b] - if a == b { 2.0 * tau[a] } else { 0.0 };
            for k in 0..6 {
                for l in 0..6 {
                    out.c[k][l] += value * m[a][k] * m[b][l];
                }
            }
        }
    }
    for (a, b) in [(0, 1), (1, 2), (0, 2)] {
        let x = squares[a];
        let y = squares[b];
        let g = if (x - y).abs() < NEAR * (x + y) {
            0.25 * (log[a][a] + log[b][b]) - 0.5 * log[a][b] - 0.5 * (tau[a] + tau[b])
        } else {
            (tau[a] * y - tau[b] * x) / (x - y)
        };
        let s = dyad(a, b);
        for k in 0..6 {
            for l in 0..6 {
                out.c[k][l] += 4.0 * g * s[k] * s[l];
            }
        }
    }
    out
}

/// Lane by lane.
#[inline(always)]
pub fn by_stretches<R: Real>(law: &dyn Stretches, b: &Symmetric<R>) -> Spatial<R> {
    let mut out = Spatial::<R>::zero();
    for l in 0..R::LANES {
        let mut here = [0.0; 6];
        for (x, y) in here.iter_mut().zip(b) {
            *x = y.lane(l);
        }
        let s = law.spatial_at(&here);
        out.w.set_lane(l, s.w);
        for k in 0..6 {
            out.tau[k].set_lane(l, s.tau[k]);
            for m in 0..6 {
                out.c[k][m].set_lane(l, s.c[k][m]);
            }
        }
    }
    out
}
