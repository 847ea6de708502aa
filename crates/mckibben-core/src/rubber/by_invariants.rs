//! From I1 and I2 to the principal stretches: the chain rule, once for all laws in the invariants.

use super::{Biaxial, InvariantLaw, LawVisitor, Principal, RubberLaw};

impl<T: InvariantLaw> RubberLaw for T {
    /// μ = 2(∂w/∂I1 + ∂w/∂I2) at rest.
    fn shear_modulus_mpa(&self) -> f64 {
        let d = self.invariant(3.0, 3.0);
        2.0 * (d.w1 + d.w2)
    }

    fn principal(&self, l: [f64; 3]) -> Principal {
        let q = l.map(|x| x * x);
        let f = self.invariant(q[0] + q[1] + q[2], q[0] * q[1] + q[1] * q[2] + q[2] * q[0]);
        let others = [q[1] + q[2], q[2] + q[0], q[0] + q[1]];
        // ∂I1/∂λi = 2λi, ∂I2/∂λi = 2λi(λj² + λk²)
        let a = l.map(|x| 2.0 * x);
        let b = [a[0] * others[0], a[1] * others[1], a[2] * others[2]];
        let mut dd = [[0.0; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                let curved = if i == j {
                    2.0 * f.w1 + 2.0 * others[i] * f.w2
                } else {
                    4.0 * l[i] * l[j] * f.w2
                };
                dd[i][j] = f.w11 * a[i] * a[j]
                    + f.w12 * (a[i] * b[j] + b[i] * a[j])
                    + f.w22 * b[i] * b[j]
                    + curved;
            }
        }
        Principal {
            w: f.w,
            d: [0, 1, 2].map(|i| f.w1 * a[i] + f.w2 * b[i]),
            dd,
        }
    }

    fn biaxial(&self, u: f64, v: f64) -> Biaxial {
        // I1 = u + v + 1/(uv), I2 = uv + 1/u + 1/v
        let ru = 1.0 / u;
        let rv = 1.0 / v;
        let r = ru * rv;
        let f = self.invariant(u + v + r, u * v + ru + rv);
        let a_u = 1.0 - r * ru;
        let a_v = 1.0 - r * rv;
        let b_u = v - ru * ru;
        let b_v = u - rv * rv;
        let a_uu = 2.0 * r * ru * ru;
        let a_uv = r * r;
        let a_vv = 2.0 * r * rv * rv;
        let b_uu = 2.0 * ru * ru * ru;
        let b_vv = 2.0 * rv * rv * rv;
        let second = |a: f64, b: f64, c: f64, d: f64| {
            f.w11 * a * b + f.w12 * (a * d + c * b) + f.w22 * c * d
        };
        Biaxial {
            w: f.w,
            u: f.w1 * a_u + f.w2 * b_u,
            v: f.w1 * a_v + f.w2 * b_v,
            uu: second(a_u, a_u, b_u, b_u) + f.w1 * a_uu + f.w2 * b_uu,
            uv: second(a_u, a_v, b_u, b_v) + f.w1 * a_uv + f.w2,
            vv: second(a_v, a_v, b_v, b_v) + f.w1 * a_vv + f.w2 * b_vv,
        }
    }

    fn visit<V: LawVisitor>(&self, visitor: V) -> V::Output {
        visitor.invariant_law(self)
    }
}
