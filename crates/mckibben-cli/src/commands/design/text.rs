//! A design as text and as JSON.

use super::Checked;
use crate::kind::Kind;
use crate::output::json as shapes;
use crate::output::text::{Pressures, number, or_dash, percent, plus_minus, rubber_name, table};
use mckibben::design::{BraidChoice, Candidate, OperatingPoint, Outcome, Rejected, Relaxation, Spec, Spread};
use serde_json::{Map, Value, json};

/// One candidate with all it knows.
pub fn candidate_json(c: &Candidate, kind: Kind) -> Value {
    let points: Vec<Value> = c
        .points
        .iter()
        .map(|q| {
            let mut map = Map::new();
            map.insert("force_n".into(), json!(q.wanted.force_n));
            map.insert("contraction".into(), json!(q.wanted.contraction));
            map.insert("pressure_mpa".into(), json!(q.pressure_mpa));
            map.insert("force_at_max_pressure_n".into(), json!(q.available_n));
            map.insert("margin".into(), json!(q.margin));
            shapes::put_response(&mut map, &q.response);
            map.insert("air_normal_litres".into(), json!(q.air_normal_litres));
            map.insert("uncertainty_n".into(), json!(q.uncertainty_n));
            Value::Object(map)
        })
        .collect();
    let mut out = shapes::muscle(&c.muscle);
    let more = json!({
        "pressure_mpa": c.pressure_mpa,
        "margin": c.margin,
        "blocked_force_n": c.blocked_force_n,
        "free_contraction": c.free_contraction,
        "bulged_diameter_mm": c.bulged_diameter_mm(),
        "stiffness_n_per_mm": c.points.first().and_then(|q| q.response.stiffness_n_per_mm),
        "air_normal_litres": c.air_normal_litres(),
        "work_j": c.work_j,
        "strand_tension_n": c.largest(|q| q.response.strand_tension_n),
        "braid_tension_n": c.largest(|q| q.response.braid_tension_n),
        "max_stretch": c.largest(|q| q.response.max_stretch),
        "burst_pressure_mpa": c.burst_pressure_mpa,
        "uncertainty_n": c.largest(|q| q.uncertainty_n),
        "points": points,
        "from_thick_wall": c.from_thick_wall,
        "model": if kind.replaced(&c.muscle).is_some() { "thick-wall" } else { kind.name() },
    });
    if let (Some(out), Value::Object(more)) = (out.as_object_mut(), more) {
        out.extend(more);
    }
    out
}

fn rejected_json(r: &Rejected, p: Pressures) -> Value {
    json!({
        "outer_diameter_mm": r.outer_diameter_mm, "wall_mm": r.wall_mm, "angle_deg": r.angle_deg, "rubber": r.rubber,
        "reason": r.reason.describe(|v| p.show(v)),
    })
}

fn relaxation_json(r: &Relaxation) -> Value {
    match r {
        Relaxation::Pressure { pressure_mpa, extrapolated } => {
            json!({ "relax": "max_pressure", "pressure_mpa": pressure_mpa, "extrapolated": extrapolated })
        }
        Relaxation::Force(points) => json!({ "relax": "force", "points": points_json(points) }),
        Relaxation::Contraction(points) => json!({ "relax": "contraction", "points": points_json(points) }),
        Relaxation::OuterDiameter { outer_diameter_mm, model, scaled_to } => {
            json!({ "relax": "outer_diameter", "outer_diameter_mm": outer_diameter_mm, "model": model, "scaled_to": scaled_to })
        }
        Relaxation::BulgedDiameter { diameter_mm } => {
            json!({ "relax": "max_bulged_diameter", "bulged_diameter_mm": diameter_mm })
        }
        Relaxation::Stretch { stretch } => json!({ "relax": "max_stretch", "max_stretch": stretch }),
        Relaxation::BurstMargin { margin } => json!({ "relax": "min_burst_margin", "burst_margin": margin }),
    }
}

fn points_json(points: &[OperatingPoint]) -> Vec<Value> {
    points.iter().map(|q| json!({ "force_n": q.force_n, "contraction": q.contraction })).collect()
}

