//! Numbers with their first and second derivatives in seven variables, and Newton's method for the stationary point in the first of them.

#![allow(clippy::needless_range_loop)]

use std::array::from_fn;
use std::ops::{Add, Mul, Sub};

pub(super) const N: usize = 7;
/// Steps after which Newton's method gives up.
const STEPS: usize = 60;
/// Relative step with which it ends; what is left is of the order of its square.
const SMALL: f64 = 1e-9;
/// Largest relative change of a variable in one step.
const LARGEST: f64 = 0.1;

/// A value with gradient and Hessian.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jet {
    pub v: f64,
    pub g: [f64; N],
    pub h: [[f64; N]; N],
}

impl Jet {
    pub fn constant(v: f64) -> Self {
        Self { v, g: [0.0; N], h: [[0.0; N]; N] }
    }

    pub fn variable(v: f64, index: usize) -> Self {
        let mut jet = Self::constant(v);
        jet.g[index] = 1.0;
        jet
    }

    /// f(args) from its value, gradient and Hessian.
    pub fn of<const K: usize>(args: [&Self; K], v: f64, by: [f64; K], second: [[f64; K]; K]) -> Self {
        let mut jet = Self::constant(v);
        for (a, arg) in args.iter().enumerate() {
            let weighted: [f64; N] =
                from_fn(|j| args.iter().enumerate().map(|(b, other)| second[a][b] * other.g[j]).sum());
            for i in 0..N {
                jet.g[i] += by[a] * arg.g[i];
                for j in 0..N {
                    jet.h[i][j] += by[a] * arg.h[i][j] + arg.g[i] * weighted[j];
                }
            }
        }
        jet
    }

    pub fn recip(self) -> Self {
        let i = 1.0 / self.v;
        Self::of([&self], i, [-i * i], [[2.0 * i * i * i]])
    }

    pub fn sqrt(self) -> Self {
        let root = self.v.sqrt();
        Self::of([&self], root, [0.5 / root], [[-0.25 / (root * self.v)]])
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            v: self.v + o.v,
            g: from_fn(|i| self.g[i] + o.g[i]),
            h: from_fn(|i| from_fn(|j| self.h[i][j] + o.h[i][j])),
        }
    }
}

impl Mul<f64> for Jet {
    type Output = Self;
    fn mul(self, c: f64) -> Self {
        Self { v: self.v * c, g: self.g.map(|x| c * x), h: self.h.map(|row| row.map(|x| c * x)) }
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + o * -1.0
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::of([&self, &o], self.v * o.v, [o.v, self.v], [[0.0, 1.0], [1.0, 0.0]])
    }
}

/// Solution of a small system by elimination with pivots, rows scaled to their largest entry.
fn solve<const I: usize>(mut a: [[f64; I]; I], mut b: [f64; I]) -> Option<[f64; I]> {
    for (row, right) in a.iter_mut().zip(&mut b) {
        let largest = row.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        row.iter_mut().for_each(|x| *x /= largest);
        *right /= largest;
    }
    for k in 0..I {
        let pivot = (k..I).max_by(|&p, &q| a[p][k].abs().total_cmp(&a[q][k].abs()))?;
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..I {
            let factor = a[i][k] / a[k][k];
            for j in k..I {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..I).rev() {
        let known: f64 = (k + 1..I).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b.iter().all(|x| x.is_finite()).then_some(b)
}

/// The potential where it is stationary in its first I variables.
pub(super) struct Stationary<const I: usize> {
    pub at: [f64; I],
    jet: Jet,
}

impl<const I: usize> Stationary<I> {
    /// By Newton's method; `scale` bounds its steps. `None` where it does not converge.
    pub fn find<E>(
        mut at: [f64; I],
        scale: [f64; I],
        potential: impl Fn(&[f64; I]) -> Result<Jet, E>,
    ) -> Result<Option<Self>, E> {
        let mut last = false;
        for _ in 0..STEPS {
            let jet = potential(&at)?;
            if last {
                return Ok(jet.v.is_finite().then_some(Self { at, jet }));
            }
            let Some(step) = solve::<I>(from_fn(|i| from_fn(|j| jet.h[i][j])), from_fn(|i| -jet.g[i])) else {
                return Ok(None);
            };
            let size = step.iter().zip(scale).map(|(s, scale)| (s / scale).abs()).fold(0.0, f64::max);
            let share = (LARGEST / size).min(1.0);
            at = from_fn(|i| at[i] + share * step[i]);
            last = size < SMALL;
        }
        Ok(None)
    }

    /// The stationary value.
    pub fn value(&self) -> f64 {
        self.jet.v
    }

    /// Derivative of the stationary value by one of the other variables.
    pub fn by(&self, variable: usize) -> f64 {
        self.jet.g[variable]
    }

    /// Its second derivative by two of the other variables.
    pub fn second(&self, a: usize, b: usize) -> Option<f64> {
        let moved = solve::<I>(from_fn(|i| from_fn(|j| self.jet.h[i][j])), from_fn(|i| -self.jet.h[i][b]))?;
        let through: f64 = (0..I).map(|i| self.jet.h[a][i] * moved[i]).sum();
        Some(self.jet.h[a][b] + through)
    }
}
