//! Energy of wall and braid at an axial stretch λ and x = r², the square of the outer radius.
//!
//! λf² = cos²θ0 λ² + sin²θ0 x/Ro² is linear in x, and ∂Π/∂x = ∂(W + B)/∂x − π λ P does not have P
//! in its slope.

use super::ThickWall;
use std::f64::consts::PI;

/// Energy of wall and braid and its derivatives in (λ, x); strands that do not stretch carry none.
pub struct Sheet {
    pub w: f64,
    pub l: f64,
    pub x: f64,
    pub ll: f64,
    pub lx: f64,
    pub xx: f64,
    /// λf of the strands
    pub strand: f64,
}

impl ThickWall {
    /// The energy at (λ, r²); the caller sees that λ r² is above Ro² − Ri².
    #[inline(always)]
    pub(in crate::model) fn sheet(&self, l: f64, x: f64) -> Sheet {
        let w = self.wall.of_square(&self.law, l, x);
        let a = self.cos2;
        let b = self.sin2 / (self.ro * self.ro);
        let square = a * l * l + b * x;
        let strand = square.sqrt();
        let strain = strand - 1.0;
        let c = match self.k {
            Some(k) if strain > 0.0 || self.compression => 4.0 * PI * self.ro * k,
            _ => 0.0,
        };
        // B = ½c (λf − 1)² by q = λf²
        let i = 1.0 / square;
        let q = 0.5 * c * strain * strand * i;
        let qq = 0.25 * c * strand * i * i;
        let q_l = 2.0 * a * l;
        Sheet {
            w: w.w + 0.5 * c * strain * strain,
            l: w.l + q * q_l,
            x: w.x + q * b,
            ll: w.ll + 2.0 * a * q + qq * q_l * q_l,
            lx: w.lx + qq * q_l * b,
            xx: w.xx + qq * b * b,
            strand,
        }
    }

    /// Ro² − Ri² in mm².
    #[inline]
    pub(in crate::model) fn section(&self) -> f64 {
        self.wall.section()
    }

    /// x at which the strands have a stretch whose square is q.
    #[inline]
    pub(in crate::model) fn square_at(&self, q: f64, l: f64) -> f64 {
        (q - self.cos2 * l * l) * (self.ro * self.ro) / self.sin2
    }
}
