//! The terms of a formula.

use super::{Coefficients, file::check::positive};
use crate::joined;
use serde::{Deserialize, Serialize};

/// What the variables of a `global` formula are divided by.
#[serde_with_macros::apply(crate = "serde_with_macros", f64 => #[serde(deserialize_with = "positive")])]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(expecting = "an object")]
pub struct Scales {
    /// Of x = s/D0.
    pub wall_ratio: f64,
    /// Of p = P, in MPa.
    pub pressure_mpa: f64,
    /// Of e = ε.
    pub contraction: f64,
    /// Of d = D0, in mm.
    pub outer_diameter_mm: f64,
}

/// One term c · xᵃ pᵇ eᶜ dᵈ of a `global` formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term<const N: usize = 4> {
    /// Powers of the variables; a, b, c, d of s/D0, P, ε and D0.
    pub powers: [u8; N],
    /// The coefficient; c in MPa.
    pub value: f64,
}

/// The terms of a `global` formula: F = D0² Σ c · xᵃ pᵇ eᶜ dᵈ.
#[derive(Debug, Clone, PartialEq)]
pub struct GlobalTerms {
    /// Scales of the variables.
    pub scales: Scales,
    /// The terms.
    pub terms: Vec<Term>,
}

impl Scales {
    /// x, p, e, d.
    pub fn variables(
        &self,
        outer_diameter_mm: f64,
        wall_mm: f64,
        pressure_mpa: f64,
        contraction: f64,
    ) -> [f64; 4] {
        [
            wall_mm / outer_diameter_mm / self.wall_ratio,
            pressure_mpa / self.pressure_mpa,
            contraction / self.contraction,
            outer_diameter_mm / self.outer_diameter_mm,
        ]
    }
}

impl Term {
    /// xᵃ pᵇ eᶜ dᵈ, without c.
    pub fn product(powers: [u8; 4], variables: [f64; 4]) -> f64 {
        powers
            .iter()
            .zip(variables)
            .map(|(&n, v)| v.powi(i32::from(n)))
            .product()
    }

    /// `x p² e`, or `1`.
    pub fn name(&self) -> String {
        name(self.powers, &["x", "p", "e", "d"], |n| format!("^{n}"))
    }
}

/// A product of powers in letters.
pub fn name<const N: usize>(
    powers: [u8; N],
    letters: &[&str; N],
    power: impl Fn(u8) -> String,
) -> String {
    let factor = |(letter, &n): (&&str, &u8)| match n {
        0 => None,
        1 => Some((*letter).to_owned()),
        n => Some(format!("{letter}{}", power(n))),
    };
    let factors = joined(letters.iter().zip(&powers).filter_map(factor), " ");
    if factors.is_empty() {
        "1".into()
    } else {
        factors
    }
}

/// A `global` formula with diameter and wall put in: F = Σ c pᵇ eᶜ.
#[derive(Debug, Clone, PartialEq)]
pub struct GlobalSection {
    pressure_scale: f64,
    contraction_scale: f64,
    terms: Vec<(i32, i32, f64)>,
}

impl GlobalTerms {
    /// Puts in diameter and wall.
    pub fn section(&self, outer_diameter_mm: f64, wall_mm: f64) -> GlobalSection {
        let [x, _, _, d] = self.scales.variables(outer_diameter_mm, wall_mm, 0.0, 0.0);
        let mut terms: Vec<(i32, i32, f64)> = vec![];
        for t in &self.terms {
            let [a, b, c, e] = t.powers.map(i32::from);
            let value = outer_diameter_mm.powi(2) * t.value * x.powi(a) * d.powi(e);
            match terms.iter_mut().find(|q| (q.0, q.1) == (b, c)) {
                Some(q) => q.2 += value,
                None => terms.push((b, c, value)),
            }
        }
        let Scales {
            pressure_mpa,
            contraction,
            ..
        } = self.scales;
        GlobalSection {
            pressure_scale: pressure_mpa,
            contraction_scale: contraction,
            terms,
        }
    }
}

impl GlobalSection {
    /// F in N, ∂F/∂ε in N, ∂F/∂P in mm².
    pub fn force_and_slopes(&self, pressure_mpa: f64, contraction: f64) -> [f64; 3] {
        let p = pressure_mpa / self.pressure_scale;
        let e = contraction / self.contraction_scale;
        // d(vⁿ)/dv, which is 0 for n = 0 also where v = 0.
        let slope = |v: f64, n: i32| {
            if n == 0 {
                0.0
            } else {
                f64::from(n) * v.powi(n - 1)
            }
        };
        let mut out = [0.0; 3];
        for &(b, c, value) in &self.terms {
            out[0] += value * p.powi(b) * e.powi(c);
            out[1] += value * p.powi(b) * slope(e, c) / self.contraction_scale;
            out[2] += value * slope(p, b) * e.powi(c) / self.pressure_scale;
        }
        out
    }
}

/// Units of X_k1, X_k2, X_k3 for k = 1…6, as the paper lists them.
pub const PAPER_UNITS: [[&str; 3]; 6] = [
    ["mm^-2", "mm^-1", "1"],
    ["mm^-1", "1", "mm"],
    ["1", "mm", "mm^2"],
    ["N mm^-4", "N mm^-3", "N mm^-2"],
    ["N mm^-3", "N mm^-2", "N mm^-1"],
    ["N mm^-2", "N mm^-1", "N"],
];

/// The 48 terms of (11): name as in Table 2 (A11 … C62), unit, value. C_k has two, of D0 and of 1;
/// a D0² part of C, which the paper does not have, is named C10 … C60 and left out where it is
/// zero.
pub fn paper_terms(c: &Coefficients) -> Vec<(String, &'static str, f64)> {
    let mut out = vec![];
    for (letter, block) in [("A", &c.a), ("B", &c.b), ("C", &c.c)] {
        for (k, row) in block.iter().enumerate() {
            for (j, &value) in row.iter().enumerate() {
                let number = if letter == "C" { j } else { j + 1 };
                if letter == "C" && j == 0 && value == 0.0 {
                    continue;
                }
                out.push((
                    format!("{letter}{}{number}", k + 1),
                    PAPER_UNITS[k][j],
                    value,
                ));
            }
        }
    }
    out
}
