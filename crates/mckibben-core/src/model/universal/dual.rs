//! Numbers with their derivatives: in the axial stretch λ of the middle, or in λ and the pressure
//! P.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value with ∂/∂λ, or with (∂/∂λ, ∂/∂P).
#[derive(Debug, Clone, Copy)]
pub struct Dual<const N: usize = 2> {
    pub v: f64,
    pub by: [f64; N],
}

/// Above this tanh is 1 to the last digit.
const TANH_IS_ONE: f64 = 20.0;

/// One number for each derivative: a loop is inlined wherever it is used, `std::array::from_fn` and
/// `map` are not.
#[inline(always)]
fn array_of<const N: usize>(f: impl Fn(usize) -> f64) -> [f64; N] {
    let mut out = [0.0; N];
    for (k, place) in out.iter_mut().enumerate() {
        *place = f(k);
    }
    out
}

impl<const N: usize> Dual<N> {
    #[inline(always)]
    pub fn new(v: f64, by: [f64; N]) -> Self {
        Self { v, by }
    }

    #[inline(always)]
    pub fn constant(v: f64) -> Self {
        Self { v, by: [0.0; N] }
    }

    /// f(self) from its value and slope.
    #[inline(always)]
    pub fn chain(self, v: f64, slope: f64) -> Self {
        Self {
            v,
            by: array_of(|k| slope * self.by[k]),
        }
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let root = self.v.max(0.0).sqrt();
        self.chain(root, if root > 0.0 { 0.5 / root } else { 0.0 })
    }

    #[inline(always)]
    pub fn tanh(self) -> Self {
        if self.v > TANH_IS_ONE {
            return Self::constant(1.0);
        }
        // 1 − 2/(e²ˣ + 1) does not cancel there, and takes half the time.
        let t = if self.v > 1.0 {
            1.0 - 2.0 / ((2.0 * self.v).exp() + 1.0)
        } else {
            self.v.tanh()
        };
        self.chain(t, 1.0 - t * t)
    }

    #[inline(always)]
    pub fn squared(self) -> Self {
        self.chain(self.v * self.v, 2.0 * self.v)
    }

    /// Value and derivatives are numbers.
    #[inline(always)]
    pub fn is_finite(self) -> bool {
        self.v.is_finite() && self.by.iter().all(|d| d.is_finite())
    }

    /// ½(x + √(x² + c²)): x where it is well above c, c²/4|x| where it is well below −c, and
    /// smooth.
    #[inline(always)]
    pub fn positive(self, c: Self) -> Self {
        let x = self.v;
        let c2 = c.v * c.v;
        let root = (x * x + c2).sqrt();
        if root <= 0.0 {
            return Self::constant(0.0);
        }
        let i = 1.0 / root;
        let v = if x >= 0.0 {
            0.5 * (x + root)
        } else {
            0.5 * c2 / (root - x)
        };
        let by_x = v * i;
        let by_c = 0.5 * c.v * i;
        Self {
            v,
            by: array_of(|k| by_x * self.by[k] + by_c * c.by[k]),
        }
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self {
            v: self.v + o.v,
            by: array_of(|k| self.by[k] + o.by[k]),
        }
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self {
            v: self.v - o.v,
            by: array_of(|k| self.by[k] - o.by[k]),
        }
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.chain(-self.v, -1.0)
    }
}

#[allow(clippy::suspicious_arithmetic_impl)] // the product rule
impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        Self {
            v: self.v * o.v,
            by: array_of(|k| self.by[k] * o.v + self.v * o.by[k]),
        }
    }
}

impl<const N: usize> Mul<f64> for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self.chain(self.v * factor, factor)
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, o: Self) -> Self {
        let i = 1.0 / o.v;
        let v = self.v * i;
        Self {
            v,
            by: array_of(|k| (self.by[k] - v * o.by[k]) * i),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (f·g/√h) and the smooth positive part by finite differences.
    #[test]
    fn derivatives_are_those_of_finite_differences() {
        let f = |l: f64, p: f64, dual: bool| {
            let by = |a, b| if dual { [a, b] } else { [0.0; 2] };
            let (x, y) = (Dual::<2>::new(l, by(1.0, 0.0)), Dual::new(p, by(0.0, 1.0)));
            let h = (x * y - y.squared() * 0.3).sqrt();
            (x - y) * (x + y * 2.0) / h + (x - y * 3.0).positive(y * 0.5) - x
        };
        let (l, p, d) = (0.9, 0.4, 1e-6);
        let got = f(l, p, true);
        let by_l = (f(l + d, p, false).v - f(l - d, p, false).v) / (2.0 * d);
        let by_p = (f(l, p + d, false).v - f(l, p - d, false).v) / (2.0 * d);
        assert!(
            (got.by[0] - by_l).abs() < 1e-8 && (got.by[1] - by_p).abs() < 1e-8,
            "{got:?} {by_l} {by_p}"
        );
        // Far below zero nothing cancels.
        let far = Dual::<2>::constant(-1e9).positive(Dual::constant(1.0)).v;
        assert!((far * 4e9 - 1.0).abs() < 1e-9);
    }
}
