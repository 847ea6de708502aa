//! Rubber in any state of deformation: Kirchhoff stress and spatial tangent of the isochoric part.
//!
//! With b = F Fᵀ, b̄ = J^(−2/3) b, Ī1 = tr b̄, Ī2 = (Ī1² − tr b̄²)/2 (Simo & Hughes 1998
//! \[simo1998\], §9.3; Holzapfel 2000 \[holzapfel2000\], §6.6):
//!
//!   τ̄ = 2 (w1 + Ī1 w2) b̄ − 2 w2 b̄²,   τ = dev τ̄
//!   c̄ = 4 [(w2 + w11 + 2 Ī1 w12 + Ī1² w22) b̄⊗b̄ − (w12 + Ī1 w22)(b̄⊗b̄² + b̄²⊗b̄) + w22 b̄²⊗b̄² − w2 1_b̄]
//!   c = P:c̄:P + ⅔ tr τ̄ (1 − ⅓ I⊗I) − ⅔ (τ⊗I + I⊗τ)
//!
//! Order of components: xx, yy, zz, xy, yz, zx.

pub use super::tensor::{AT, PAIRS, Spatial, Symmetric, Vector};

use super::{
    lanes::{MOST, Real},
    spatial_stretches::{Stretches, by_stretches},
};
use mckibben_core::rubber::{InvariantDerivatives, InvariantLaw};

/// A law in I1 and I2, evaluated at several places at once.
pub trait Invariants: Sync {
    /// w and its derivatives at every (I1, I2).
    fn invariants(&self, at: &[[f64; 2]], out: &mut [InvariantDerivatives]);
}

impl<L: InvariantLaw> Invariants for L {
    fn invariants(&self, at: &[[f64; 2]], out: &mut [InvariantDerivatives]) {
        for (out, [i1, i2]) in out.iter_mut().zip(at) {
            *out = self.invariant(*i1, *i2);
        }
    }
}

/// An isochoric law. Elements are compiled once for all laws: numbers go to and from the law alone.
#[derive(Clone, Copy)]
pub enum SpatialLaw<'a> {
    /// In the invariants: the short way.
    Invariants(&'a dyn Invariants),
    /// In the principal stretches.
    Stretches(&'a dyn Stretches),
}

impl SpatialLaw<'_> {
    /// τ at b and J, and c where `TANGENT`.
    #[inline(always)]
    pub fn spatial<R: Real, const TANGENT: bool>(&self, b: &Symmetric<R>, j: R) -> Spatial<R> {
        match self {
            Self::Invariants(law) => by_invariants::<R, TANGENT>(*law, b, j),
            Self::Stretches(law) => by_stretches(*law, b),
        }
    }
}

/// x^(−1/3), lane by lane. Rubber keeps its volume: near 1 a series and two Newton steps y(4 − x
/// y³)/3 are exact to rounding and take a tenth of the time of a cube root.
#[inline(always)]
pub fn inverse_cube_root<R: Real>(x: R) -> R {
    let mut out = x;
    let mut near = true;
    for l in 0..R::LANES {
        near &= (x.lane(l) - 1.0).abs() < 0.12;
    }
    if near {
        // Series and two steps of Newton's method, y (4 − x y³)/3: exact to rounding.
        let d = x - R::splat(1.0);
        let mut y = d.mul_add(R::splat(35.0 / 243.0), R::splat(-14.0 / 81.0));
        y = y.mul_add(d, R::splat(2.0 / 9.0));
        y = y.mul_add(d, R::splat(-1.0 / 3.0));
        y = y.mul_add(d, R::splat(1.0));
        for _ in 0..2 {
            y = y * ((R::splat(4.0) - x * y * y * y) * R::splat(1.0 / 3.0));
        }
        return y;
    }
    for l in 0..R::LANES {
        out.set_lane(l, 1.0 / x.lane(l).cbrt());
    }
    out
}

