//! What can be done with any law: its constants, their check, and the work that is compiled for
//! each law.

use super::{ConstantValue, InvariantLaw, Law, LawKind, RubberLaw};
use crate::refused::Refused;
use std::collections::BTreeMap;

/// Something that is done with a law whose type is known at compile time ([`RubberLaw::visit`]): a
/// loop inside is compiled for every law.
pub trait LawVisitor: Sized {
    /// What it gives back.
    type Output;

    /// The work for any law, through the principal stretches.
    fn law<L: RubberLaw>(self, law: &L) -> Self::Output;

    /// The work for a law in the invariants, where there is a shorter way.
    fn invariant_law<L: InvariantLaw>(self, law: &L) -> Self::Output {
        self.law(law)
    }
}

/// Most terms of a sum; published laws have up to six.
const MOST_TERMS: usize = 20;

fn between((low, high): (f64, f64)) -> String {
    let low = if low == 0.0 {
        "zero".to_owned()
    } else {
        low.to_string()
    };
    if high.is_finite() {
        format!("above {low} and below {high}")
    } else {
        format!("above {low}")
    }
}

impl Law {
    /// Names of all laws, as written in muscle files.
    pub fn names() -> Vec<&'static str> {
        Self::KINDS.iter().map(|k| k.name).collect()
    }

    /// The law of a name, without the values of its constants.
    pub(crate) fn kind_named(name: &str) -> Option<&'static LawKind> {
        Self::KINDS.iter().find(|k| k.name == name)
    }

    /// The law of a name with its constants in the order of [`Law::constants`]; `None` where name
    /// or number of constants fit no law. The law is not checked; see [`Law::validated`].
    pub fn named(name: &str, constants: &[f64]) -> Option<Law> {
        Self::kind_named(name)?.law(constants)
    }

    /// Every law with the constants of its [`example`](LawKind::example).
    pub fn examples() -> Vec<Law> {
        Self::KINDS
            .iter()
            .filter_map(|k| k.law(k.example))
            .collect()
    }

    /// Name as written in muscle files, such as `mooney-rivlin`.
    pub fn name(&self) -> &'static str {
        self.kind().name
    }

    /// The constants with their values.
    #[doc(hidden)]
    pub fn constants(&self) -> Vec<ConstantValue> {
        let kind = self.kind();
        let count = kind.constants.len();
        let one = |(i, value): (usize, f64)| {
            let constant = &kind.constants[i % count];
            let name = constant.name;
            let name = if kind.is_sum {
                format!("{name}{}", i / count + 1)
            } else {
                name.to_owned()
            };
            ConstantValue {
                name,
                value,
                constant,
            }
        };
        self.values().into_iter().enumerate().map(one).collect()
    }

    /// The constants by the names of their columns, moduli in MPa: `c10_mpa`, `alpha1`.
    pub fn columns(&self) -> BTreeMap<String, f64> {
        self.constants()
            .into_iter()
            .map(|c| (c.column(), c.value))
            .collect()
    }

    /// Checks the constants.
    ///
    /// # Errors
    /// [`Refused`] where a constant is not finite or the rubber has no stiffness at rest.
    pub fn validated(self) -> Result<Self, Refused> {
        let law = self.name();
        let constants = self.constants();
        if self.kind().is_sum && constants.len() > MOST_TERMS * self.kind().constants.len() {
            return Err(Refused::new(
                ["alpha"],
                format!("an {law} law has at most {MOST_TERMS} terms"),
            ));
        }
        if let Some(ConstantValue { name, value, .. }) =
            constants.iter().find(|c| !c.value.is_finite())
        {
            return Err(Refused::new(
                [],
                format!(
                    "the constant {name} of the {law} law is {value}; it must be a finite number"
                ),
            ));
        }
        // Moduli are judged together, by the stiffness that they give.
        for ConstantValue {
            value, constant: c, ..
        } in &constants
        {
            let within = *value > c.bounds.0 && *value < c.bounds.1;
            if !c.is_modulus() && !within {
                let name = c.name;
                let must = between(c.bounds);
                let doc = c.doc;
                let message =
                    format!("{name} of the {law} law is {value}; it must be {must} (it is {doc})");
                return Err(Refused::new([name], message));
            }
        }
        let mu = self.shear_modulus_mpa();
        // A sum of terms without a term, or with one that is not defined.
        if self.kind().is_sum && (constants.is_empty() || !self.principal([1.0; 3]).w.is_finite()) {
            return Err(Refused::new(
                ["alpha"],
                "an ogden law needs one alpha other than zero for each mu",
            ));
        }
        if mu > 0.0 {
            return Ok(self);
        }
        let first = self
            .kind()
            .constants
            .iter()
            .find(|c| c.is_modulus())
            .map(|c| c.name);
        Err(Refused::new(
            first,
            format!(
                "the {law} constants give a shear modulus of {mu} MPa at rest; it must be above \
                 zero (c10 + c01, mu, or Σ mu·alpha)"
            ),
        ))
    }

    /// The same law with its constants passed through `change` (position in [`Law::constants`],
    /// value). The new law is not checked; see [`Law::validated`].
    #[must_use]
    pub fn with_constants(&self, change: impl Fn(usize, f64) -> f64) -> Law {
        let values: Vec<f64> = self
            .values()
            .into_iter()
            .enumerate()
            .map(|(i, v)| change(i, v))
            .collect();
        self.kind().law(&values).unwrap_or_else(|| self.clone())
    }

    /// `share` of the way from this law to another of its kind. Of a sum all terms of both, and of
    /// laws that are linear in their moduli these moduli in proportion: the energy is (1 − share)
    /// times this one and share times the other. The reciprocal of a limit of stretch goes in
    /// proportion too.
    #[must_use]
    pub fn towards(&self, other: &Law, share: f64) -> Law {
        let constants = self.kind().constants;
        let others = other.values();
        if self.kind().is_sum {
            let terms = [
                self.scaled(1.0 - share).values(),
                other.scaled(share).values(),
            ]
            .concat();
            return self.kind().law(&terms).unwrap_or_else(|| self.clone());
        }
        self.with_constants(|i, from| {
            if constants[i].is_modulus() {
                (1.0 - share) * from + share * others[i]
            } else {
                1.0 / ((1.0 - share) / from + share / others[i])
            }
        })
    }

    /// The same law with every modulus multiplied by `factor` (limits and exponents stay).
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Law {
        let constants = self.kind().constants;
        let is_modulus = |i: usize| constants[i % constants.len()].is_modulus();
        self.with_constants(|i, value| if is_modulus(i) { value * factor } else { value })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_comes_back_from_its_name_and_constants() {
        for kind in Law::KINDS {
            let law = Law::named(kind.name, kind.example).unwrap();
            assert_eq!((law.name(), law.kind()), (kind.name, kind));
            assert_eq!(law.values(), kind.example);
            assert_eq!(Law::named(kind.name, &kind.example[1..]), None);
        }
        assert_eq!(Law::named("rubber", &[1.0]), None);
    }

    #[test]
    fn a_limit_outside_its_bounds_is_told_with_its_meaning() {
        let error = Law::named("gent", &[0.2, -3.0])
            .unwrap()
            .validated()
            .unwrap_err();
        assert_eq!(
            error.to_string(),
            "jm of the gent law is -3; it must be above zero (it is the largest I1 − 3)"
        );
        assert_eq!(error.fields, ["jm"]);
    }
}
