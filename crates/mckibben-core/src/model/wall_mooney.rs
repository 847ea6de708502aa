//! The energy of a Mooney–Rivlin wall in closed form.
//!
//! With A = Ro² − Ri², x = ro² and K = x − Ro²/λ, the wall of [`super::Wall`] has r² = R²/λ + K,
//! and the integrals of I1 and I2 over R² are elementary:
//!
//!   W/π = C10 [(λ² − 3)A + 2A/λ] + C01 [(1/λ² − 3)A + 2λA] + (C10 + C01 λ²) Q
//!   Q = K [ln(Ro²/Ri²) − ln(ro²/ri²)],   ri² = x − A/λ
//!
//! Derived here; Q carries all of the bulge.

use super::wall_energy::SquareEnergy;
use std::f64::consts::PI;

/// A wall of Mooney–Rivlin rubber.
pub struct Mooney {
    pub c10_mpa: f64,
    pub c01_mpa: f64,
    /// Ro² in mm²
    pub ro2: f64,
    /// A in mm²
    pub section: f64,
    /// ln(Ro²/Ri²)
    pub span: f64,
}

impl Mooney {
    /// W and its derivatives at λ and x = ro².
    #[inline(always)]
    pub fn of_square(&self, l: f64, x: f64) -> SquareEnergy {
        let c10 = self.c10_mpa;
        let c01 = self.c01_mpa;
        let a = self.section;
        // g = λ ri²; M = ln(ro²/ri²) and its derivatives in (λ, x)
        let g = l * x - a;
        let all = 1.0 / (l * x * g);
        let i = x * g * all;
        let j = l * g * all;
        let s = l * x * all;
        let i2 = i * i;
        let i3 = i * i * i;
        let m = -(g * i * j).ln();
        let ml = -a * i * s;
        let mx = -a * s * j;
        let twice = a * (2.0 * l * x - a) * s * s;
        let mll = twice * i2;
        let mxx = twice * j * j;
        let mlx = a * s * s;
        let k = x - self.ro2 * i;
        let kl = self.ro2 * i2;
        let kll = -2.0 * self.ro2 * i3;
        let d = self.span - m;
        let q = k * d;
        let ql = kl * d - k * ml;
        let qx = d - k * mx;
        let qll = kll * d - 2.0 * kl * ml - k * mll;
        let qlx = -ml - kl * mx - k * mlx;
        let qxx = -2.0 * mx - k * mxx;
        let c = c10 + c01 * l * l;
        SquareEnergy {
            w: PI * (a * (c10 * (l * l - 3.0 + 2.0 * i) + c01 * (i2 - 3.0 + 2.0 * l)) + c * q),
            l: PI * (2.0 * a * (c10 * (l - i2) + c01 * (1.0 - i3)) + c * ql + 2.0 * c01 * l * q),
            ll: PI
                * (a * (c10 * (2.0 + 4.0 * i3) + 6.0 * c01 * i2 * i2)
                    + c * qll
                    + 4.0 * c01 * l * ql
                    + 2.0 * c01 * q),
            x: PI * c * qx,
            lx: PI * (c * qlx + 2.0 * c01 * l * qx),
            xx: PI * c * qxx,
        }
    }
}
