//! Whether an energy and its derivatives belong together: for laws of your own.

use super::{Biaxial, Law, Principal, RubberLaw};
use thiserror::Error;

/// What is wrong with a law.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("the law {law}: {quantity} is {value}, it must be {expected}")]
pub struct LawFault {
    /// Name of the law.
    pub law: &'static str,
    /// Which quantity, and in which state.
    pub quantity: String,
    /// What the law gives.
    pub value: f64,
    /// What it must be: zero, or what differences of the energy or its first derivatives give.
    pub expected: f64,
}

/// Principal stretches in which a law is tried; their product need not be 1.
pub const STATES: [[f64; 3]; 4] = [
    [0.8, 1.6, 0.7],
    [1.0, 1.0, 1.0],
    [0.45, 2.3, 0.9],
    [1.9, 0.8, 0.66],
];
/// Step of the differences.
const STEP: f64 = 1e-5;
/// What rounding leaves of a difference and of a sum, as a share of the modulus and the value.
const BY_DIFFERENCES: f64 = 1e-6;
const BY_ROUNDING: f64 = 1e-9;

/// Checks a law: its constants, that energy and stress vanish at rest, its modulus at rest, and each
/// derivative against differences of what it is derived from. States in which the law has no finite
/// energy are left out.
///
/// # Errors
/// [`LawFault`] of the first that is wrong.
pub fn check_law(law: &Law) -> Result<(), LawFault> {
    let check = Check {
        law,
        mu_mpa: law.shear_modulus_mpa(),
    };
    check.at_rest()?;
    for state in STATES {
        check.principal(state)?;
    }
    for (u, v) in [(1.0, 1.0), (2.5, 0.8), (4.0, 0.6), (0.7, 1.8)] {
        check.biaxial(u, v)?;
    }
    Ok(())
}

struct Check<'a> {
    law: &'a Law,
    mu_mpa: f64,
}

impl Check<'_> {
    fn same(
        &self,
        quantity: impl FnOnce() -> String,
        value: f64,
        expected: f64,
        share: f64,
    ) -> Result<(), LawFault> {
        // A value that is not a number is near to nothing.
        if (value - expected).abs() <= share * (self.mu_mpa.abs() + expected.abs()) {
            return Ok(());
        }
        Err(LawFault {
            law: self.law.name(),
            quantity: quantity(),
            value,
            expected,
        })
    }

    fn at_rest(&self) -> Result<(), LawFault> {
        let law = self.law;
        let said = |what: &str| format!("{what} at rest");
        let energy = law.principal([1.0; 3]).w;
        self.same(|| said("the energy"), energy, 0.0, BY_ROUNDING)?;
        type Stress = fn(&Law, f64) -> f64;
        let tensions: [(_, Stress, f64); 3] = [
            ("uniaxial", Law::uniaxial_stress_mpa, 3.0),
            ("equibiaxial", Law::equibiaxial_stress_mpa, 6.0),
            ("planar", Law::planar_stress_mpa, 4.0),
        ];
        for (name, stress, factor) in tensions {
            let what = |of: &str| said(&format!("the {of} in {name} tension"));
            self.same(|| what("stress"), stress(law, 1.0), 0.0, BY_ROUNDING)?;
            let slope = (stress(law, 1.0 + STEP) - stress(law, 1.0 - STEP)) / (2.0 * STEP);
            let expected = factor * self.mu_mpa;
            self.same(|| what("modulus"), slope, expected, BY_DIFFERENCES)?;
        }
        Ok(())
    }

    fn principal(&self, state: [f64; 3]) -> Result<(), LawFault> {
        let here = self.law.principal(state);
        if !here.w.is_finite() {
            return Ok(());
        }
        for i in 0..3 {
            let moved = |by: f64| {
                let mut there = state;
                there[i] += by;
                self.law.principal(there)
            };
            let (above, below) = (moved(STEP), moved(-STEP));
            let slope = |of: fn(&Principal, usize) -> f64, j| {
                (of(&above, j) - of(&below, j)) / (2.0 * STEP)
            };
            let first = slope(|p, _| p.w, 0);
            self.same(
                || format!("∂w/∂λ{} at λ = {state:?}", i + 1),
                here.d[i],
                first,
                BY_DIFFERENCES,
            )?;
            for j in 0..3 {
                let second = slope(|p, j| p.d[j], j);
                self.same(
                    || format!("∂²w/∂λ{}∂λ{} at λ = {state:?}", j + 1, i + 1),
                    here.dd[j][i],
                    second,
                    BY_DIFFERENCES,
                )?;
            }
        }
        Ok(())
    }

    /// The way through principal stretches and the law's own are one function.
    fn biaxial(&self, u: f64, v: f64) -> Result<(), LawFault> {
        let values = |b: Biaxial| [b.w, b.u, b.v, b.uu, b.uv, b.vv];
        let expected = values(Plain(self.law).biaxial(u, v));
        if !expected[0].is_finite() {
            return Ok(());
        }
        let own = values(self.law.biaxial(u, v));
        let names = ["ŵ", "∂ŵ/∂u", "∂ŵ/∂v", "∂²ŵ/∂u²", "∂²ŵ/∂u∂v", "∂²ŵ/∂v²"];
        names
            .iter()
            .zip(own.iter().zip(expected))
            .try_for_each(|(name, (value, expected))| {
                self.same(
                    || format!("{name} at u = {u}, v = {v}"),
                    *value,
                    expected,
                    BY_ROUNDING,
                )
            })
    }
}

