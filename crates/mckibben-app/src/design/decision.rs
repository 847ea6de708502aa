//! The decision: what to take and with which chance, which pressure to set, what it pulls, what to
//! measure, and what limits it.

use super::{
    answer::{CandidateAnswer, ChoiceAnswer},
    plain,
    spec::Search,
};
use crate::{PressureLimits, UncertaintyWords, number, percent, words::within};
use mckibben_build::relief_mpa;
use mckibben_core::{
    joined,
    muscle::Direction,
    units::{Dimension, rounded, tidy},
};
use mckibben_design::{
    Candidate, CandidatePoint, Choice, ChoiceKind, Outcome, Spec, normal_deviations, normal_share,
    why_no_more,
};

/// A chance as people say it, never more than it is: `9 in 10`.
pub fn in_words(chance: f64) -> String {
    let of = |n: f64| (n * chance + 1e-6).floor();
    match chance {
        _ if chance >= 0.995 => "more than 99 in 100".into(),
        _ if chance >= 0.95 => format!("{} in 100", of(100.0)),
        _ if chance >= 0.1 => format!("{} in 10", of(10.0)),
        _ => "less than 1 in 10".into(),
    }
}

impl Search<'_> {
    /// The decision in lines, each of which begins with its verb; where nothing fits what has the
    /// best chance. `words` are the ± of the first.
    pub fn decision(&self, found: &Outcome, words: Option<&UncertaintyWords>) -> Vec<String> {
        let Some(first) = found.candidates.first() else {
            return self.best_chances(found).into_iter().collect();
        };
        let mut lines = vec![
            self.what_to_take(first),
            pressures_to_set(first),
            never_above(first),
            self.pulls(first),
        ];
        lines.extend(words.and_then(|words| measure(first, words)));
        lines.push(limit(first));
        lines
    }

    /// That nothing reaches the certainty, and what comes closest to it.
    fn best_chances(&self, found: &Outcome) -> Option<String> {
        let certainty = in_words(self.spec.certainty?);
        let best = |Choice { candidate: c, .. }: &Choice| {
            let chance = in_words(c.chance.unwrap_or_default());
            format!("{}{}: {chance}", many(c.count), parts(c))
        };
        let best = joined(found.choices.iter().map(best), "; ");
        (!best.is_empty()).then(|| format!("None reaches {certainty}; at best {best}"))
    }

    fn what_to_take(&self, first: &Candidate) -> String {
        let length = show(Dimension::Length, first.muscle.length_mm());
        let assumed = match self.is_length_assumed() {
            true => " (assumed: `length_mm` or `stroke_mm`)",
            false => "",
        };
        let mut take = format!(
            "Take {}{}, {length} between the terminals{assumed}",
            many(first.count),
            parts(first)
        );
        if let Some(ends) = first.ends {
            take += &format!(
                ", {} ends ({}\u{a0}mm wide, {} g both)",
                ends.made,
                number(ends.width_mm, 3),
                number(ends.mass_g, 2)
            );
        }
        if self.spec.wanted.joint().is_some() {
            let radius = plain(Dimension::Length, first.radius_mm);
            take += &format!(", on a pulley of radius {radius}");
            if 4.0 * first.radius_mm < first.width_mm + first.muscle.outer_diameter_mm() {
                take += ", on which the two muscles have no room beside each other";
            }
        }
        let highest = show(Dimension::Pressure, first.highest_pressure_mpa);
        match first.chance {
            Some(chance) => {
                take + &format!(
                    "; {} that this pulls {} with at most {highest}",
                    in_words(chance),
                    self.required(first)
                )
            }
            None => take + "; chance unknown",
        }
    }

    /// What is required of all of them.
    fn required(&self, first: &Candidate) -> String {
        let point = |q: &CandidatePoint| {
            let force = pull(f64::from(first.count) * q.required_n);
            format!("{force} at {}", percent(q.response.contraction))
        };
        joined(first.points.iter().map(point), " and ")
    }

    fn pulls(&self, first: &Candidate) -> String {
        let spec = &self.spec;
        let point = |q: &CandidatePoint| {
            let built = q.built.filter(|_| spec.built);
            let pull_n = built.map_or(q.response.force_n, |built| built.predicted_n);
            let wanted = format!(
                "{} at {} and {}",
                pull(pull_n),
                percent(q.response.contraction),
                show(Dimension::Pressure, q.response.pressure_mpa)
            );
            let by = match spec.built {
                true => String::new(),
                false => format!(" by {}", first.model),
            };
            let built = q.built.map(|built| {
                let [low, high, median] = [
                    built.predicted_low_n,
                    built.predicted_high_n,
                    built.predicted_n,
                ]
                .map(|n| within(n, built.half_n()));
                let median = match spec.built {
                    true => String::new(),
                    false => format!("; as built {median}\u{a0}N"),
                };
                format!("{median} ({low}\u{a0}N to {high}\u{a0}N, 95 %)")
            });
            wanted + &by + &built.unwrap_or_default()
        };
        let facts = [
            Some(format!("{}\u{a0}mm wide", number(first.width_mm, 3))),
            first.muscle.mass_g().map(|g| format!("{} g", number(g, 3))),
            first
                .largest(|q| q.air_normal_litres)
                .map(|l| format!("{} normal L of air a stroke", number(l, 3))),
            first
                .largest(|q| q.liquid_volume_mm3)
                .map(|mm3| format!("{} mL of liquid", number(1e-3 * mm3, 3))),
        ];
        let each = if first.count > 1 { "each " } else { "" };
        let way = match spec.options().direction {
            Direction::Mean if !spec.built => "",
            Direction::Elongation if !spec.built => " while it lengthens",
            _ => " while it shortens",
        };
        format!(
            "Pulls {each}{}{way}; {}",
            joined(first.points.iter().map(point), ", "),
            joined(facts.into_iter().flatten(), ", ")
        )
    }
}

