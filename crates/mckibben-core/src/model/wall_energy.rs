//! The energy of a wall at one state, with its derivatives.

use std::ops::Add;

/// W and its derivatives in λ and ro at one state; W in N (N·mm per mm of length at rest).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WallEnergy {
    /// W in N
    pub w: f64,
    /// ∂W/∂λ in N
    pub l: f64,
    /// ∂W/∂ro in N/mm
    pub r: f64,
    /// ∂²W/∂λ² in N
    pub ll: f64,
    /// ∂²W/∂λ∂ro in N/mm
    pub lr: f64,
    /// ∂²W/∂ro² in N/mm²
    pub rr: f64,
}

impl Add for WallEnergy {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            w: self.w + other.w,
            l: self.l + other.l,
            r: self.r + other.r,
            ll: self.ll + other.ll,
            lr: self.lr + other.lr,
            rr: self.rr + other.rr,
        }
    }
}

/// W and its derivatives in λ and x = ro² at one state.
#[derive(Default)]
pub struct SquareEnergy {
    pub w: f64,
    pub l: f64,
    pub x: f64,
    pub ll: f64,
    pub lx: f64,
    pub xx: f64,
}

impl SquareEnergy {
    /// Its derivatives by ro itself, in mm.
    pub fn by_radius(self, r: f64) -> WallEnergy {
        WallEnergy {
            w: self.w,
            l: self.l,
            ll: self.ll,
            r: 2.0 * r * self.x,
            lr: 2.0 * r * self.lx,
            rr: 4.0 * r * r * self.xx + 2.0 * self.x,
        }
    }
}
