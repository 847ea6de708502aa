//! Rubber in an axisymmetric state of deformation.
//!
//! With F_rR = a, F_rZ = b, F_zR = c, F_zZ = d and F_θθ = t the deformation has three invariants,
//!
//!   s = a² + b² + c² + d²,   D = ad − bc,   t;     J = D t,  I1 = s + t²,  I2 = D² + t² s
//!
//! so that any isotropic law is a function φ(s, D, t) and
//!
//!   ∂φ/∂f = 2φ_s f + φ_D g,     f = (a, b, c, d),  g = ∂D/∂f = (d, −c, −b, a)
//!   ∂²φ/∂f∂f = 2φ_s 1 + φ_D H + 4φ_ss f⊗f + 2φ_sD (f⊗g + g⊗f) + φ_DD g⊗g,   H = ∂g/∂f.
//!
//! Laws act on the isochoric part: Ī1 = J^(−2/3) I1, Ī2 = J^(−4/3) I2 (Flory 1961 \[flory1961\]).
//! The pressure-like multiplier p adds p (J − 1).

pub use super::plane_law::{AnyPlaneLaw, Gradient, PlaneLaw, Stress};

use super::spatial::inverse_cube_root;
use mckibben_core::rubber::InvariantLaw;

/// A law in I1 and I2.
#[derive(Debug)]
pub struct ByInvariants<'a, L>(pub &'a L);

impl<L: InvariantLaw> PlaneLaw for ByInvariants<'_, L> {
    #[inline(always)]
    fn stress<const TANGENT: bool>(&self, f: &Gradient, p: f64) -> Stress {
        let Gradient { a, b, c, d, t } = *f;
        let s = a * a + b * b + c * c + d * d;
        let area = a * d - b * c;
        let root = inverse_cube_root(area * t);
        let j = root * root;
        let j2 = j * j;
        let rd = 1.0 / area;
        let rt = 1.0 / t;
        let x = j * (s + t * t);
        let y = j2 * (area * area + t * t * s);
        let e = self.0.invariant(x, y);
        let third = 1.0 / 3.0;
        let x_s = j;
        let x_d = -2.0 * third * x * rd;
        let x_t = 2.0 * j * t - 2.0 * third * x * rt;
        let y_s = j2 * t * t;
        let y_d = 2.0 * j2 * area - 4.0 * third * y * rd;
        let y_t = 2.0 * j2 * t * s - 4.0 * third * y * rt;
        // φ_s, φ_D, φ_t
        let two = 2.0 * (e.w1 * x_s + e.w2 * y_s);
        let phi_d = e.w1 * x_d + e.w2 * y_d + p * t;
        let phi_t = e.w1 * x_t + e.w2 * y_t + p * area;
        let mut out = Stress {
            w: e.w,
            r: [two * a + phi_d * d, two * b - phi_d * c, phi_t],
            z: [two * c - phi_d * b, two * d + phi_d * a],
            ..Stress::default()
        };
        if TANGENT {
            let x_sd = -2.0 * third * j * rd;
            let x_st = -2.0 * third * j * rt;
            let x_dd = 10.0 / 9.0 * x * rd * rd;
            let x_dt = -2.0 * third * x_t * rd;
            let x_tt = 2.0 * third * ((x * rt - x_t) * rt + j);
            let y_sd = -4.0 * third * y_s * rd;
            let y_st = 2.0 * third * y_s * rt;
            let y_dd = 4.0 * third * (y * rd - y_d) * rd - 2.0 * third * j2;
            let y_dt = -4.0 * third * y_t * rd - 8.0 * third * j2 * area * rt;
            let y_tt = 4.0 * third * (y * rt - y_t) * rt - 2.0 * third * j2 * s;
            let second = |xi: f64, yi: f64, xj: f64, yj: f64| {
                e.w11 * xi * xj + e.w12 * (xi * yj + yi * xj) + e.w22 * yi * yj
            };
            let ss = second(x_s, y_s, x_s, y_s);
            let sd = second(x_s, y_s, x_d, y_d) + e.w1 * x_sd + e.w2 * y_sd;
            let st = second(x_s, y_s, x_t, y_t) + e.w1 * x_st + e.w2 * y_st;
            let dd = second(x_d, y_d, x_d, y_d) + e.w1 * x_dd + e.w2 * y_dd;
            let dt = second(x_d, y_d, x_t, y_t) + e.w1 * x_dt + e.w2 * y_dt + p;
            let tt = second(x_t, y_t, x_t, y_t) + e.w1 * x_tt + e.w2 * y_tt;
            let h1 = 4.0 * ss;
            let h2 = 2.0 * sd;
            let h3 = dd;
            // Pairs (f, g) of a, b, c, d.
            let fa = (a, d);
            let fb = (b, -c);
            let fc = (c, -b);
            let fd = (d, a);
            let outer = |i: (f64, f64), j: (f64, f64)| {
                i.0 * (h1 * j.0 + h2 * j.1) + i.1 * (h2 * j.0 + h3 * j.1)
            };
            let with_t = |i: (f64, f64)| 2.0 * st * i.0 + dt * i.1;
            let ab = outer(fa, fb);
            let at = with_t(fa);
            let bt = with_t(fb);
            out.rr = [
                [two + outer(fa, fa), ab, at],
                [ab, two + outer(fb, fb), bt],
                [at, bt, tt],
            ];
            out.rz = [
                [outer(fa, fc), outer(fa, fd) + phi_d],
                [outer(fb, fc) - phi_d, outer(fb, fd)],
                [with_t(fc), with_t(fd)],
            ];
            let cd = outer(fc, fd);
            out.zz = [[two + outer(fc, fc), cd], [cd, two + outer(fd, fd)]];
        }
        out
    }
}
