//! A straight strand between two nodes: T = E A (λ − 1), λ = l/L0 (engineering strain).
//!
//!   Π = E A L0 (λ − 1)²/2,   ∂Π/∂x1 = T n,   ∂²Π/∂x1∂x1 = (E A/L0) n⊗n + (T/l)(1 − n⊗n),   n = d/l, d = x1 − x0
//!
//! The tension in the second part may be one that is carried along as a separate variable: with
//! stiff strands Newton's method then does not slow down (Magisano, Leonetti & Garcea 2017
//! \[magisano2017\]).

use super::tensor::{PAIRS, Vector};

/// A strand at rest.
#[derive(Debug, Clone, Copy)]
pub struct Truss {
    /// L0 in mm.
    pub length_mm: f64,
    /// E·A in N.
    pub stiffness_n: f64,
    /// Whether it carries compression.
    pub compression: bool,
}

/// What a strand does to its second node; the first has the opposite.
#[derive(Debug, Default)]
pub struct Pull {
    /// λ − 1
    pub strain: f64,
    /// n
    pub direction: Vector,
    /// T in N.
    pub tension: f64,
    /// Whether it carries anything.
    pub carries: bool,
    /// xx, yy, zz, xy, yz, zx of the tangent in N/mm.
    pub tangent: [f64; 6],
}

impl Truss {
    /// Force and tangent for d in mm. `offset` in N is added to the tension; `tension` in N is the
    /// one in the geometric part of the tangent.
    pub fn pull(&self, d: Vector, offset: f64, tension: f64) -> Pull {
        let l = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        let strain = l / self.length_mm - 1.0;
        let n = d.map(|x| x / l);
        let force = offset + self.stiffness_n * strain;
        if force <= 0.0 && !self.compression {
            return Pull {
                strain,
                direction: n,
                ..Pull::default()
            };
        }
        let across = tension / l;
        let along = self.stiffness_n / self.length_mm - across;
        Pull {
            strain,
            direction: n,
            tension: force,
            carries: true,
            tangent: PAIRS.map(|(i, j)| along * n[i] * n[j] + if i == j { across } else { 0.0 }),
        }
    }
}
