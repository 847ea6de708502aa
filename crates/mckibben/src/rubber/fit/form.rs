//! The laws as something with unknown constants.

use crate::rubber::{Gent, Law, MooneyRivlin, NeoHookean, Ogden, Yeoh};

/// A law without its constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// One constant.
    NeoHookean,
    /// Two.
    MooneyRivlin,
    /// Two.
    Gent,
    /// Three.
    Yeoh,
    /// Two each term.
    Ogden {
        /// 1 to 3.
        terms: usize,
    },
}

impl Form {
    /// All, those with fewer constants first.
    pub const ALL: [Form; 7] = [
        Form::NeoHookean,
        Form::MooneyRivlin,
        Form::Gent,
        Form::Ogden { terms: 1 },
        Form::Yeoh,
        Form::Ogden { terms: 2 },
        Form::Ogden { terms: 3 },
    ];

    /// Name of the law, as in muscle files.
    pub fn law(self) -> &'static str {
        match self {
            Form::NeoHookean => "neo-hookean",
            Form::MooneyRivlin => "mooney-rivlin",
            Form::Gent => "gent",
            Form::Yeoh => "yeoh",
            Form::Ogden { .. } => "ogden",
        }
    }

    /// Name with the number of Ogden's terms: `ogden-2`.
    pub fn name(self) -> String {
        match self {
            Form::Ogden { terms } => format!("ogden-{terms}"),
            other => other.law().to_owned(),
        }
    }

    /// From a name: `yeoh`, `ogden-2`; `ogden` alone is all three.
    pub fn parse(name: &str) -> Vec<Form> {
        let plain = name.trim().to_lowercase().replace(['_', ' '], "-");
        let of = |f: &Form| plain == f.law() || plain == f.name() || plain == f.name().replace('-', "");
        Form::ALL.into_iter().filter(of).collect()
    }

    /// How many constants it has.
    pub fn constants(self) -> usize {
        match self {
            Form::NeoHookean => 1,
            Form::MooneyRivlin | Form::Gent => 2,
            Form::Yeoh => 3,
            Form::Ogden { terms } => 2 * terms,
        }
    }

    /// Fewest points it is fitted to: two a constant, and two degrees of freedom.
    pub fn fewest_points(self) -> usize {
        (2 * self.constants()).max(self.constants() + 2)
    }

    /// Whether the energy follows from I1 alone, so that one-axis tests say something of two axes.
    pub fn is_of_i1(self) -> bool {
        matches!(self, Form::NeoHookean | Form::Gent | Form::Yeoh)
    }

    /// The law with one constant 1 and all others 0, one for each constant; `None` where the stress is not linear in them.
    pub(super) fn basis(self) -> Option<Vec<Law>> {
        let law = |c: [f64; 3]| match self {
            Form::NeoHookean => Some(Law::NeoHookean(NeoHookean { mu_mpa: c[0] })),
            Form::MooneyRivlin => Some(Law::MooneyRivlin(MooneyRivlin { c10_mpa: c[0], c01_mpa: c[1] })),
            Form::Yeoh => Some(Law::Yeoh(Yeoh { c10_mpa: c[0], c20_mpa: c[1], c30_mpa: c[2] })),
            Form::Gent | Form::Ogden { .. } => None,
        };
        (0..self.constants().min(3)).map(|i| law([0, 1, 2].map(|k| if k == i { 1.0 } else { 0.0 }))).collect()
    }

    /// The law with these constants, in the order of [`RubberLaw::constants`](crate::rubber::RubberLaw::constants).
    pub fn law_of(self, c: &[f64]) -> Option<Law> {
        if c.len() != self.constants() {
            return None;
        }
        Some(match self {
            Form::NeoHookean => Law::NeoHookean(NeoHookean { mu_mpa: c[0] }),
            Form::MooneyRivlin => Law::MooneyRivlin(MooneyRivlin { c10_mpa: c[0], c01_mpa: c[1] }),
            Form::Gent => Law::Gent(Gent { mu_mpa: c[0], jm: c[1] }),
            Form::Yeoh => Law::Yeoh(Yeoh { c10_mpa: c[0], c20_mpa: c[1], c30_mpa: c[2] }),
            Form::Ogden { .. } => {
                Law::Ogden(Ogden { terms: c.chunks_exact(2).map(|t| (t[0], t[1])).collect() })
            }
        })
    }
}
