//! The decision: what to take, which pressure to set, what it pulls, what is sure, and what limits
//! it.

use super::answer::{CandidateEnds, ChoiceAnswer, ChoiceKind};
use crate::{PressureLimits, Units, number, percent, uncertainty::interval, words::within};
use mckibben_build::relief_mpa;
use mckibben_core::{
    analysis::RELIEF,
    joined,
    muscle::Direction,
    units::{Dimension, rounded, tidy},
};
use mckibben_design::{Candidate, CandidatePoint, Demand, Design, Several, bundle::envelope_ratio};

/// Share of a pull by which that of a muscle that is built is no other one.
const SAME: f64 = 1e-3;

/// What muscles are chosen among, for the lines of the decision.
pub struct Decision<'a> {
    pub found: &'a Design,
    /// What states their length, where it was assumed.
    pub length_by: Option<&'static str>,
    /// What to measure of the first, and the ± that is left.
    pub measure: Option<String>,
}

impl Decision<'_> {
    /// The lines; none where nothing fits. Each begins with its verb.
    pub fn lines(&self) -> Vec<String> {
        let Some(first) = self.found.outcome.candidates.first() else {
            return vec![];
        };
        let measure = self.measure.as_ref().map(|what| format!("Measure {what}"));
        let lines = [
            Some(self.what_to_take(first)),
            Some(pressures_to_set(first)),
            Some(self.pulls(first)),
            Some(self.sure(first)),
            measure,
            Some(limit(first)),
        ];
        lines.into_iter().flatten().collect()
    }

    fn what_to_take(&self, first: &Candidate) -> String {
        let many = many(self.found.spec.count);
        let none = if self.found.is_shared {
            " (no single muscle does it)"
        } else {
            ""
        };
        let length = show(Dimension::Length, first.muscle.length_mm());
        let assumed = self
            .length_by
            .map_or_else(String::new, |by| format!(" (assumed: {by})"));
        let mut take = format!(
            "Take {many}{}, {length} between the terminals{assumed}{none}",
            parts(first)
        );
        if let Some(ends) = CandidateEnds::of(first) {
            take += &format!(
                ", {} ends ({}\u{a0}mm wide, {} g both)",
                ends.ends.name(),
                number(ends.end_diameter_mm, 3),
                number(ends.ends_mass_g, 2)
            );
        }
        if let Demand::Joint(joint) = &self.found.spec.wanted {
            let radius = Units::default().show(Dimension::Length, joint.radius_mm);
            take += &format!(", on a pulley of radius {radius}");
            let width_mm = first.bulged_diameter_mm().unwrap_or(0.0);
            if 4.0 * joint.radius_mm < width_mm + first.muscle.outer_diameter_mm() {
                take += ", on which the two muscles have no room beside each other";
            }
        }
        take
    }

    fn pulls(&self, first: &Candidate) -> String {
        let many = first.points.len() > 1;
        let point = |q: &CandidatePoint| {
            let pressure = show(Dimension::Pressure, q.response.pressure_mpa);
            let wanted = format!(
                "{} at {}{}",
                Units::default().show(Dimension::Force, tidy(q.response.force_n, 4)),
                percent(q.wanted.contraction),
                if many {
                    format!(" and {pressure}")
                } else {
                    String::new()
                }
            );
            let force = &Units::default().force;
            let built = q.built.map(|built| {
                let model = &first.model;
                let [low, high, alone] = [
                    built.predicted_low_n,
                    built.predicted_high_n,
                    q.model_force_n,
                ]
                .map(|n| within(n, built.half_n()));
                if self.found.spec.built {
                    format!(
                        " ({low}\u{a0}N to {high}\u{a0}N, 95 %, as built; {model} alone \
                         {alone}\u{a0}N)"
                    )
                } else if (built.predicted_n / q.response.force_n - 1.0).abs() < SAME {
                    format!(" by {model} ({low}\u{a0}N to {high}\u{a0}N, 95 %)")
                } else {
                    format!(" by {model}; as built {}", interval(&built, force))
                }
            });
            wanted + &built.unwrap_or_default()
        };
        let facts = [
            first
                .bulged_diameter_mm()
                .map(|mm| format!("{}\u{a0}mm wide", number(mm, 3))),
            first.muscle.mass_g().map(|g| format!("{} g", number(g, 3))),
            first
                .largest(|q| q.air_normal_litres)
                .map(|l| format!("{} normal L of air a stroke", number(l, 3))),
            first
                .largest(|q| q.liquid_volume_mm3)
                .map(|mm3| format!("{} mL of liquid", number(1e-3 * mm3, 3))),
        ];
        let spec = &self.found.spec;
        let each = if spec.count > 1 { "each " } else { "" };
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

    fn sure(&self, first: &Candidate) -> String {
        let mpa = |p| show(Dimension::Pressure, p);
        let spec = &self.found.spec;
        let share = percent(spec.guaranteed.unwrap_or(0.95));
        if spec.guaranteed.is_some() {
            return format!("Sure to {share}: the lower end of the ± meets what is required");
        }
        let candidates = self.found.outcome.candidates.iter();
        let sure = candidates.filter_map(|c| Some((spec.count, c, c.sure_pressure_mpa?)));
        let several = self.found.to_be_sure.iter();
        let other = several.map(|s| (s.count, &s.candidate, s.candidate.pressure_mpa));
        match sure.chain(other).next() {
            Some((n, c, p)) if n == spec.count && c.muscle == first.muscle => {
                format!("Sure to {share} at {}", mpa(p))
            }
            Some((count, c, p)) => {
                let sure = choice(ChoiceKind::Sure, count, c);
                let [circle, length] = [sure.envelope_mm.unwrap_or(0.0), sure.length_mm]
                    .map(|mm| show(Dimension::Length, mm));
                let width = if count > 1 {
                    format!("in a circle of {circle}")
                } else {
                    format!("{circle} wide")
                };
                format!(
                    "Sure to {share}: {}{}, {length} long, {width}, at {}",
                    many(count),
                    parts(c),
                    mpa(p)
                )
            }
            None => {
                let none = match spec.wanted {
                    Demand::Joint(_) => "other pulleys not searched",
                    _ => "no muscle of this search",
                };
                format!("Sure to {share}: {none}")
            }
        }
    }

    /// The choices, where there are two or more.
    pub fn choices(&self) -> Vec<ChoiceAnswer> {
        let Design { spec, outcome, .. } = self.found;
        let several = |kind, several: &Option<Several>| {
            let several = several.as_ref()?;
            Some(choice(kind, several.count, &several.candidate))
        };
        let one = |kind, c: Option<&Candidate>| Some(choice(kind, spec.count, c?));
        let other_make = match &outcome.other_make {
            Some(c) if c.is_cast => ChoiceKind::Cast,
            _ => ChoiceKind::Sold,
        };
        let all: Vec<ChoiceAnswer> = [
            one(ChoiceKind::First, outcome.candidates.first()),
            several(ChoiceKind::Bundle, &self.found.slimmest_bundle),
            several(ChoiceKind::Sure, &self.found.to_be_sure),
            one(other_make, outcome.other_make.as_ref()),
        ]
        .into_iter()
        .flatten()
        .collect();
        if all.len() > 1 { all } else { vec![] }
    }
}

