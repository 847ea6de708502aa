//! The closed set of laws, for data that is read at run time.

use super::{Biaxial, Gent, MooneyRivlin, NeoHookean, Ogden, Principal, RubberLaw, Yeoh};
use thiserror::Error;

/// Any of the laws. Kernels are generic over [`RubberLaw`]: match once, outside the quadrature loop
/// ([`Law::visit`]).
#[derive(Debug, Clone, PartialEq)]
pub enum Law {
    /// W = C10 (I1−3) + C01 (I2−3)
    MooneyRivlin(MooneyRivlin),
    /// W = μ/2 (I1−3)
    NeoHookean(NeoHookean),
    /// W = Σ Ci0 (I1−3)^i
    Yeoh(Yeoh),
    /// W = Σ (μi/αi)(Σ λ^αi − 3)
    Ogden(Ogden),
    /// W = −μ Jm/2 ln(1 − (I1−3)/Jm)
    Gent(Gent),
}

/// Something that is done with a law whose type is known at compile time.
pub trait LawVisitor {
    /// What it gives back.
    type Output;
    /// The work itself, compiled once for every law.
    fn with<L: RubberLaw>(self, law: &L) -> Self::Output;
}

/// Why constants do not make a law.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LawError {
    /// The shear modulus at rest is not above zero.
    #[error(
        "the {law} constants give a shear modulus of {shear_modulus_mpa} MPa at rest; it must be above zero (c10 + c01, mu, or Σ mu·alpha)"
    )]
    NotStiff {
        /// Which law.
        law: &'static str,
        /// Its shear modulus in MPa.
        shear_modulus_mpa: f64,
    },
    /// A constant that is NaN or infinite.
    #[error("the constant {name} of the {law} law is {value}; it must be a finite number")]
    NotFinite {
        /// Which law.
        law: &'static str,
        /// Which constant.
        name: String,
        /// Its value.
        value: f64,
    },
    /// Gent's limit is not above zero.
    #[error("jm of the gent law is {jm}; it must be above zero (it is the largest I1 − 3)")]
    Limit {
        /// Its value.
        jm: f64,
    },
    /// An Ogden exponent of zero, or no terms.
    #[error("an ogden law needs one alpha other than zero for each mu")]
    Terms,
}

