//! Numbers with their derivatives in the axial stretch λ of the middle and the pressure P.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value with (∂/∂λ, ∂/∂P).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Dual {
    pub v: f64,
    pub by: [f64; 2],
}

impl Dual {
    pub fn new(v: f64, by: [f64; 2]) -> Self {
        Self { v, by }
    }

    pub fn constant(v: f64) -> Self {
        Self { v, by: [0.0; 2] }
    }

    /// f(self) from its value and slope.
    pub fn chain(self, v: f64, slope: f64) -> Self {
        Self { v, by: self.by.map(|d| slope * d) }
    }

    pub fn sqrt(self) -> Self {
        let root = self.v.max(0.0).sqrt();
        self.chain(root, if root > 0.0 { 0.5 / root } else { 0.0 })
    }

    pub fn tanh(self) -> Self {
        let t = self.v.tanh();
        self.chain(t, 1.0 - t * t)
    }

    pub fn squared(self) -> Self {
        self.chain(self.v * self.v, 2.0 * self.v)
    }

    /// ½(x + √(x² + c²)): x where it is well above c, c²/4|x| where it is well below −c, and smooth.
    pub fn positive(self, c: Self) -> Self {
        let (x, c2) = (self.v, c.v * c.v);
        let root = (x * x + c2).sqrt();
        if root <= 0.0 {
            return Self::default();
        }
        let v = if x >= 0.0 { 0.5 * (x + root) } else { 0.5 * c2 / (root - x) };
        let (by_x, by_c) = (v / root, 0.5 * c.v / root);
        Self { v, by: [0, 1].map(|i| by_x * self.by[i] + by_c * c.by[i]) }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { v: self.v + o.v, by: [self.by[0] + o.by[0], self.by[1] + o.by[1]] }
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self { v: self.v - o.v, by: [self.by[0] - o.by[0], self.by[1] - o.by[1]] }
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.v, -1.0)
    }
}

#[allow(clippy::suspicious_arithmetic_impl)] // the product rule
impl Mul for Dual {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let by = [0, 1].map(|i| self.by[i] * o.v + self.v * o.by[i]);
        Self { v: self.v * o.v, by }
    }
}

impl Mul<f64> for Dual {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.chain(self.v * factor, factor)
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let i = 1.0 / o.v;
        let v = self.v * i;
        Self { v, by: [0, 1].map(|k| (self.by[k] - v * o.by[k]) * i) }
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
            let (x, y) = (Dual::new(l, by(1.0, 0.0)), Dual::new(p, by(0.0, 1.0)));
            let h = (x * y - y.squared() * 0.3).sqrt();
            (x - y) * (x + y * 2.0) / h + (x - y * 3.0).positive(y * 0.5) - x
        };
        let (l, p, d) = (0.9, 0.4, 1e-6);
        let got = f(l, p, true);
        let by_l = (f(l + d, p, false).v - f(l - d, p, false).v) / (2.0 * d);
        let by_p = (f(l, p + d, false).v - f(l, p - d, false).v) / (2.0 * d);
        assert!((got.by[0] - by_l).abs() < 1e-8 && (got.by[1] - by_p).abs() < 1e-8, "{got:?} {by_l} {by_p}");
        // Far below zero nothing cancels.
        let far = Dual::constant(-1e9).positive(Dual::constant(1.0)).v;
        assert!((far * 4e9 - 1.0).abs() < 1e-9);
    }
}
