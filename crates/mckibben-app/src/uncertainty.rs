//! The ± in words: one text for the terminal, the report and the page.

use crate::{Scale, Units, words::part};
use mckibben_core::{analysis::Evaluation, answer::Answer, uncertainty::UncertaintyParts};
use schemars::JsonSchema;
use serde::Serialize;

/// Points of the suggested test.
const BENCH_POINTS: usize = 10;
/// Its lower pressure over the higher one, about.
const LOWER_PRESSURE: f64 = 0.4;
/// A bench is worth its work where it leaves less than this share of the ±.
const WORTH: f64 = 0.8;

/// The ± of a pull in words, and the suggested test that would make it smaller.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct UncertaintyWords {
    /// The ± with its parts:
    /// `± 170 N (95 %): friction unknown 160, model against tests 50, mesh 1`.
    pub text: Option<String>,
    /// 95 % half-width of the pull after `identify` from the suggested test, N; none where the
    /// muscle was measured, or where this helps little.
    #[serde(skip)]
    pub bench_uncertainty_n: Option<f64>,
    /// That bench:
    /// `10 points on both branches at 0.1 MPa and 0.3 MPa would reduce the ± to about 30 N`.
    pub bench: Option<String>,
    /// What a selected branch would make of it, where the friction is not known:
    /// `a branch, shortening or lengthening, would reduce the ± to about 70 N`.
    pub branch: Option<String>,
    /// That ± while the muscle shortens, N.
    #[serde(skip)]
    pub branch_uncertainty_n: Option<f64>,
    #[serde(skip)]
    parts: Option<UncertaintyParts>,
    #[serde(skip)]
    pressure_mpa: f64,
}

impl UncertaintyWords {
    /// Of the ± of a pull at a pressure by a model.
    pub(crate) fn at(
        parts: Option<UncertaintyParts>,
        model: &mut Evaluation<'_>,
        pressure_mpa: f64,
    ) -> Self {
        // The ± after the suggested test, where the muscle was not measured and it helps. Of one
        // whose constants come from another specimen or length it is not known.
        let left = parts
            .filter(|p| p.fit.is_none() && p.transfer.is_none() && p.length_transfer.is_none())
            .and_then(|parts| {
                model
                    .identified_n(pressure_mpa)
                    .filter(|left| *left > 0.0 && *left < WORTH * parts.total())
            });
        let mut out = Self {
            bench_uncertainty_n: left,
            parts,
            pressure_mpa,
            ..Self::default()
        };
        (out.text, out.bench) = (
            out.text_in(&Units::default()),
            out.bench_in(&Units::default()),
        );
        out
    }

    /// With what a branch would make of the ± of an answer.
    pub(crate) fn with_branch(mut self, answer: &Answer, model: &mut Evaluation<'_>) -> Self {
        let whole = answer.uncertainty_n.unwrap_or(0.0);
        self.branch_uncertainty_n = model
            .on_branch_n(answer)
            .filter(|half| *half < WORTH * whole);
        self.branch = self.branch_in(&Units::default());
        self
    }

    /// What a selected branch would make of it, in units.
    pub fn branch_in(&self, u: &Units) -> Option<String> {
        let half = u.force.half_width(self.branch_uncertainty_n?);
        let force = &u.force.name;
        Some(format!(
            "a branch, shortening or lengthening, would reduce the ± to about {half}\u{a0}{force}"
        ))
    }

    /// The ± with its parts, in units.
    pub fn text_in(&self, u: &Units) -> Option<String> {
        self.parts.map(|parts| breakdown(&parts, &u.force))
    }

    /// The suggested test, in units.
    pub fn bench_in(&self, u: &Units) -> Option<String> {
        bench(self.bench_uncertainty_n?, self.pressure_mpa, u)
    }
}

/// A ± with its parts, the largest first:
/// `± 170 N (95 %): friction unknown 160, model against tests 50, mesh 1`.
pub fn breakdown(parts: &UncertaintyParts, scale: &Scale) -> String {
    let whole = parts.total();
    let mut named: Vec<(&str, f64)> = parts.named().collect();
    named.sort_by(|a, b| b.1.total_cmp(&a.1));
    let each = named
        .into_iter()
        .map(|(name, v)| (name, part(scale.value(v), scale.value(whole))));
    // What rounds to nothing is not listed.
    let each: Vec<String> = each
        .filter(|(_, text)| text.chars().any(|c| ('1'..='9').contains(&c)))
        .map(|(name, text)| format!("{name} {text}"))
        .collect();
    let head = format!("± {} {} (95 %)", scale.half_width(whole), scale.name);
    if each.is_empty() {
        head
    } else {
        format!("{head}: {}", each.join(", "))
    }
}

/// The suggested test for a ± of `left_n` about a pressure; `None` without pressure.
pub fn bench(left_n: f64, pressure_mpa: f64, u: &Units) -> Option<String> {
    let high = u.pressure.value(pressure_mpa);
    if !(high > 0.0 && high.is_finite()) {
        return None;
    }
    let unit = 10f64.powi((LOWER_PRESSURE * high).log10().floor() as i32);
    let low = (LOWER_PRESSURE * high / unit).round() * unit;
    let low = crate::words::number(low, 1);
    let high = u.pressure.to(pressure_mpa, 3);
    let left = u.force.half_width(left_n);
    let pressure = &u.pressure.name;
    let force = &u.force.name;
    Some(format!(
        "{BENCH_POINTS} points on both branches at {low}\u{a0}{pressure} and \
         {high}\u{a0}{pressure} would reduce the ± to about {left}\u{a0}{force}"
    ))
}
