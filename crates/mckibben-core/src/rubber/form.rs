//! The form of a law: its equation with unknown constants, before a fit.

use super::{InvariantLaw, Law, LawKind, LawVisitor, RubberLaw};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

/// Most terms of a law that is a sum of terms.
const TERMS: usize = 3;
/// A state in which laws are tested for linearity.
const STRETCHES: [f64; 3] = [1.7, 0.9, 0.7];

/// A law without its constants; of a sum of terms, with their number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Form {
    kind: &'static LawKind,
    /// 1 for laws that are no sum.
    terms: usize,
}

impl Form {
    /// All, those with fewer constants first.
    pub fn all() -> Vec<Form> {
        let forms = |kind: &'static LawKind| {
            (1..=if kind.is_sum { TERMS } else { 1 }).map(move |terms| Form { kind, terms })
        };
        let mut all: Vec<Form> = Law::KINDS.iter().flat_map(forms).collect();
        all.sort_by_key(|f| (f.constants(), f.kind.is_sum));
        all
    }

    /// Name of the law, as in muscle files.
    pub fn law(self) -> &'static str {
        self.kind.name
    }

    /// Number of terms of a law that is a sum of them.
    pub fn terms(self) -> Option<usize> {
        self.kind.is_sum.then_some(self.terms)
    }

    /// Name with the number of terms: `yeoh`, `ogden-2`.
    pub fn name(self) -> String {
        self.terms().map_or_else(
            || self.law().to_owned(),
            |terms| format!("{}-{terms}", self.law()),
        )
    }

    /// From a name: `yeoh`, `ogden-2`; `ogden` alone is all three.
    pub fn parse(name: &str) -> Vec<Form> {
        let plain = name.trim().to_lowercase().replace(['_', ' '], "-");
        let is_meant =
            |f: &Form| plain == f.law() || plain == f.name() || plain == f.name().replace('-', "");
        Form::all().into_iter().filter(is_meant).collect()
    }

    /// What [`Form::parse`] understands, in the order of [`Form::all`], sums of terms last.
    pub fn words() -> Vec<String> {
        let (sums, laws): (Vec<Form>, Vec<Form>) =
            Form::all().into_iter().partition(|f| f.kind.is_sum);
        let of_sum = |f: Form| {
            (f.terms == 1)
                .then(|| f.law().to_owned())
                .into_iter()
                .chain([f.name()])
        };
        laws.iter()
            .map(|f| f.law().to_owned())
            .chain(sums.into_iter().flat_map(of_sum))
            .collect()
    }

    /// How many constants it has.
    pub fn constants(self) -> usize {
        self.terms * self.kind.constants.len()
    }

    /// Fewest points it is fitted to: two a constant, and two degrees of freedom.
    pub fn fewest_points(self) -> usize {
        (2 * self.constants()).max(self.constants() + 2)
    }

    /// A plausible rubber of this law.
    pub fn example(self) -> Option<Law> {
        let values: Vec<f64> = self
            .kind
            .example
            .iter()
            .copied()
            .cycle()
            .take(self.constants())
            .collect();
        self.law_of(&values)
    }

    /// Whether the energy follows from I1 alone, so that uniaxial tests say something of two axes.
    pub fn is_of_i1(self) -> bool {
        struct OfI1;
        impl LawVisitor for OfI1 {
            type Output = bool;
            fn law<L: RubberLaw>(self, _: &L) -> bool {
                false
            }
            fn invariant_law<L: InvariantLaw>(self, law: &L) -> bool {
                let d = law.invariant(4.0, 4.5);
                d.w2 == 0.0 && d.w12 == 0.0 && d.w22 == 0.0
            }
        }
        self.example().is_some_and(|law| law.visit(OfI1))
    }

    /// The law with one constant 1 and all others 0, one for each constant; `None` where the energy
    /// is not linear in them.
    pub fn basis(self) -> Option<Vec<Law>> {
        let unit = |i: usize| {
            (0..self.constants())
                .map(|k| if k == i { 1.0 } else { 0.0 })
                .collect::<Vec<_>>()
        };
        let basis = (0..self.constants())
            .map(|i| self.law_of(&unit(i)))
            .collect::<Option<Vec<_>>>()?;
        let law = self.example()?;
        let sum = |at: usize| {
            basis
                .iter()
                .zip(law.values())
                .map(|(b, value)| value * b.principal(STRETCHES).d[at])
                .sum::<f64>()
        };
        let exact = law.principal(STRETCHES).d;
        (0..3)
            .all(|i| (sum(i) - exact[i]).abs() <= 1e-12 * exact[i].abs())
            .then_some(basis)
    }

    /// The law with these constants, in the order of [`Law::constants`].
    pub fn law_of(self, c: &[f64]) -> Option<Law> {
        self.kind.law(c).filter(|_| c.len() == self.constants())
    }
}

impl Serialize for Form {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Form {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        match Form::parse(&name).as_slice() {
            [form] => Ok(*form),
            _ => Err(D::Error::custom(format!(
                "there is no law \"{name}\"; known: {}",
                Form::words().join(", ")
            ))),
        }
    }
}

impl std::fmt::Display for Form {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_law_is_made_of_is_seen_from_the_law() {
        for (name, linear, of_i1) in [
            ("neo-hookean", true, true),
            ("mooney-rivlin", true, false),
            ("yeoh", true, true),
            ("gent", false, true),
            ("ogden-1", false, false),
            ("ogden-3", false, false),
        ] {
            let form = Form::parse(name)[0];
            assert_eq!(
                (form.basis().is_some(), form.is_of_i1()),
                (linear, of_i1),
                "{name}"
            );
        }
    }

    #[test]
    fn a_sum_of_terms_has_a_form_for_each_number_of_them() {
        let all = |name: &str| {
            Form::parse(name)
                .into_iter()
                .map(Form::name)
                .collect::<Vec<_>>()
                .join(" ")
        };
        assert_eq!(all("ogden"), "ogden-1 ogden-2 ogden-3");
        assert_eq!(
            (all("Ogden_2"), all("yeoh"), all("yeo")),
            ("ogden-2".into(), "yeoh".into(), String::new())
        );
        let counts: Vec<usize> = Form::all().into_iter().map(Form::constants).collect();
        assert!(counts.is_sorted(), "{counts:?}");
        let words = Form::words().join(", ");
        assert!(
            words.starts_with("neo-hookean, mooney-rivlin, gent,"),
            "{words}"
        );
        assert!(
            words.ends_with("yeoh, extended-tube, ogden, ogden-1, ogden-2, ogden-3"),
            "{words}"
        );
    }
}