/// What a choice is like.
fn choice(kind: ChoiceKind, count: u32, c: &Candidate) -> ChoiceAnswer {
    let many = f64::from(count);
    let point = c.points.first();
    let built = point.and_then(|q| q.built);
    let is = match kind {
        ChoiceKind::First | ChoiceKind::Bundle => "",
        ChoiceKind::Sure => "sure: ",
        ChoiceKind::Sold => "sold: ",
        ChoiceKind::Cast => "cast: ",
    };
    let together = match count {
        1 => "one".to_owned(),
        _ => format!("{count} side by side"),
    };
    ChoiceAnswer {
        kind,
        name: is.to_owned() + &together,
        count,
        parts: short_parts(c),
        length_mm: c.muscle.length_mm(),
        envelope_mm: c.bulged_diameter_mm().map(|mm| envelope_ratio(count) * mm),
        pressure_mpa: c.pressure_mpa,
        force_n: many * point.map_or(0.0, |q| q.response.force_n),
        predicted_low_n: built.map(|built| many * built.predicted_low_n),
        predicted_high_n: built.map(|built| many * built.predicted_high_n),
        air_normal_litres: c.largest(|q| q.air_normal_litres).map(|l| many * l),
        liquid_volume_mm3: c.largest(|q| q.liquid_volume_mm3).map(|v| many * v),
    }
}

