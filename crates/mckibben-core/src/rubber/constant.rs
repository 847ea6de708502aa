//! What a law says of its constants: names, dimensions and bounds are declared once, and files,
//! fits, plans, columns, identification and sensitivities follow.

use super::{Law, RubberLaw};
use crate::{refused::Refused, units::Dimension};
use std::fmt;

/// A constant of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constant {
    /// As in muscle files; terms of a sum are counted behind it (`mu1`).
    pub name: &'static str,
    /// [`Dimension::Pressure`] for a modulus in MPa, [`Dimension::Ratio`] for a plain number.
    pub dimension: Dimension,
    /// What it must lie between, the ends left out.
    pub bounds: (f64, f64),
    /// What it is, in a few words.
    pub doc: &'static str,
}

impl Constant {
    /// A modulus above zero, in MPa.
    pub const fn modulus(name: &'static str, doc: &'static str) -> Self {
        Self {
            name,
            dimension: Dimension::Pressure,
            bounds: (0.0, f64::INFINITY),
            doc,
        }
    }

    /// A coefficient in MPa that may have either sign.
    pub const fn coefficient(name: &'static str, doc: &'static str) -> Self {
        Self {
            name,
            dimension: Dimension::Pressure,
            bounds: (f64::NEG_INFINITY, f64::INFINITY),
            doc,
        }
    }

    /// A plain number above `low`.
    pub const fn above(name: &'static str, low: f64, doc: &'static str) -> Self {
        Self {
            name,
            dimension: Dimension::Ratio,
            bounds: (low, f64::INFINITY),
            doc,
        }
    }

    /// Whether the energy is proportional to it: the stiffness of a rubber is a factor on these.
    pub fn is_modulus(&self) -> bool {
        self.dimension == Dimension::Pressure
    }

    /// Its unit; empty for a plain number.
    pub fn unit(&self) -> &'static str {
        if self.is_modulus() { "MPa" } else { "" }
    }
}

/// A constant with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct ConstantValue {
    /// Its name, with the number of its term where the law is a sum of terms: `c10`, `mu2`.
    pub name: String,
    /// Its value, in MPa for a modulus.
    pub value: f64,
    /// What the law says of it.
    pub constant: &'static Constant,
}

impl ConstantValue {
    /// The name with its unit, as columns of tables have it: `c10_mpa`, `jm`.
    pub fn column(&self) -> String {
        if self.constant.is_modulus() {
            format!("{}_mpa", self.name)
        } else {
            self.name.clone()
        }
    }
}

/// A law as something that is made of constants. This and [`InvariantLaw`](super::InvariantLaw) (or
/// [`RubberLaw`]) are all that a law needs.
pub trait LawConstants: RubberLaw + Sized {
    /// Name as written in muscle files.
    const NAME: &'static str;
    /// Its constants, in order; of a sum of terms, those of one term.
    const CONSTANTS: &'static [Constant];
    /// Whether the law is a sum of any number of terms, each with all of
    /// [`LawConstants::CONSTANTS`].
    const IS_SUM: bool = false;
    /// Constants of a plausible rubber: tests and fits start from them.
    const EXAMPLE: &'static [f64];

    /// The law of these constants, not checked; `None` where their number is wrong.
    fn from_values(values: &[f64]) -> Option<Self>;

    /// The values of the constants, in order.
    fn values(&self) -> Vec<f64>;

    /// The I1 − 3 at which the chains lock, where they do.
    fn locks_at(&self) -> Option<f64> {
        None
    }
}

/// A law without the values of its constants.
#[derive(Debug, Clone, Copy)]
pub struct LawKind {
    /// See [`LawConstants::NAME`].
    pub name: &'static str,
    /// See [`LawConstants::CONSTANTS`].
    pub constants: &'static [Constant],
    /// See [`LawConstants::IS_SUM`].
    pub is_sum: bool,
    /// See [`LawConstants::EXAMPLE`].
    pub example: &'static [f64],
    make: fn(&[f64]) -> Option<Law>,
}

impl PartialEq for LawKind {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl LawKind {
    pub(super) const fn new<L: LawConstants + Into<Law>>() -> Self {
        Self::made::<L>(|values| L::from_values(values).map(Into::into))
    }

    pub(super) const fn custom<L: LawConstants + fmt::Debug + Send + 'static>() -> Self {
        Self::made::<L>(|values| L::from_values(values).map(Law::custom))
    }

    const fn made<L: LawConstants>(make: fn(&[f64]) -> Option<Law>) -> Self {
        Self {
            name: L::NAME,
            constants: L::CONSTANTS,
            is_sum: L::IS_SUM,
            example: L::EXAMPLE,
            make,
        }
    }

    /// The law with these values, in the order of the constants (term by term in a sum); `None`
    /// where their number is wrong. The law is not checked; see [`Law::validated`].
    pub fn law(&self, values: &[f64]) -> Option<Law> {
        (self.make)(values)
    }

    /// Names of the constants.
    pub fn names(&self) -> Vec<&'static str> {
        self.constants.iter().map(|c| c.name).collect()
    }

    /// The law of one list of values for each constant: one value, or one a term in a sum.
    ///
    /// # Errors
    /// Where the lists are not equally long, or not one for each constant.
    pub fn law_of_terms(&self, lists: &[Vec<f64>]) -> Result<Law, Refused> {
        let law = self.name;
        let first = self.constants[0].name;
        let terms = lists.first().map_or(0, Vec::len);
        if let Some((list, c)) = lists
            .iter()
            .zip(self.constants)
            .find(|(list, _)| list.len() != terms)
        {
            let name = c.name;
            let count = list.len();
            return Err(Refused::new(
                [name],
                format!(
                    "has {count} numbers, but {first} has {terms}; an {law} law needs one {name} for \
                 each {first}"
                ),
            ));
        }
        let values: Vec<f64> = (0..terms)
            .flat_map(|t| lists.iter().filter_map(move |l| l.get(t).copied()))
            .collect();
        self.law(&values)
            .ok_or_else(|| Refused::new([first], NEEDS_ALL))
    }
}

/// What is said where a constant is missing.
pub const NEEDS_ALL: &str = "a law needs all of its constants";

/// What is said of a constant that belongs to another law.
pub fn foreign(law: &LawKind) -> String {
    format!(
        "is not a constant of the {} law; its constants are {}",
        law.name,
        law.names().join(", ")
    )
}

/// What is expected where a law is to be named.
pub fn one_of_all() -> String {
    format!("one of {}", Law::names().join(", "))
}