impl Law {
    /// Names of all laws, as written in muscle files.
    pub const NAMES: [&'static str; 5] = ["mooney-rivlin", "neo-hookean", "yeoh", "ogden", "gent"];

    /// Checks the constants.
    ///
    /// # Errors
    /// [`LawError`] where a constant is not finite or the rubber has no stiffness at rest.
    pub fn validated(self) -> Result<Self, LawError> {
        let law = self.name();
        if let Some((name, value, _)) = self.constants().into_iter().find(|c| !c.1.is_finite()) {
            return Err(LawError::NotFinite { law, name, value });
        }
        match &self {
            Law::Gent(g) if g.jm <= 0.0 => return Err(LawError::Limit { jm: g.jm }),
            Law::Ogden(o) if o.terms.is_empty() || o.terms.iter().any(|t| t.1 == 0.0) => {
                return Err(LawError::Terms);
            }
            _ => {}
        }
        let mu = self.shear_modulus_mpa();
        if mu > 0.0 { Ok(self) } else { Err(LawError::NotStiff { law, shear_modulus_mpa: mu }) }
    }

    /// The law of a name with its constants in the order of [`RubberLaw::constants`]; `None` where name or number of constants
    /// fit no law. The law is not checked; see [`Law::validated`].
    pub fn named(name: &str, constants: &[f64]) -> Option<Law> {
        let law = match (name, constants) {
            ("mooney-rivlin", &[c10_mpa, c01_mpa]) => Law::MooneyRivlin(MooneyRivlin { c10_mpa, c01_mpa }),
            ("neo-hookean", &[mu_mpa]) => Law::NeoHookean(NeoHookean { mu_mpa }),
            ("yeoh", &[c10_mpa, c20_mpa, c30_mpa]) => Law::Yeoh(Yeoh { c10_mpa, c20_mpa, c30_mpa }),
            ("gent", &[mu_mpa, jm]) => Law::Gent(Gent { mu_mpa, jm }),
            ("ogden", list) if list.len() >= 2 && list.len().is_multiple_of(2) => {
                Law::Ogden(Ogden { terms: list.chunks(2).map(|c| (c[0], c[1])).collect() })
            }
            _ => return None,
        };
        Some(law)
    }

    /// Runs `visitor` with the concrete law, so that loops inside are compiled for it.
    pub fn visit<V: LawVisitor>(&self, visitor: V) -> V::Output {
        match self {
            Law::MooneyRivlin(l) => visitor.with(l),
            Law::NeoHookean(l) => visitor.with(l),
            Law::Yeoh(l) => visitor.with(l),
            Law::Ogden(l) => visitor.with(l),
            Law::Gent(l) => visitor.with(l),
        }
    }

    /// The same law with its constants passed through `change` (position in [`RubberLaw::constants`], value). The new law
    /// is not checked; see [`Law::validated`].
    pub fn with_constants(&self, change: impl Fn(usize, f64) -> f64) -> Law {
        match self {
            Law::MooneyRivlin(l) => Law::MooneyRivlin(MooneyRivlin {
                c10_mpa: change(0, l.c10_mpa),
                c01_mpa: change(1, l.c01_mpa),
            }),
            Law::NeoHookean(l) => Law::NeoHookean(NeoHookean { mu_mpa: change(0, l.mu_mpa) }),
            Law::Yeoh(l) => Law::Yeoh(Yeoh {
                c10_mpa: change(0, l.c10_mpa),
                c20_mpa: change(1, l.c20_mpa),
                c30_mpa: change(2, l.c30_mpa),
            }),
            Law::Gent(l) => Law::Gent(Gent { mu_mpa: change(0, l.mu_mpa), jm: change(1, l.jm) }),
            Law::Ogden(l) => {
                let pair =
                    |(i, &(mu, alpha)): (usize, &(f64, f64))| (change(2 * i, mu), change(2 * i + 1, alpha));
                Law::Ogden(Ogden { terms: l.terms.iter().enumerate().map(pair).collect() })
            }
        }
    }

    /// The same law with every modulus multiplied by `factor` (limits and exponents stay).
    pub fn scaled(&self, factor: f64) -> Law {
        let moduli: Vec<bool> = self.constants().iter().map(|c| c.2 == "MPa").collect();
        self.with_constants(|i, value| if moduli.get(i) == Some(&true) { value * factor } else { value })
    }
}

macro_rules! each {
    ($self:ident, $l:ident => $body:expr) => {
        match $self {
            Law::MooneyRivlin($l) => $body,
            Law::NeoHookean($l) => $body,
            Law::Yeoh($l) => $body,
            Law::Ogden($l) => $body,
            Law::Gent($l) => $body,
        }
    };
}

impl RubberLaw for Law {
    fn name(&self) -> &'static str {
        each!(self, l => l.name())
    }
    fn constants(&self) -> Vec<(String, f64, &'static str)> {
        each!(self, l => l.constants())
    }
    fn shear_modulus_mpa(&self) -> f64 {
        each!(self, l => l.shear_modulus_mpa())
    }
    fn principal(&self, stretches: [f64; 3]) -> Principal {
        each!(self, l => l.principal(stretches))
    }
    fn biaxial(&self, u: f64, v: f64) -> Biaxial {
        each!(self, l => l.biaxial(u, v))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_comes_back_from_its_name_and_constants() {
        for (name, list) in [
            ("mooney-rivlin", vec![0.1, 0.02]),
            ("neo-hookean", vec![0.2]),
            ("yeoh", vec![0.1, -0.001, 1e-4]),
            ("gent", vec![0.2, 50.0]),
            ("ogden", vec![0.6, 1.3, -0.01, -2.0]),
        ] {
            let law = Law::named(name, &list).unwrap();
            assert_eq!(law.name(), name);
            assert_eq!(law.constants().into_iter().map(|c| c.1).collect::<Vec<_>>(), list);
            assert_eq!(Law::named(name, &list[1..]), None);
        }
    }
}
