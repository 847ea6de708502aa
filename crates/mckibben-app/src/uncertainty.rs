//! What a muscle that is built will pull, in words: one text for the terminal, the report and the
//! page.

use crate::{
    Scale, Units,
    words::{part, within},
};
use mckibben_core::{
    analysis::Evaluation,
    answer::Answer,
    built::{Built, Left, UncertaintyParts},
    by_number::SortByNumber,
    joined,
};
use schemars::JsonSchema;
use serde::Serialize;

/// A measurement is worth its work where it leaves less than this share of the ±.
const WORTH: f64 = 0.85;
/// Measurements that a text names.
const NAMED: usize = 3;

/// What a muscle that is built will pull in words, its ± with the parts, and what to measure.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct UncertaintyWords {
    /// What it will pull, and the model's pull with what leads from it to that: `520 N (170 N to
    /// 900 N, 95 %) while it shortens; model: 820 N, mean of both branches: friction −145, take-up
    /// −100, ends −55`.
    pub built: Option<String>,
    /// The ± with its parts:
    /// `± 170 N (95 %): rubber 100, friction 90, ends 50, mesh 1`.
    pub text: Option<String>,
    /// What to measure, and the ± that is left:
    /// `hang the load and set the pressure: ± 62 N (10 min)`.
    pub bench: Option<String>,
    /// What each measurement leaves of the ±, the best first; none of a muscle that was identified.
    pub measurements: Vec<Left>,
    /// Whether its strands may lie in rubber without a word of it.
    #[serde(skip)]
    may_be_hose: bool,
    #[serde(skip)]
    parts: Option<UncertaintyParts>,
    #[serde(skip)]
    pull: Option<Built>,
}

impl UncertaintyWords {
    /// Of an answer of a model.
    pub fn of(answer: &Answer, model: &mut Evaluation<'_>) -> Self {
        Self::at(
            answer.built.zip(answer.uncertainty_parts_n),
            (answer.response.pressure_mpa, answer.response.contraction),
            model,
        )
    }

    /// Of what a muscle that is built pulls at a pressure and a contraction.
    pub fn at(
        predicted: Option<(Built, UncertaintyParts)>,
        (pressure_mpa, contraction): (f64, f64),
        model: &mut Evaluation<'_>,
    ) -> Self {
        let (pull, parts) = predicted.unzip();
        let measurements = if pull.is_some_and(|pull| pull.predicted_n > 0.0) {
            model.measurements(pressure_mpa, contraction)
        } else {
            vec![]
        };
        let braid = model.model.muscle().braid();
        let mut out = Self {
            may_be_hose: !braid.in_rubber && braid.sleeve.is_none(),
            measurements,
            parts,
            pull,
            ..Self::default()
        };
        let u = &Units::default();
        (out.built, out.text, out.bench) = (out.built_in(u), out.text_in(u), out.bench_in(u));
        out
    }

    /// What a muscle that is built pulls, and what lies between the model's pull and that, in units.
    pub fn built_in(&self, u: &Units) -> Option<String> {
        Some(format!(
            "{}; model: {}",
            self.pull_in(u)?,
            self.model_in(u)?
        ))
    }

    /// What a muscle that is built pulls, in units.
    pub fn pull_in(&self, u: &Units) -> Option<String> {
        Some(interval(&self.pull?, &u.force))
    }

    /// The model's pull, and the parts that lead from it to the pull of a muscle that is built, with
    /// a digit more than this has, so that they add up to it.
    pub fn model_in(&self, u: &Units) -> Option<String> {
        let pull = self.pull?;
        let force = &u.force;
        let a_digit_more = 0.1 * force.value(pull.half_n());
        let show = |n: f64| within(force.value(n), a_digit_more);
        let shift = pull.predicted_shift_n;
        let friction = if self.may_be_hose {
            "friction (strands in rubber: `braid.in_rubber`)"
        } else {
            "friction"
        };
        let shifts = [
            (friction, shift.friction),
            ("take-up", shift.take_up),
            ("ends", shift.ends),
            ("factor", shift.factor),
        ]
        .map(|(name, n)| (name, n, show(n.abs())));
        let counts = |text: &str| text.chars().any(|c| ('1'..='9').contains(&c));
        let shifts = shifts
            .into_iter()
            .filter(|(.., text)| counts(text))
            .map(|(name, n, text)| {
                let sign = if n < 0.0 { "−" } else { "+" };
                format!("{name} {sign}{text}")
            });
        let shifts = joined(shifts, ", ");
        let colon = if shifts.is_empty() { "" } else { ": " };
        Some(format!(
            "{}\u{a0}{}, mean of both branches{colon}{shifts}",
            show(pull.mean_n),
            force.name
        ))
    }

    /// The ± with its parts, in units.
    pub fn text_in(&self, u: &Units) -> Option<String> {
        self.parts.map(|parts| breakdown(&parts, &u.force))
    }

    /// What to measure, in units; none where nothing helps much.
    pub fn bench_in(&self, u: &Units) -> Option<String> {
        let each = self.worth().take(NAMED).map(|left| {
            let half = u.force.half_width(left.uncertainty_n);
            let (what, minutes) = left.measurement.words();
            format!(
                "{what}: ± {half}\u{a0}{} ({minutes}\u{a0}min)",
                u.force.name
            )
        });
        Some(joined(each, "; ")).filter(|text| !text.is_empty())
    }

    /// Measurements that leave less than most of the ±.
    pub fn worth(&self) -> impl Iterator<Item = &Left> {
        let now_n = self.parts.map_or(0.0, |parts| parts.total());
        self.measurements
            .iter()
            .filter(move |left: &&Left| left.uncertainty_n < WORTH * now_n)
    }
}

/// A median with its interval and branch: `520 N (170 N to 900 N, 95 %) while it shortens`.
pub fn interval(pull: &Built, scale: &Scale) -> String {
    bounds(
        [
            pull.predicted_n,
            pull.predicted_low_n,
            pull.predicted_high_n,
        ],
        scale,
    ) + &pull.way()
}

/// A median and the two ends of its interval.
pub fn bounds([median, low, high]: [f64; 3], scale: &Scale) -> String {
    let half = scale.value(0.5 * (high - low));
    let [median, low, high] = [median, low, high].map(|v| within(scale.value(v), half));
    let unit = &scale.name;
    format!("{median}\u{a0}{unit} ({low}\u{a0}{unit} to {high}\u{a0}{unit}, 95 %)")
}

/// A ± with its parts, the largest first:
/// `± 170 N (95 %): rubber 100, friction 90, mesh 1`.
pub fn breakdown(parts: &UncertaintyParts, scale: &Scale) -> String {
    let whole = parts.total();
    let mut named = Vec::from_iter(parts.named());
    named.sort_by_number(|a| -a.1);
    let each = named
        .into_iter()
        .map(|(name, v)| (name, part(scale.value(v), scale.value(whole))));
    // What rounds to nothing is not listed.
    let each = each
        .filter(|(_, text)| text.chars().any(|c| ('1'..='9').contains(&c)))
        .map(|(name, text)| format!("{name} {text}"));
    let each = joined(each, ", ");
    let head = format!("± {} {} (95 %)", scale.half_width(whole), scale.name);
    if each.is_empty() {
        head
    } else {
        format!("{head}: {each}")
    }
}
