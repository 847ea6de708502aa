//! A design for people.

use crate::output::text::{
    PressureUnit, braid_name, number, or_dash, percent, plus_minus, rubber_name, table,
};
use mckibben::design::{Candidate, Closest, Limit, OperatingPoint, Outcome, Rejected, Relaxation};
use mckibben::muscle::{BraidStiffness, Muscle};
use mckibben_app::{DesignAnswer, SpreadAnswer};

/// The design for people.
pub fn of(answer: &DesignAnswer, p: PressureUnit) -> String {
    let (spec, outcome) = (&answer.spec, &answer.outcome);
    let one = |q: &OperatingPoint| format!("{} N at {}", number(q.force_n, 5), percent(q.contraction));
    let wanted: Vec<String> = spec.points.iter().map(one).collect();
    let mut out = format!("Wanted: {} with at most {}\n", wanted.join(", "), p.show(spec.max_pressure_mpa));
    let with = if answer.searched_with == answer.model {
        String::new()
    } else {
        format!(", searched with {}", answer.searched_with)
    };
    let length = match &spec.length_mm {
        None => format!("L0 {} mm, ", number(spec.base.length_mm(), 5)),
        Some(_) => String::new(),
    };
    let (looked_at, fit) = (answer.looked_at, answer.fitting);
    out.push_str(&format!(
        "Model {}{with}; {looked_at} muscles looked at, {fit} fit; {length}braid {}\n\n",
        answer.model,
        braid_of(&spec.base)
    ));
    if let Some(closest) = &outcome.closest {
        out.push_str(&nothing_fits(closest, p));
        if let Some(hint) = answer.closest.as_ref().and_then(|c| c.hint.as_ref()) {
            out.push_str(&format!("{hint}\n"));
        }
    } else {
        out.push_str(&candidates(outcome, p));
        out.push_str(&verified(answer, p));
        out.push_str(&spread_text(&answer.tolerance, p));
    }
    if !outcome.rejected.is_empty() && outcome.closest.is_none() {
        out.push_str("\nJust missed\n");
    } else if outcome.rejected.len() > 1 {
        out.push_str("\nNext closest\n");
    }
    let skip = usize::from(outcome.closest.is_some());
    for r in outcome.rejected.iter().skip(skip) {
        let by = r.reason.misses_by().filter(|share| *share < 1.0);
        let by = by.map_or_else(String::new, |share| format!(" ({} short)", percent(thousandth(share))));
        out.push_str(&format!("  {}: {}{by}\n", measures(r), r.reason.describe(|v| p.show(v))));
    }
    out
}

/// The braid that is searched with; its stiffness may differ from muscle to muscle.
fn braid_of(base: &Muscle) -> String {
    match (base.braid().stiffness, base.braid().strands) {
        (BraidStiffness::OfStrands, Some(strands)) => format!("of {} strands", strands.count),
        _ => braid_name(base),
    }
}

fn thousandth(share: f64) -> f64 {
    (1e3 * share).ceil() / 1e3
}

/// What keeps the best from being better.
fn binds(best: &Candidate) -> String {
    let Some(limit) = best.binds else { return String::new() };
    let what = match limit {
        Limit::Force => "the pull that is wanted",
        Limit::BulgedDiameter => "the largest bulged diameter",
        Limit::MaxStretch => "the largest stretch of its rubber",
        Limit::StrandStrain => "the largest strain of its strands",
        Limit::BurstMargin => "the burst pressure",
    };
    format!("What binds for the first: {what}.\n")
}

fn measures(r: &Rejected) -> String {
    format!("D0 {}, s {}", number(r.outer_diameter_mm, 4), number(r.wall_mm, 3))
}