/// What to measure, and what the chance becomes where it measures as expected.
fn measure(first: &Candidate, words: &UncertaintyWords) -> Option<String> {
    let bench = words.bench.as_ref()?;
    let half_n = first.largest(|q| q.uncertainty_n);
    let left = words.worth().next();
    let then = left.zip(half_n).zip(first.chance);
    let then = then.map(|((left, half_n), chance)| {
        let z = normal_deviations(chance) * half_n / left.uncertainty_n;
        let chance = in_words(normal_share(z));
        format!("; where it is as expected, {chance} then")
    });
    Some(format!("Measure {bench}{}", then.unwrap_or_default()))
}

impl ChoiceAnswer {
    /// A choice with its chance and the words for it.
    pub fn new(Choice { kind, candidate: c }: &Choice, spec: &Spec) -> Self {
        let is = match kind {
            ChoiceKind::Take => "take: ",
            ChoiceKind::Sold => "sold: ",
            ChoiceKind::Cast => "cast: ",
            ChoiceKind::Product => "as sold: ",
            _ => "",
        };
        let together = match c.count {
            1 => "one".to_owned(),
            count => format!("{count} side by side"),
        };
        let chance = c.chance.map_or("chance unknown".into(), in_words);
        Self {
            kind: *kind,
            name: format!("{is}{chance}, {together}"),
            parts: short_parts(c),
            envelope_mm: c.envelope_mm(),
            candidate: CandidateAnswer::new(c, spec),
        }
    }
}

/// The names of tube and sleeve, or what there is in their place.
fn short_parts(c: &Candidate) -> String {
    match (&c.product, &c.tube, &c.muscle.braid().sleeve) {
        (Some(product), ..) => product.clone(),
        (_, Some(tube), Some(sleeve)) => format!("{tube} in {}", sleeve.name),
        _ => parts(c),
    }
}

/// How many side by side.
fn many(count: u32) -> String {
    match count {
        1 => String::new(),
        _ => format!("{count} muscles side by side, each of "),
    }
}

