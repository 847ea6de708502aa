//! A universal formula as a file: the terms of the end deficit, the dimensionless range, the
//! errors, the origin.

mod range;

pub use range::UniversalRange;

use super::{
    Provenance, Term,
    file::{File, check::share},
    show::display,
    terms::name,
};
use serde::{Deserialize, Serialize};
use std::sync::{Arc, LazyLock};

/// Errors over points where the muscle pulls, as shares of the muscle's blocked force at the same
/// pressure.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(expecting = "an object")]
pub struct UniversalSummary {
    /// How many points.
    pub points: usize,
    /// Of how many muscles.
    pub muscles: usize,
    /// Root mean square.
    #[serde(rename = "rms_of_blocked", deserialize_with = "share")]
    pub rms: f64,
    /// The share that 95 % of the points do not exceed.
    #[serde(rename = "p95_of_blocked", deserialize_with = "share")]
    pub p95: f64,
    /// The share that 99 % of the points do not exceed.
    #[serde(rename = "p99_of_blocked", deserialize_with = "share")]
    pub p99: f64,
    /// Largest.
    #[serde(rename = "max_of_blocked", deserialize_with = "share")]
    pub max: f64,
}

/// How wrong a universal formula is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(expecting = "an object")]
pub struct UniversalErrors {
    /// Against what, in words.
    pub against: String,
    /// Over all points it was fitted to.
    pub fit: UniversalSummary,
    /// Left out, a fifth of the muscles at a time: the same points, each predicted by a fit to the
    /// muscles of the other folds.
    pub left_out: UniversalSummary,
}

impl UniversalErrors {
    /// The half-width that 95 % of the points stay within.
    pub fn half_width(&self) -> f64 {
        self.fit.p95.max(self.left_out.p95)
    }
}

/// One term, in the variables S, A, N, M and E: of second degree at most.
pub type UniversalTerm = Term<5>;

/// A universal formula with all that is known of it; it is written as its file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(into = "File")]
pub struct UniversalFormula {
    /// Its name, which answers carry.
    pub name: String,
    /// What it says of the ends: the correction of a membrane for the wall; none, the membrane
    /// alone.
    pub terms: Vec<UniversalTerm>,
    /// Where it was fitted.
    pub range: UniversalRange,
    /// How wrong it is.
    pub errors: UniversalErrors,
    /// Where it comes from.
    pub provenance: Provenance,
}

static LARGE: LazyLock<Option<Arc<UniversalFormula>>> = LazyLock::new(|| {
    UniversalFormula::built_in(include_str!("../../../data/universal.json"))
        .ok()
        .map(Arc::new)
});

impl UniversalFormula {
    /// The built-in formula; `None` only if its file were damaged, which a test excludes.
    pub fn large() -> Option<Arc<Self>> {
        LARGE.clone()
    }

    /// A term in letters: `S N^2`.
    pub fn term_name(&self, term: &UniversalTerm) -> String {
        name(term.powers, &["S", "A", "N", "M", "E"], |n| format!("^{n}"))
    }

    /// The equation in one line.
    pub fn equation(&self) -> String {
        let deficit = "delta_membrane + Ro (l_s0 - l) S/sqrt(t) sum(value S^a A^b N^c M^d E^e); \
            S = s/Ro, A = 4 sin^2(theta0), N = sin(phi0), t = T0/(2 pi Ro s mu), M = 1/(1 + t), \
            E = x/sqrt(1 + x^2), x = 10 (strand stretch - 1)";
        format!(
            "F = F_endless(l, P), contraction = 1 - l - 2 delta/L0; delta = {deficit} (l, r: \
             stretch and outer radius of the middle)"
        )
    }

    /// The equation with its numbers as LaTeX: a display of its own, with amsmath.
    pub fn to_latex(&self) -> String {
        let sum: Vec<String> = self
            .terms
            .iter()
            .map(|t| {
                format!(
                    "{:+.6} {}",
                    t.value,
                    self.term_name(t).replace("1", "").replace(' ', "\\,")
                )
            })
            .collect();
        let sum: Vec<String> = sum.chunks(4).map(|terms| terms.join(" ")).collect();
        let sum = sum.join("\\\\\n&\\quad ");
        let first = "\\delta &= \\int_{R_o}^{r} \\frac{\\lambda_s\\cos\\varphi \
             - \\lambda}{\\lambda_s\\sin\\varphi}\\,\\mathrm{d}r + R_o(\\lambda_{s0} \
             - \\lambda)\\frac{S}{\\sqrt{t}}";
        let rest = "S &= s/R_o,\\quad A = 4\\sin^2\\theta_0,\\quad N = \\sin\\varphi_0,\\quad M = \
             1/(1+t)";
        let start = "F &= F_\\infty(\\lambda, P),\\quad \\varepsilon = 1 - \\lambda - 2\\delta/L_0";
        display(vec![
            start.into(),
            format!("{first}\\bigl({sum}\\bigr)"),
            rest.into(),
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_in_formula_is_read_and_written_to_the_same_text() {
        let text = include_str!("../../../data/universal.json");
        assert_eq!(UniversalFormula::large().unwrap().to_json(), text);
    }

    #[test]
    fn damage_is_named() {
        let text = include_str!("../../../data/universal.json");
        for (from, to, says) in [
            ("\"membrane\"", "\"shell\"", "form"),
            ("\"wall_ratio\"", "\"wall\"", "range.wall_ratio"),
            ("\"left_out\"", "\"leftout\"", "errors.left_out"),
        ] {
            assert!(text.contains(from), "{from}");
            let error = crate::formula::Document::parse(&text.replace(from, to))
                .unwrap_err()
                .to_string();
            assert!(error.contains(says), "{error}");
        }
    }
}