fn candidates(outcome: &Outcome, p: PressureUnit) -> String {
    let list = &outcome.candidates;
    let unit = p.name();
    let needs = format!("needs [{unit}]");
    let several_rubbers = list.windows(2).any(|w| w[0].muscle.tube().rubber != w[1].muscle.tube().rubber);
    let several_lengths = list.windows(2).any(|w| w[0].muscle.length_mm() != w[1].muscle.length_mm());
    let stiffness = |c: &Candidate| c.muscle.family_stiffness_n_per_mm();
    let several_braids = list.windows(2).any(|w| stiffness(&w[0]) != stiffness(&w[1]));
    let strands = list.iter().any(|c| c.largest(|q| q.response.strand_tension_n).is_some());
    let burst = list.iter().any(|c| c.burst_pressure_mpa.is_some());
    let burst_title = format!("bursts [{unit}]");
    let mut header = vec!["", "D0 [mm]", "s [mm]", "θ0 [°]"];
    if several_lengths {
        header.push("L0 [mm]");
    }
    if several_braids {
        header.push("k [N/mm]");
    }
    header.extend([
        needs.as_str(),
        "to spare",
        "F blocked [N]",
        "ε free",
        "bulges to [mm]",
        "stiffness [N/mm]",
        "air [nL]",
        if strands { "strand [N]" } else { "braid [N]" },
        "±",
    ]);
    if burst {
        header.push(&burst_title);
    }
    if several_rubbers {
        header.push("rubber");
    }
    let rows = list
        .iter()
        .enumerate()
        .map(|(i, c)| {
            let needs: Vec<String> = c.points.iter().map(|q| number(p.value(q.pressure_mpa), 3)).collect();
            let tension = if strands {
                c.largest(|q| q.response.strand_tension_n)
            } else {
                c.largest(|q| q.response.braid_tension_n)
            };
            let mut row = vec![
                format!("{}.", i + 1),
                number(c.muscle.outer_diameter_mm(), 4),
                number(c.muscle.wall_mm(), 3),
                number(c.muscle.braid().angle_deg, 4),
            ];
            if several_lengths {
                row.push(number(c.muscle.length_mm(), 4));
            }
            if several_braids {
                row.push(or_dash(stiffness(c), |k| number(k, 3)));
            }
            row.extend([
                needs.join(", "),
                percent((1000.0 * c.margin).floor() / 1000.0),
                number(c.blocked_force_n, 4),
                or_dash(c.free_contraction, |v| percent((1000.0 * v).round() / 1000.0)),
                or_dash(c.bulged_diameter_mm(), |v| number(v, 3)),
                or_dash(c.points.first().and_then(|q| q.response.stiffness_n_per_mm), |v| number(v, 3)),
                or_dash(c.air_normal_litres(), |v| number(v, 3)),
                or_dash(tension, |v| number(v, 3)),
                plus_minus(c.largest(|q| q.uncertainty_n)).replace("± ", ""),
            ]);
            if burst {
                row.push(or_dash(c.burst_pressure_mpa, |v| number(p.value(v), 3)));
            }
            if several_rubbers {
                row.push(rubber_name(&c.muscle));
            }
            row
        })
        .collect();
    let mut out = table(&header, rows);
    let braid =
        if strands { "strand: tension of one strand" } else { "braid: tension of all strands together" };
    let k = if several_braids { "k: stiffness of one strand family. " } else { "" };
    out.push_str(&format!(
        "\nto spare: pull above what is wanted, at the maximum pressure. air: normal litres from rest to the point.\n{k}{braid}.\n±: 95 % half-width of the pull at the point, against a measured muscle.\n"
    ));
    out.push_str(&list.first().map_or_else(String::new, binds));
    out.push_str(&list.first().map_or_else(String::new, doubt));
    if let Some(first) = list.first().filter(|c| !c.from_thick_wall.is_empty()) {
        out.push_str(&format!("From the thick-wall model: {}.\n", first.from_thick_wall.join(", ")));
    }
    out
}

/// Where the model's error is larger than what is to spare, how to ask for a muscle that is sure to pull enough.
fn doubt(best: &Candidate) -> String {
    let tight = best.points.iter().find_map(|q| {
        let error = q.uncertainty_n?;
        (q.available_n - q.wanted.force_n < error).then_some((q.wanted.force_n, error))
    });
    tight.map_or_else(String::new, |(force, error)| {
        let (ask, force, error) = ((force + error).ceil(), number(force, 5), number(error, 2));
        format!(
            "The first has less to spare than the ± of {error} N: to be sure of {force} N, ask for {ask} N.\n"
        )
    })
}

