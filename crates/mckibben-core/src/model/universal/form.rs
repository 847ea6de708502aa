//! The deficit δ of an end: the membrane's with a fitted correction.
//!
//!   δ = δ_membrane + Ro (λs0 − λ) S/√t · Σ c · Sᵃ Aᵇ Nᶜ Mᵈ Eᵉ
//!
//! S = s/Ro, A = 4 sin²θ0. At the terminal the membrane has the stretch λs0, the slope N = sinφ0
//! and the tension T0; t = T0/(2π Ro s μ), M = 1/(1 + t), E = x/√(1 + x²) with x = 10 (λf − 1) of
//! the middle's strands. Ro S/√t = √(s² · μ s · 2π Ro/T0) is the length over which a wall that
//! resists bending turns into the slope of a membrane under tension; over that length the muscle
//! has the stretch λs0 of the terminal in place of λ. μ is the shear modulus of the rubber at rest.

use super::{
    dual::Dual,
    end::{End, EndZone},
};
use crate::{formula::UniversalTerm, model::thick_wall::State};
use std::array::from_fn;

/// A deficit with a muscle's S and A put in: a polynomial in the other three variables.
#[derive(Debug, Clone)]
pub struct Bound {
    /// Of 1, x, y, z, x², xy, xz, y², yz, z².
    sum: [f64; 10],
    /// S
    wall: f64,
    ro: f64,
}

/// The products of [`Bound`], of second degree and less, in its order.
const SECOND: [[i32; 3]; 10] = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [2, 0, 0],
    [1, 1, 0],
    [1, 0, 1],
    [0, 2, 0],
    [0, 1, 1],
    [0, 0, 2],
];

/// The factor before the sum, and the three variables.
struct Inner<const N: usize> {
    factor: Dual<N>,
    x: [Dual<N>; 3],
}

impl Bound {
    pub fn new(formula: &[UniversalTerm], ro: f64, wall: f64, angle: f64) -> Self {
        let mut sum = [0.0; 10];
        for t in formula {
            let [a, b, rest @ ..] = t.powers.map(i32::from);
            let place = SECOND.iter().position(|powers| *powers == rest);
            if let Some(i) = place {
                sum[i] += t.value * wall.powi(a) * angle.powi(b);
            }
        }
        Self { sum, wall, ro }
    }

    /// δ in mm, and the end, from guesses of λs at its sections.
    pub fn deficit_at(
        &self,
        p: f64,
        l: f64,
        state: &State,
        zone: &EndZone,
        near: Option<[f64; 2]>,
    ) -> Option<(Dual, End)> {
        let end = zone.end_at(p, l, state, near)?;
        let delta = self.with_wall(&end, Dual::new(state.strain, state.strain_by));
        delta.is_finite().then_some((delta, end))
    }

    /// δ of a membrane with what the wall adds, in mm, at a strain of the middle's strands.
    #[inline(always)]
    pub fn with_wall<const N: usize>(&self, end: &End<N>, strain: Dual<N>) -> Dual<N> {
        let inner = self.of_membrane(end, strain);
        end.deficit + inner.factor * self.sum(inner.x)
    }

    /// What δ is without its terms, and what each of a list of products adds with coefficient 1;
    /// values only, in mm.
    pub fn columns(
        &self,
        (p, l): (f64, f64),
        (state, zone): (&State, &EndZone),
        angle: f64,
        products: &[[u8; 5]],
    ) -> Option<(f64, Vec<f64>)> {
        let end = zone.end_at(p, l, state, None)?;
        let inner = self.of_membrane(&end, Dual::new(state.strain, state.strain_by));
        let x = [self.wall, angle, inner.x[0].v, inner.x[1].v, inner.x[2].v];
        let one = |n: &[u8; 5]| {
            let product: f64 = n
                .iter()
                .zip(x)
                .map(|(&n, v)| v.powi(i32::from(n)))
                .product();
            inner.factor.v * product
        };
        Some((end.deficit.v, products.iter().map(one).collect()))
    }

    #[inline(always)]
    fn of_membrane<const N: usize>(&self, end: &End<N>, strain: Dual<N>) -> Inner<N> {
        let one = Dual::constant(1.0);
        let m = one / (one + end.tension);
        let x = strain * 10.0;
        let e = x / (one + x.squared()).sqrt();
        Inner {
            factor: end.excess * (self.ro * self.wall) / end.tension.sqrt(),
            x: [end.slope, m, e],
        }
    }

    #[inline(always)]
    fn sum<const N: usize>(&self, x: [Dual<N>; 3]) -> Dual<N> {
        let [a, b, c] = x;
        let (v, by) = second(&self.sum, [a.v, b.v, c.v]);
        Dual::new(
            v,
            from_fn(|i| by[0] * a.by[i] + by[1] * b.by[i] + by[2] * c.by[i]),
        )
    }
}

/// The sum and its slopes.
#[inline(always)]
fn second(s: &[f64; 10], [x, y, z]: [f64; 3]) -> (f64, [f64; 3]) {
    let by_x = s[1] + 2.0 * s[4] * x + s[5] * y + s[6] * z;
    let by_y = s[2] + s[5] * x + 2.0 * s[7] * y + s[8] * z;
    let by_z = s[3] + s[6] * x + s[8] * y + 2.0 * s[9] * z;
    // Euler: the slopes count the linear terms once and the squares twice.
    let v = s[0] + 0.5 * ((by_x + s[1]) * x + (by_y + s[2]) * y + (by_z + s[3]) * z);
    (v, [by_x, by_y, by_z])
}