/// A law with the way through principal stretches alone.
pub struct Plain<'a>(pub &'a dyn RubberLaw);

impl RubberLaw for Plain<'_> {
    fn shear_modulus_mpa(&self) -> f64 {
        self.0.shear_modulus_mpa()
    }

    fn principal(&self, stretches: [f64; 3]) -> Principal {
        self.0.principal(stretches)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rubber::{Constant, InvariantDerivatives, InvariantLaw, LawConstants};

    #[test]
    fn every_law_of_the_list_passes() {
        for law in Law::examples() {
            assert_eq!(check_law(&law), Ok(()));
        }
    }

    /// W = μ/2 (I1 − 3) + b (I1 − 3)², with one derivative that is wrong.
    #[derive(Debug)]
    struct Wrong<const WHICH: usize>;

    impl<const WHICH: usize> InvariantLaw for Wrong<WHICH> {
        fn invariant(&self, i1: f64, _: f64) -> InvariantDerivatives {
            let x = i1 - 3.0;
            let mut d = InvariantDerivatives {
                w: 0.1 * x + 0.01 * x * x,
                w1: 0.1 + 0.02 * x,
                w11: 0.02,
                ..Default::default()
            };
            let wrong = [&mut d.w, &mut d.w1, &mut d.w11, &mut d.w22];
            if let Some(value) = wrong.into_iter().nth(WHICH) {
                *value += 0.001;
            }
            d
        }
    }

    impl<const WHICH: usize> LawConstants for Wrong<WHICH> {
        const NAME: &'static str = "wrong";
        const CONSTANTS: &'static [Constant] = &[];
        const EXAMPLE: &'static [f64] = &[];

        fn from_values(_: &[f64]) -> Option<Self> {
            Some(Self)
        }

        fn values(&self) -> Vec<f64> {
            vec![]
        }
    }

    #[test]
    fn each_wrong_derivative_is_found_and_named() {
        let said = |law: Law| check_law(&law).unwrap_err().quantity;
        assert_eq!(said(Law::custom(Wrong::<0>)), "the energy at rest");
        assert!(said(Law::custom(Wrong::<1>)).starts_with("∂w/∂λ1 at"));
        assert!(said(Law::custom(Wrong::<2>)).starts_with("∂²w/∂λ1∂λ1 at"));
        assert!(said(Law::custom(Wrong::<3>)).starts_with("∂²w/∂λ1∂λ1 at"));
        assert_eq!(check_law(&Law::custom(Wrong::<9>)), Ok(()));
    }
}