/// The whole design.
pub fn as_json(spec: &Spec, kind: Kind, outcome: &Outcome, spreads: &[Spread], checked: &[Checked]) -> Value {
    let p_mpa = Pressures(crate::flags::PressureUnit::Mpa);
    let mut out = json!({
        "model": kind.name(),
        "max_pressure_mpa": spec.max_pressure_mpa,
        "looked_at": outcome.looked_at.0,
        "fitting": outcome.looked_at.1,
        "candidates": outcome.candidates.iter().map(|c| candidate_json(c, kind)).collect::<Vec<_>>(),
        "rejected": outcome.rejected.iter().map(|r| rejected_json(r, p_mpa)).collect::<Vec<_>>(),
    });
    let Some(map) = out.as_object_mut() else { return out };
    if !checked.is_empty() {
        let list: Vec<Value> = checked
            .iter()
            .map(|c| {
                json!({
                    "force_n": c.wanted.force_n, "contraction": c.wanted.contraction, "pressure_mpa": c.pressure_mpa,
                    "force_at_max_pressure_n": c.available_n.as_ref().ok(), "cause": c.available_n.as_ref().err(),
                })
            })
            .collect();
        map.insert("verification".into(), json!({ "model": "fe", "points": list }));
    }
    if !spreads.is_empty() {
        let list: Vec<Value> = spreads
            .iter()
            .map(|s| {
                json!({
                    "force_n": s.wanted.force_n, "contraction": s.wanted.contraction, "pressure_mpa": s.pressure_mpa,
                    "low_n": s.low_n, "high_n": s.high_n, "likely_n": s.likely_n,
                })
            })
            .collect();
        map.insert("tolerance".into(), json!(list));
    }
    if let Some(closest) = &outcome.closest {
        let mut value = rejected_json(&closest.rejected, p_mpa);
        if let Some(inner) = value.as_object_mut() {
            inner.insert("length_mm".into(), json!(closest.muscle.length_mm()));
            let list: Vec<Value> = closest.relaxations.iter().map(relaxation_json).collect();
            inner.insert("relaxations".into(), json!(list));
            inner.insert("hint".into(), json!(beyond(spec)));
        }
        map.insert("closest".into(), value);
    }
    out
}

/// The design for people.
pub fn as_text(
    spec: &Spec,
    kind: Kind,
    outcome: &Outcome,
    spreads: &[Spread],
    checked: &[Checked],
    p: Pressures,
) -> String {
    let wanted: Vec<String> = spec
        .points
        .iter()
        .map(|q| format!("{} N at {}", number(q.force_n, 5), percent(q.contraction)))
        .collect();
    let mut out = format!("Wanted: {} with at most {}\n", wanted.join(", "), p.show(spec.max_pressure_mpa));
    out.push_str(&format!(
        "Model {}; {} muscles looked at, {} fit; L0 {} mm, braid {}\n\n",
        kind.name(),
        outcome.looked_at.0,
        outcome.looked_at.1,
        number(spec.base.length_mm(), 5),
        crate::output::text::braid_name(&spec.base)
    ));
    if let Some(closest) = &outcome.closest {
        out.push_str(&nothing_fits(closest, p));
        if let Some(hint) = beyond(spec) {
            out.push_str(&format!("{hint}\n"));
        }
    } else {
        out.push_str(&candidates(outcome, p));
        for c in &outcome.candidates {
            if let Some(why) = kind.replaced(&c.muscle) {
                let (d0, s) = (number(c.muscle.outer_diameter_mm(), 4), number(c.muscle.wall_mm(), 3));
                out.push_str(&format!("D0 {d0}, s {s}: {why}.\n"));
            }
        }
        out.push_str(&checked_text(spec, outcome, checked, p));
        out.push_str(&spread_text(spreads, p));
    }
    if !outcome.rejected.is_empty() && outcome.closest.is_none() {
        out.push_str("\nJust missed\n");
    } else if outcome.rejected.len() > 1 {
        out.push_str("\nNext closest\n");
    }
    let skip = usize::from(outcome.closest.is_some());
    for r in outcome.rejected.iter().skip(skip) {
        out.push_str(&format!("  {}: {}\n", measures(r), r.reason.describe(|v| p.show(v))));
    }
    out
}

fn measures(r: &Rejected) -> String {
    format!("D0 {}, s {}", number(r.outer_diameter_mm, 4), number(r.wall_mm, 3))
}