#[inline(always)]
fn by_invariants<R: Real, const TANGENT: bool>(
    law: &dyn Invariants,
    b: &Symmetric<R>,
    j: R,
) -> Spatial<R> {
    let s = R::splat;
    let root = inverse_cube_root(j);
    let scale = root * root;
    let mut x = *b;
    for v in &mut x {
        *v = *v * scale;
    }
    let mut y = x;
    for (k, &(i, j)) in PAIRS.iter().enumerate() {
        y[k] = x[AT[i][0]] * x[AT[0][j]] + x[AT[i][1]] * x[AT[1][j]] + x[AT[i][2]] * x[AT[2][j]];
    }
    let i1 = x[0] + x[1] + x[2];
    let i2 = s(0.5) * (i1 * i1 - (y[0] + y[1] + y[2]));
    let mut derivatives = [s(0.0); 6];
    let mut at = [[0.0; 2]; MOST];
    let mut values = [InvariantDerivatives::default(); MOST];
    for l in 0..R::LANES {
        at[l] = [i1.lane(l), i2.lane(l)];
    }
    law.invariants(&at[..R::LANES], &mut values[..R::LANES]);
    for (l, d) in values[..R::LANES].iter().enumerate() {
        for (to, from) in derivatives
            .iter_mut()
            .zip([d.w, d.w1, d.w2, d.w11, d.w12, d.w22])
        {
            to.set_lane(l, from);
        }
    }
    let [w, w1, w2, w11, w12, w22] = derivatives;
    let a1 = s(2.0) * (w1 + i1 * w2);
    let a2 = s(-2.0) * w2;
    let mut out = Spatial::zero();
    out.w = w;
    for k in 0..6 {
        out.tau[k] = a1 * x[k] + a2 * y[k];
    }
    let mean = (out.tau[0] + out.tau[1] + out.tau[2]) * s(1.0 / 3.0);
    for k in 0..3 {
        out.tau[k] = out.tau[k] - mean;
    }
    if TANGENT {
        let k11 = s(4.0) * (w2 + w11 + s(2.0) * i1 * w12 + i1 * i1 * w22);
        let k12 = s(-4.0) * (w12 + i1 * w22);
        let k22 = s(4.0) * w22;
        let half = s(-2.0) * w2;
        for a in 0..6 {
            let (i, j) = PAIRS[a];
            let p = k11 * x[a] + k12 * y[a];
            let q = k12 * x[a] + k22 * y[a];
            for c in a..6 {
                let (k, l) = PAIRS[c];
                let dyads = x[AT[i][k]] * x[AT[j][l]] + x[AT[i][l]] * x[AT[j][k]];
                out.c[a][c] = p * x[c] + q * y[c] + half * dyads;
            }
        }
        deviate(&mut out, mean);
    }
    out
}

/// c̄ (upper half) becomes c (both halves); `mean` is tr τ̄/3.
#[inline(always)]
fn deviate<R: Real>(out: &mut Spatial<R>, mean: R) {
    let s = R::splat;
    let c = &mut out.c;
    let third = s(1.0 / 3.0);
    let mut row = [s(0.0); 6];
    for k in 0..6 {
        row[k] = (c[0][k] + c[k.min(1)][k.max(1)] + c[k.min(2)][k.max(2)]) * third;
    }
    let all = (row[0] + row[1] + row[2]) * third;
    let two = s(2.0) * mean;
    for a in 0..6 {
        row[a] = row[a] + s(2.0 / 3.0) * out.tau[a];
    }
    let both = all - two * third;
    for a in 0..3 {
        for b in a..3 {
            c[a][b] = c[a][b] - row[a] - row[b] + both;
        }
        for b in 3..6 {
            c[a][b] = c[a][b] - row[b];
        }
        c[a][a] = c[a][a] + two;
        c[a + 3][a + 3] = c[a + 3][a + 3] + mean;
    }
    for a in 1..6 {
        for b in 0..a {
            c[a][b] = c[b][a];
        }
    }
}
