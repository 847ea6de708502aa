//! Rubber laws: energy per reference volume of isotropic hyperelastic rubber, and its derivatives.
//!
//! One law is one file in `laws`, and one line in the list there. A law says what its constants are
//! ([`LawConstants`]) and what its energy is: laws written in the invariants I1, I2 by
//! [`InvariantLaw`], others by [`RubberLaw`]. Everything else follows. All energies are in MPa (=
//! N·mm/mm³) and vanish at rest.

mod by_invariants;
mod check;
mod compound;
mod constant;
mod custom;
mod form;
mod invariants;
mod law;
mod laws;
pub mod library;
pub mod over_time;
mod stability;
mod written;

pub use check::{LawFault, check_law};
pub use compound::{Bulk, Conditioned, Rubber};
pub use constant::{Constant, ConstantValue, LawConstants, LawKind};
pub use custom::CustomLaw;
pub use form::Form;
pub use invariants::{InvariantDerivatives, InvariantLaw};
pub use law::LawVisitor;
pub use laws::*;
pub use library::{LibraryError, RubberEntry, RubberFit};
pub use stability::{
    MUSCLE_AXIAL_STRETCH, MUSCLE_HOOP_STRETCH, biaxial_unstable_from, is_stable_at, log_hessian,
    muscle_states, muscle_unstable_from,
};
pub use written::law_of;

/// Energy and derivatives in the three principal stretches taken as independent variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Principal {
    /// w(λ1, λ2, λ3) in MPa.
    pub w: f64,
    /// ∂w/∂λi in MPa.
    pub d: [f64; 3],
    /// ∂²w/∂λi∂λj in MPa.
    pub dd: [[f64; 3]; 3],
}

/// Energy and derivatives of incompressible rubber in two squared stretches u = λθ², v = λz² (λr² =
/// 1/(uv)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Biaxial {
    /// ŵ(u, v) in MPa.
    pub w: f64,
    /// ∂ŵ/∂u in MPa.
    pub u: f64,
    /// ∂ŵ/∂v in MPa.
    pub v: f64,
    /// ∂²ŵ/∂u² in MPa.
    pub uu: f64,
    /// ∂²ŵ/∂u∂v in MPa.
    pub uv: f64,
    /// ∂²ŵ/∂v² in MPa.
    pub vv: f64,
}

/// An isotropic hyperelastic law.
///
/// Outside the stretches a law can carry (Gent beyond its limit) the energy is `+∞` and the
/// derivatives are not finite; solvers turn that into their typed error.
pub trait RubberLaw: Sync {
    /// Shear modulus μ at rest, in MPa.
    fn shear_modulus_mpa(&self) -> f64;

    /// Energy and derivatives in the principal stretches (all above zero, their product need not be
    /// 1).
    fn principal(&self, stretches: [f64; 3]) -> Principal;

    /// Energy and derivatives of incompressible rubber in u = λθ², v = λz² (both above zero).
    fn biaxial(&self, u: f64, v: f64) -> Biaxial {
        // λ1 = λr = (uv)^(−1/2), λ2 = √u, λ3 = √v; chain rule through log-derivatives.
        let l = [1.0 / (u * v).sqrt(), u.sqrt(), v.sqrt()];
        let p = self.principal(l);
        // dλ/du: −λr/(2u), λθ/(2u), 0;   dλ/dv: −λr/(2v), 0, λz/(2v)
        let lu = [-l[0] / (2.0 * u), l[1] / (2.0 * u), 0.0];
        let lv = [-l[0] / (2.0 * v), 0.0, l[2] / (2.0 * v)];
        let luu = [0.75 * l[0] / (u * u), -0.25 * l[1] / (u * u), 0.0];
        let luv = [0.25 * l[0] / (u * v), 0.0, 0.0];
        let lvv = [0.75 * l[0] / (v * v), 0.0, -0.25 * l[2] / (v * v)];
        let first = |a: &[f64; 3]| (0..3).map(|i| p.d[i] * a[i]).sum::<f64>();
        let second = |a: &[f64; 3], b: &[f64; 3]| {
            (0..3)
                .flat_map(|i| (0..3).map(move |j| (i, j)))
                .map(|(i, j)| p.dd[i][j] * a[i] * b[j])
                .sum::<f64>()
        };
        Biaxial {
            w: p.w,
            u: first(&lu),
            v: first(&lv),
            uu: second(&lu, &lu) + first(&luu),
            uv: second(&lu, &lv) + first(&luv),
            vv: second(&lv, &lv) + first(&lvv),
        }
    }

    /// Nominal stress in uniaxial tension of incompressible rubber, in MPa (Treloar 1975
    /// \[treloar1975\]): dŵ/dλ with λ1 = λ, λ2 = λ3 = λ^(−1/2).
    fn uniaxial_stress_mpa(&self, stretch: f64) -> f64 {
        let t = stretch.powf(-0.5);
        let p = self.principal([stretch, t, t]);
        p.d[0] - t / stretch * 0.5 * (p.d[1] + p.d[2])
    }

    /// Nominal stress in equibiaxial tension, λ1 = λ2 = λ, λ3 = λ⁻², in MPa.
    fn equibiaxial_stress_mpa(&self, stretch: f64) -> f64 {
        let p = self.principal([stretch, stretch, stretch.powi(-2)]);
        0.5 * (p.d[0] + p.d[1]) - p.d[2] * stretch.powi(-3)
    }

    /// Nominal stress in planar tension (pure shear), λ1 = λ, λ2 = 1, λ3 = 1/λ, in MPa.
    fn planar_stress_mpa(&self, stretch: f64) -> f64 {
        let p = self.principal([stretch, 1.0, 1.0 / stretch]);
        p.d[0] - p.d[2] * stretch.powi(-2)
    }

    /// Hands `visitor` the law by its own type, so that loops inside are compiled for it.
    #[doc(hidden)]
    fn visit<V: LawVisitor>(&self, visitor: V) -> V::Output
    where
        Self: Sized,
    {
        visitor.law(self)
    }
}

#[cfg(test)]
mod battery;