/// What finite elements say of the first candidate.
fn verified(answer: &DesignAnswer, p: PressureUnit) -> String {
    let (Some(verified), Some(winner)) = (&answer.verification, answer.candidates.first()) else {
        return String::new();
    };
    let holds = if verified.holds { "holds" } else { "does NOT hold" };
    let mut out = format!("\nBy finite elements the first {holds}\n");
    for (c, q) in verified.points.iter().zip(&winner.points) {
        let (at, max) = (percent(c.contraction), p.show(answer.max_pressure_mpa));
        let line = match (c.force_at_max_pressure_n, &c.cause) {
            (Some(f), _) => {
                let difference = f - q.force_at_max_pressure_n;
                let sign = if difference < 0.0 { "less" } else { "more" };
                let needs = c
                    .pressure_mpa
                    .map_or_else(String::new, |v| format!("; {} N take {}", number(c.force_n, 5), p.show(v)));
                format!(
                    "{} N at {at} and {max}, {} N {sign}{needs}",
                    number(f, 4),
                    number(difference.abs(), 3)
                )
            }
            (None, cause) => format!("no answer at {at}: {}", cause.as_deref().unwrap_or("unknown")),
        };
        out.push_str(&format!("  {line}\n"));
    }
    out
}

fn spread_text(spreads: &[SpreadAnswer], p: PressureUnit) -> String {
    let line = |s: &SpreadAnswer| {
        format!(
            "  {} N at {} and {}: {} to {} N in the worst corners, likely ± {} N\n",
            number(s.force_n, 5),
            percent(s.contraction),
            p.show(s.pressure_mpa),
            number(s.low_n, 4),
            number(s.high_n, 4),
            number(s.likely_n, 2)
        )
    };
    if spreads.is_empty() {
        return String::new();
    }
    format!("\nTolerances of the first candidate\n{}", spreads.iter().map(line).collect::<String>())
}

fn nothing_fits(closest: &Closest, p: PressureUnit) -> String {
    let mut out = format!(
        "Nothing fits. Closest: {}: {}\n",
        measures(&closest.rejected),
        closest.rejected.reason.describe(|v| p.show(v))
    );
    if closest.relaxations.is_empty() {
        out.push_str("No single limit makes it fit.\n");
        return out;
    }
    out.push_str("It fits with any one of these:\n");
    for relaxation in &closest.relaxations {
        let line = match relaxation {
            Relaxation::Pressure { pressure_mpa, extrapolated } => {
                let far = if *extrapolated { " (extrapolated: outside of the model's range)" } else { "" };
                format!("a maximum pressure of {}{far}", p.show(*pressure_mpa))
            }
            Relaxation::Force(points) => {
                let each = |q: &OperatingPoint| {
                    format!("{} N wanted at {}", q.force_n.floor(), percent(q.contraction))
                };
                points.iter().map(each).collect::<Vec<_>>().join(" and ")
            }
            Relaxation::Contraction(points) => {
                let floor = |v: f64| percent((v * 1e4).floor() / 1e4);
                let each = |q: &OperatingPoint| {
                    format!("{} N wanted at a contraction of {}", number(q.force_n, 5), floor(q.contraction))
                };
                points.iter().map(each).collect::<Vec<_>>().join(" and ")
            }
            Relaxation::OuterDiameter { outer_diameter_mm, model, scaled_to } => {
                let scaled = scaled_to.as_ref().map_or_else(String::new, |m| format!(", scaled to {m} here"));
                format!(
                    "an outer diameter of {} mm (by the {model} model{scaled})",
                    number(*outer_diameter_mm, 5)
                )
            }
            Relaxation::BulgedDiameter { diameter_mm } => {
                format!("a bulged diameter of {} mm", number((diameter_mm * 10.0).ceil() / 10.0, 4))
            }
            Relaxation::Stretch { stretch } => {
                format!("a largest stretch of {}", number((stretch * 100.0).ceil() / 100.0, 3))
            }
            Relaxation::StrandStrain { strain } => {
                format!("a strand strain of {}", percent((strain * 1e4).ceil() / 1e4))
            }
            Relaxation::BurstMargin { margin } => {
                format!("a burst margin of {}", number((margin * 100.0).floor() / 100.0, 3))
            }
        };
        out.push_str(&format!("  - {line}\n"));
    }
    out
}