fn candidates(outcome: &Outcome, p: Pressures) -> String {
    let list = &outcome.candidates;
    let unit = p.unit();
    let needs = format!("needs [{unit}]");
    let several_rubbers = list.windows(2).any(|w| w[0].muscle.tube().rubber != w[1].muscle.tube().rubber);
    let strands = list.iter().any(|c| c.largest(|q| q.response.strand_tension_n).is_some());
    let burst = list.iter().any(|c| c.burst_pressure_mpa.is_some());
    let burst_title = format!("bursts [{unit}]");
    let mut header = vec![
        "",
        "D0 [mm]",
        "s [mm]",
        "θ0 [°]",
        &needs,
        "to spare",
        "F blocked [N]",
        "ε free",
        "bulges to [mm]",
        "stiffness [N/mm]",
        "air [nl]",
        if strands { "strand [N]" } else { "braid [N]" },
        "±",
    ];
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
                needs.join(", "),
                percent((1000.0 * c.margin).floor() / 1000.0),
                number(c.blocked_force_n, 4),
                or_dash(c.free_contraction, |v| percent((1000.0 * v).round() / 1000.0)),
                or_dash(c.bulged_diameter_mm(), |v| number(v, 3)),
                or_dash(c.points.first().and_then(|q| q.response.stiffness_n_per_mm), |v| number(v, 3)),
                or_dash(c.air_normal_litres(), |v| number(v, 3)),
                or_dash(tension, |v| number(v, 3)),
                plus_minus(c.largest(|q| q.uncertainty_n)).replace("± ", ""),
            ];
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
    out.push_str(&format!(
        "\nto spare: pull above what is wanted, at the maximum pressure. air: normal litres from rest to the point.\n{braid}.\n±: 95 % of the model's error in the pull, against what it was made from; muscles themselves scatter by some 5 %.\n"
    ));
    out.push_str(&list.first().map_or_else(String::new, doubt));
    out.push_str(&list.first().map_or_else(String::new, strain));
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

/// Strands that stretch further than the models were looked at.
fn strain(best: &Candidate) -> String {
    let tension = best.largest(|q| q.response.braid_tension_n);
    let strain = tension.and_then(|t| best.muscle.strand_strain(t)).filter(|s| *s > 0.06);
    strain.map_or_else(String::new, |s| {
        format!(
            "Its strands stretch by {}: past 6 % the models have not been compared with anything.\n",
            percent((s * 1e3).round() / 1e3)
        )
    })
}

/// Contractions that no braid of the search reaches, and the angle that would.
fn beyond(spec: &Spec) -> Option<String> {
    let BraidChoice::Angle(angles) = &spec.braid else { return None };
    let smallest = angles.bounds().0;
    let most = |angle: f64| 1.0 - 1.0 / (3f64.sqrt() * angle.to_radians().cos());
    let wanted = spec.points.iter().map(|q| q.contraction).fold(0.0, f64::max);
    if wanted < most(smallest) {
        return None;
    }
    let cos = 1.0 / (3f64.sqrt() * (1.0 - wanted));
    let reach = if cos < 1.0 {
        format!("{} needs one well below {}°", percent(wanted), number(cos.acos().to_degrees().floor(), 3))
    } else {
        format!("no braid reaches {} (the limit is 42.3 %)", percent(wanted))
    };
    let at = number(smallest, 4);
    Some(format!(
        "A braid at {at}° contracts by {} at most; {reach}.",
        percent((most(smallest) * 1e3).floor() / 1e3)
    ))
}

/// What finite elements say of the first candidate.
fn checked_text(spec: &Spec, outcome: &Outcome, checked: &[Checked], p: Pressures) -> String {
    let mut out = String::new();
    let Some(winner) = outcome.candidates.first().filter(|_| !checked.is_empty()) else { return out };
    out.push_str("\nThe first by finite elements\n");
    for (c, q) in checked.iter().zip(&winner.points) {
        let at = percent(c.wanted.contraction);
        let max = p.show(spec.max_pressure_mpa);
        let line = match &c.available_n {
            Ok(f) => {
                let difference = f - q.available_n;
                let sign = if difference < 0.0 { "less" } else { "more" };
                let needs = c.pressure_mpa.map_or_else(String::new, |v| {
                    format!("; {} N take {}", number(c.wanted.force_n, 5), p.show(v))
                });
                format!(
                    "{} N at {at} and {max}, {} N {sign}{needs}",
                    number(*f, 4),
                    number(difference.abs(), 3)
                )
            }
            Err(error) => format!("no answer at {at}: {error}"),
        };
        out.push_str(&format!("  {line}\n"));
    }
    out
}

fn spread_text(spreads: &[Spread], p: Pressures) -> String {
    let line = |s: &Spread| {
        format!(
            "  {} N at {} and {}: {} to {} N in the worst corners, likely ± {} N\n",
            number(s.wanted.force_n, 5),
            percent(s.wanted.contraction),
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

fn nothing_fits(closest: &mckibben::design::Closest, p: Pressures) -> String {
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
            Relaxation::BurstMargin { margin } => {
                format!("a burst margin of {}", number((margin * 100.0).floor() / 100.0, 3))
            }
        };
        out.push_str(&format!("  - {line}\n"));
    }
    out
}
