//! Laws written in the invariants I1 = λ1²+λ2²+λ3², I2 = λ1²λ2²+λ2²λ3²+λ3²λ1².

/// w(I1, I2) and its derivatives, in MPa.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct InvariantDerivatives {
    /// w
    pub w: f64,
    /// ∂w/∂I1
    pub w1: f64,
    /// ∂w/∂I2
    pub w2: f64,
    /// ∂²w/∂I1²
    pub w11: f64,
    /// ∂²w/∂I1∂I2
    pub w12: f64,
    /// ∂²w/∂I2²
    pub w22: f64,
}

impl InvariantDerivatives {
    /// What a law gives at and beyond the stretch at which its chains lock.
    pub const LOCKED: Self = Self {
        w: f64::INFINITY,
        w1: f64::NAN,
        w2: 0.0,
        w11: f64::NAN,
        w12: 0.0,
        w22: 0.0,
    };
}

/// A law that is a function of I1 and I2 alone; [`RubberLaw`](super::RubberLaw) follows by the
/// chain rule.
pub trait InvariantLaw: Sync {
    /// w and its derivatives at (I1, I2).
    fn invariant(&self, i1: f64, i2: f64) -> InvariantDerivatives;
}