/// A pull in N with four digits.
fn pull(force_n: f64) -> String {
    plain(Dimension::Force, tidy(force_n, 4))
}

fn show(kind: Dimension, value: f64) -> String {
    plain(kind, tidy(value, 3))
}

/// The tube and the sleeve.
fn parts(c: &Candidate) -> String {
    let m = &c.muscle;
    let outer_mm = m.outer_diameter_mm();
    let [bore, outer] = [outer_mm - 2.0 * m.wall_mm(), outer_mm].map(|mm| number(mm, 4));
    let rubber = crate::words::rubber_name(m);
    let name = c.tube.as_ref().map(|name| format!(" ({name})"));
    let sleeve = match &m.braid().sleeve {
        Some(sleeve) => format!("sleeve {}", sleeve.name),
        None => format!("braid at {}°", number(m.braid().angle_deg, 4)),
    };
    format!(
        "tube {bore} × {outer} mm {rubber}{}, {sleeve}",
        name.unwrap_or_default()
    )
}

/// The pressure to begin with, between which nine of ten end, and that of the relief valve.
fn pressures_to_set(first: &Candidate) -> String {
    let highest_mpa = first.highest_pressure_mpa;
    let set_mpa = first.pressure_mpa;
    // What is typed as printed is allowed.
    let digits = if tidy(set_mpa, 3) > highest_mpa { 4 } else { 3 };
    let show_mpa = |p: f64| plain(Dimension::Pressure, p);
    let set = show_mpa(tidy(set_mpa, digits).min(rounded(highest_mpa, 4, f64::floor)));
    let ends = first.pressure_low_mpa.zip(first.pressure_high_mpa);
    let ends = ends.map(|(low, high)| {
        let [low, high] = [low, high].map(|p| show(Dimension::Pressure, p));
        format!(
            "; nine of ten end between {low} and {high}: hang the load, raise it until it lifts"
        )
    });
    format!(
        "Set {set} to begin with{}; relief valve at {}",
        ends.unwrap_or_default(),
        relief(first)
    )
}

/// The highest pressure to set: 19 of 20 that do the job need less.
fn used_mpa(first: &Candidate) -> f64 {
    first
        .pressure_high_mpa
        .unwrap_or_default()
        .max(first.pressure_mpa)
}

/// Where the relief valve opens.
fn relief(first: &Candidate) -> String {
    let allowed_mpa = PressureLimits::from(&first.burst).allowed_pressure_mpa;
    let relief_mpa = relief_mpa(used_mpa(first), allowed_mpa.unwrap_or(f64::INFINITY));
    plain(Dimension::Pressure, relief_mpa)
}

/// The limit in use, where the relief valve opens, and apart from it the proof test.
fn never_above(first: &Candidate) -> String {
    let below = first
        .below
        .filter(|_| used_mpa(first) >= first.highest_pressure_mpa)
        .map(|below| format!(": {}", why_no_more(&below, &show)));
    let test = match first.proof_pressure_mpa {
        Some(proof_mpa) => {
            let proof = show(Dimension::Pressure, proof_mpa);
            format!("Proof test once: {proof}, water, stretched")
        }
        None => "No proof test fits above it".into(),
    };
    let ends = if PressureLimits::from(&first.burst).ends_included {
        ""
    } else {
        ". What its ends hold is not included"
    };
    let below = below.unwrap_or_default();
    format!("Never above {} in use{below}. {test}{ends}", relief(first))
}

/// What has least to spare, and what is next.
fn limit(first: &Candidate) -> String {
    let spare = first.spare.iter().take(2).map(|check| {
        let share = percent((-1e3 * check.excess()).floor() / 1e3);
        let at = show(Dimension::Pressure, check.pressure_mpa);
        format!("{} at {at}, {share} to spare", check.limit.name())
    });
    format!("Limit {}", joined(spare, "; next: "))
}