/// The names of tube and sleeve, or what there is in their place.
fn short_parts(c: &Candidate) -> String {
    match (&c.tube, &c.muscle.braid().sleeve) {
        (Some(tube), Some(sleeve)) => format!("{tube} in {}", sleeve.name),
        _ => parts(c),
    }
}

/// How many side by side.
fn many(count: u32) -> String {
    if count > 1 {
        format!("{count} muscles side by side, each of ")
    } else {
        String::new()
    }
}

fn show(kind: Dimension, value: f64) -> String {
    Units::default().show(kind, tidy(value, 3))
}

/// The tube and the sleeve.
fn parts(c: &Candidate) -> String {
    let m = &c.muscle;
    let [bore, outer] = [
        m.outer_diameter_mm() - 2.0 * m.wall_mm(),
        m.outer_diameter_mm(),
    ]
    .map(|mm| number(mm, 4));
    let rubber = crate::words::rubber_name(m);
    let name = c
        .tube
        .as_ref()
        .map_or_else(String::new, |name| format!(" ({name})"));
    let sleeve = match &m.braid().sleeve {
        Some(sleeve) => format!("sleeve {}", sleeve.name),
        None => format!("braid at {}°", number(m.braid().angle_deg, 4)),
    };
    format!("tube {bore} × {outer} mm {rubber}{name}, {sleeve}")
}

/// The pressures: to set, of the relief valve, and why no more.
fn pressures_to_set(first: &Candidate) -> String {
    let set_mpa = first.pressure_mpa;
    let highest_mpa = first.highest_pressure_mpa;
    // What is typed as printed is allowed.
    let digits = if tidy(set_mpa, 3) > highest_mpa { 4 } else { 3 };
    let show_mpa = |p: f64| Units::default().show(Dimension::Pressure, p);
    let set = show_mpa(tidy(set_mpa, digits).min(rounded(highest_mpa, 4, f64::floor)));
    let limits = PressureLimits::from(&first.burst);
    let allowed_mpa = limits.allowed_pressure_mpa.unwrap_or(f64::INFINITY);
    let relief = show_mpa(relief_mpa(set_mpa, allowed_mpa));
    let why = first.below.map(|below| {
        let most_mpa = rounded(allowed_mpa.min(RELIEF * highest_mpa), 4, f64::floor);
        format!(
            "; never above {}: {}",
            show_mpa(most_mpa),
            below.describe(&show)
        )
    });
    let test = limits.nominal_burst_pressure_mpa.map(|_| match first.burst.proof_mpa(set_mpa) {
        Some(proof_mpa) => format!(
            "; test with water at {}, length held, before use",
            show_mpa(tidy(proof_mpa, 3))
        ),
        None => "; no proof test fits above it".into(),
    });
    let ends = if limits.ends_included {
        ""
    } else {
        "; what its ends hold is not included"
    };
    let (why, test) = (why.unwrap_or_default(), test.unwrap_or_default());
    format!("Set {set}, relief valve at {relief}{test}{why}{ends}")
}

/// What has least to spare, and what is next.
fn limit(first: &Candidate) -> String {
    let spare = first.spare.iter().take(2).map(|(limit, share)| {
        let share = percent((1e3 * share).floor() / 1e3);
        format!("{}, {share} to spare", limit.name())
    });
    format!("Limit {}", joined(spare, "; next: "))
}
