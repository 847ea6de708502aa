//! A design for people.

use crate::failure::in_flags;
use crate::output::text::{
    Units, aligned, braid_name, columns, number, percent, percents, place, rubber_name,
};
use mckibben::design::{
    BraidChoice, Candidate, Closest, Demand, Limit, OperatingPoint, Outcome, Rejected, Relaxation, Spec, Way,
};
use mckibben::muscle::BraidStiffness;
use mckibben_app::{DesignAnswer, SpreadAnswer, TorqueWanted, Wanted};
use std::path::Path;

/// The design for people.
pub fn of(answer: &DesignAnswer, file: Option<&Path>, u: &Units) -> String {
    let (spec, outcome) = (&answer.spec, &answer.outcome);
    let wanted = wanted(answer, u);
    let mut out = format!("Wanted: {wanted} with at most {}\n", u.pressure.show(spec.max_pressure_mpa));
    let with = if answer.searched_with == answer.model {
        String::new()
    } else {
        format!(", searched with {}", answer.searched_with)
    };
    let length = match &spec.length_mm {
        None => format!("L0 {}, ", u.length.show(spec.base.length_mm())),
        Some(_) => String::new(),
    };
    let (looked_at, fit) = (answer.looked_at, answer.fitting);
    out.push_str(&format!(
        "Model {}{with}; {looked_at} muscles looked at, {fit} fit; {length}{}, {}\n{}",
        answer.model,
        rubber_of(spec),
        braid_of(spec),
        safety(spec)
    ));
    let assumed = answer.assumptions.iter().map(|sentence| format!("Assumed: {}.\n", in_flags(sentence)));
    out.extend(assumed);
    out.push('\n');
    if let Some(closest) = &outcome.closest {
        out.push_str(&nothing_fits(closest, u));
        if let Some(hint) = answer.closest.as_ref().and_then(|c| c.hint.as_ref()) {
            out.push_str(&format!("{}\n", in_flags(hint)));
        }
    } else {
        out.push_str(&candidates(outcome, spec.length_mm.is_some(), u));
        out.push_str(&doubt(answer, u));
        out.push_str(&joint(answer, file, u));
        out.push_str(&verified(answer, u));
        out.push_str(&spread_text(&answer.tolerance, u));
    }
    if !outcome.rejected.is_empty() && outcome.closest.is_none() {
        out.push_str("\nJust missed\n");
    } else if outcome.rejected.len() > 1 {
        out.push_str("\nNext closest\n");
    }
    let skip = usize::from(outcome.closest.is_some());
    for r in outcome.rejected.iter().skip(skip) {
        let by = r.reason.misses_by().filter(|share| *share < 1.0);
        let by = by.map_or_else(String::new, |share| format!(" (misses by {})", percent(thousandth(share))));
        out.push_str(&format!(
            "  {}: {}{by}\n",
            measures(r, u),
            u.sentence(&r.reason.describe(|kind, v| u.show(kind, v)))
        ));
    }
    out
}

/// What the muscle must do.
fn wanted(answer: &DesignAnswer, u: &Units) -> String {
    let spec = &answer.spec;
    match &spec.wanted {
        Demand::Points(points) => {
            let one =
                |q: &OperatingPoint| format!("{} at {}", u.force.show(q.force_n), percent(q.contraction));
            points.iter().map(one).collect::<Vec<_>>().join(", ")
        }
        Demand::Load { way, .. } => {
            let load = answer.load.as_deref().unwrap_or_default();
            match *way {
                Way::Stroke(mm) => format!("{load} lifted by {}", u.length.show(mm)),
                Way::Contraction(ratio) => format!("{load} lifted to {}", percent(ratio)),
            }
        }
        Demand::Joint(joint) => {
            let one = |&(torque, angle): &(f64, f64)| {
                format!("{} N m at ±{}°", number(torque, 4), number(angle, 4))
            };
            joint.torques.iter().map(one).collect::<Vec<_>>().join(", ")
        }
    }
}

/// The pulley between the muscles, and the joint file that goes with them.
fn joint(answer: &DesignAnswer, file: Option<&Path>, u: &Units) -> String {
    let Some(j) = answer.candidates.first().and_then(|c| c.joint) else { return String::new() };
    let angle = number(j.largest_angle_deg, 4);
    let neutral = number(100.0 * j.contraction_at_neutral, 5);
    // A joint file names its muscles relative to itself: it goes beside them.
    let name = file.and_then(Path::file_name).map(Path::new);
    let (name, where_to) = match name {
        Some(name) => (place(name), "beside the muscle file"),
        None => ("winner.toml".into(), "with the muscle in winner.toml (-o winner.toml)"),
    };
    let written = name.replace('\\', "\\\\").replace('"', "\\\"");
    let muscle =
        |i: u8| format!("[muscle_{i}]\nfile = \"{written}\"\ncontraction_at_neutral = \"{neutral}%\"\n");
    format!(
        "\nThe first on a pulley of radius {}, both muscles contracted by {neutral} % at the neutral angle. As a joint file, {where_to}:\n\n[joint]\nradius = \"{} mm\"\nrange = \"-{angle}..{angle} deg\"\n\n{}\n{}",
        u.length.show(j.radius_mm),
        number(j.radius_mm, 5),
        muscle(1),
        muscle(2)
    )
}

/// The rubber that is searched with.
fn rubber_of(spec: &Spec) -> String {
    let names: Vec<&str> = spec.rubbers.iter().filter_map(|rubber| rubber.name.as_deref()).collect();
    match names[..] {
        [] => format!("rubber {}", rubber_name(&spec.base)),
        [one] => format!("rubber {one}"),
        _ => format!("{} rubbers", names.len()),
    }
}

/// What keeps the muscles from breaking.
fn safety(spec: &Spec) -> String {
    let strain = spec.limits.strand_strain.map(|v| format!("strands stretched by at most {}", percent(v)));
    let known = match &spec.braid {
        BraidChoice::Sleeves(list) => list.iter().all(|b| b.strands.is_some_and(|s| s.strength_n.is_some())),
        _ => spec.base.braid().strands.is_some_and(|s| s.strength_n.is_some()),
    };
    let burst = match spec.limits.burst_margin.filter(|m| *m > 0.0) {
        Some(margin) if known => {
            format!("burst at {} times the maximum pressure or above", number(margin, 4))
        }
        Some(margin) => format!(
            "burst at {} times the maximum pressure or above only where the strength of the strands is stated, and here it is not",
            number(margin, 4)
        ),
        None => "burst not bounded".into(),
    };
    format!("Safety: {}\n", strain.into_iter().chain([burst]).collect::<Vec<_>>().join("; "))
}

/// The braid that is searched with; its stiffness may differ from muscle to muscle.
fn braid_of(spec: &Spec) -> String {
    let base = &spec.base;
    match (&spec.braid, base.braid().stiffness, base.braid().strands) {
        (BraidChoice::Sleeves(list), ..) => match &list[..] {
            [one] => format!("sleeve {}", one.sleeve.as_ref().map_or("of the muscle file", |s| &s.name)),
            _ => format!("{} sleeves", list.len()),
        },
        (_, BraidStiffness::OfStrands, Some(strands)) => format!("braid of {} strands", strands.count),
        _ => format!("braid {}", braid_name(base)),
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

fn measures(r: &Rejected, u: &Units) -> String {
    format!("D0 {}, s {}", u.length.to(r.outer_diameter_mm, 4), u.length.to(r.wall_mm, 3))
}

fn candidates(outcome: &Outcome, lengths: bool, u: &Units) -> String {
    let list = &outcome.candidates;
    let several_rubbers = list.windows(2).any(|w| w[0].muscle.tube().rubber != w[1].muscle.tube().rubber);
    let several_lengths = list.windows(2).any(|w| w[0].muscle.length_mm() != w[1].muscle.length_mm());
    let stiffness = |c: &Candidate| c.muscle.family_stiffness_n_per_mm();
    let several_braids = list.windows(2).any(|w| stiffness(&w[0]) != stiffness(&w[1]));
    let strands = list.iter().any(|c| c.largest(|q| q.response.strand_tension_n).is_some());
    let burst = list.iter().any(|c| c.burst_pressure_mpa.is_some());
    let tension = |c: &Candidate| {
        c.largest(|q| if strands { q.response.strand_tension_n } else { q.response.braid_tension_n })
    };
    let needs = list.iter().map(|c| {
        let each = c.points.iter().map(|q| u.pressure.to(q.pressure_mpa, 3));
        each.collect::<Vec<_>>().join(", ")
    });
    let first = |c: &Candidate| c.points.first().and_then(|q| q.response.stiffness_n_per_mm);
    let known = |of: &dyn Fn(&Candidate) -> f64| list.iter().map(|c| Some(of(c))).collect::<Vec<_>>();
    let maybe = |of: &dyn Fn(&Candidate) -> Option<f64>| list.iter().map(of).collect::<Vec<_>>();
    let thousandths = |v: f64| (1000.0 * v).floor() / 1000.0;
    let per_length = u.stiffness();
    let mut found = vec![
        (String::new(), (1..=list.len()).map(|i| format!("{i}.")).collect()),
        (u.length.heading("D0"), u.length.column(known(&|c| c.muscle.outer_diameter_mm()), 4)),
        (u.length.heading("s"), u.length.column(known(&|c| c.muscle.wall_mm()), 3)),
        ("θ0 [°]".into(), aligned(&known(&|c| c.muscle.braid().angle_deg), 4)),
    ];
    if lengths || several_lengths {
        found.push((u.length.heading("L0"), u.length.column(known(&|c| c.muscle.length_mm()), 4)));
    }
    if several_braids {
        found.push((per_length.heading("k"), per_length.column(maybe(&stiffness), 3)));
    }
    found.extend([
        (u.pressure.heading("needs"), needs.collect()),
        ("to spare".into(), percents(known(&|c| thousandths(c.margin)), 3)),
        (u.force.heading("F blocked"), u.force.column(known(&|c| c.blocked_force_n), 4)),
        ("ε free".into(), percents(maybe(&|c| c.free_contraction), 3)),
        (u.length.heading("bulges to"), u.length.column(maybe(&Candidate::bulged_diameter_mm), 3)),
        (per_length.heading("stiffness"), per_length.column(maybe(&first), 3)),
        ("air [nL]".into(), aligned(&maybe(&Candidate::air_normal_litres), 3)),
        (u.force.heading(if strands { "strand" } else { "braid" }), u.force.column(maybe(&tension), 3)),
        (u.force.heading("±"), u.force.column(maybe(&|c| c.largest(|q| q.uncertainty_n)), 2)),
    ]);
    if burst {
        found.push((u.pressure.heading("bursts"), u.pressure.column(maybe(&|c| c.burst_pressure_mpa), 3)));
    }
    let mass = |c: &Candidate| c.muscle.tube().rubber_mass_g();
    if list.iter().any(|c| mass(c).is_some()) {
        found.push(("rubber [g]".into(), aligned(&maybe(&mass), 4)));
    }
    if several_rubbers {
        found.push(("rubber".into(), list.iter().map(|c| rubber_name(&c.muscle)).collect()));
    }
    let mut out = columns(found);
    let braid =
        if strands { "strand: tension of one strand" } else { "braid: tension of all strands together" };
    let k = if several_braids { "k: stiffness of one strand family. " } else { "" };
    out.push_str(&format!(
        "\n{}to spare: pull above what is wanted, at the maximum pressure.\nF blocked and ε free: at the maximum pressure. stiffness: at the first point. bulges to, {}, air, ±: the largest of the points.\nair: normal litres from rest to the point. {k}{braid}.\n±: 95 % half-width of the pull, against a measured muscle.\n",
        if list.iter().any(|c| c.points.len() > 1) { "needs: the pressure of each point. " } else { "" },
        if strands { "strand" } else { "braid" }
    ));
    out.push_str(&list.first().map_or_else(String::new, binds));
    if let Some(first) = list.first().filter(|c| !c.from_thick_wall.is_empty()) {
        out.push_str(&format!("From the thick-wall model: {}.\n", first.from_thick_wall.join(", ")));
    }
    out
}

/// Where the ± is larger than what is to spare, how to ask for a muscle that is sure to do what is wanted.
fn doubt(answer: &DesignAnswer, u: &Units) -> String {
    let Some(first) = answer.outcome.candidates.first() else { return String::new() };
    let tight = first.points.iter().find_map(|q| {
        let half = q.uncertainty_n?;
        (q.available_n - q.wanted.force_n < half).then_some(half)
    });
    let Some(half) = tight else { return String::new() };
    let joined = |list: Vec<String>| list.join(", ");
    let force = |q: &Wanted| u.force.show(q.force_n);
    let (half, wanted) = match &answer.spec.wanted {
        Demand::Joint(joint) => {
            let half = format!("{} N m", number(1e-3 * half * joint.radius_mm, 2));
            (half, joined(joint.torques.iter().map(|t| format!("{} N m", number(t.0, 4))).collect()))
        }
        _ => {
            let wanted = first.points.iter().map(|q| u.force.show(q.wanted.force_n));
            (format!("{} {}", u.force.to(half, 2), u.force.name), joined(wanted.collect()))
        }
    };
    let ask = match &answer.to_be_sure {
        Some(sure) if sure.points.is_empty() => {
            let torque = |t: &TorqueWanted| format!("{} N m", number(t.torque_nm, 5));
            format!("ask for {}", joined(sure.torques.iter().map(torque).collect()))
        }
        Some(sure) => format!("ask for {}", joined(sure.points.iter().map(force).collect())),
        None => "no muscle of this search is strong enough".to_owned(),
    };
    format!("The first has less to spare than the ± of {half}: to be sure of {wanted}, {ask}.\n")
}

/// What finite elements say of the first candidate.
fn verified(answer: &DesignAnswer, u: &Units) -> String {
    let (Some(verified), Some(winner)) = (&answer.verification, answer.candidates.first()) else {
        return String::new();
    };
    let holds = if verified.holds { "holds" } else { "does NOT hold" };
    let mut out = format!("\nBy finite elements the first {holds}\n");
    for (c, q) in verified.points.iter().zip(&winner.points) {
        let (at, max) = (percent(c.contraction), u.pressure.show(answer.max_pressure_mpa));
        let line = match (c.force_at_max_pressure_n, &c.cause) {
            (Some(f), _) => {
                let difference = f - q.force_at_max_pressure_n;
                let sign = if difference < 0.0 { "less" } else { "more" };
                let needs = c.pressure_mpa.map_or_else(String::new, |v| {
                    format!("; {} take {}", u.force.show(c.force_n), u.pressure.show(v))
                });
                format!(
                    "{} at {at} and {max}, {} {} {sign}{needs}",
                    u.force.show(f),
                    u.force.to(difference.abs(), 3),
                    u.force.name
                )
            }
            (None, cause) => {
                format!("no answer at {at}: {}", u.sentence(cause.as_deref().unwrap_or("unknown")))
            }
        };
        out.push_str(&format!("  {line}\n"));
    }
    out
}

fn spread_text(spreads: &[SpreadAnswer], u: &Units) -> String {
    let line = |s: &SpreadAnswer| {
        format!(
            "  {} at {} and {}: {} to {} in the worst corners, likely ± {} {}\n",
            u.force.show(s.force_n),
            percent(s.contraction),
            u.pressure.show(s.pressure_mpa),
            u.force.to(s.low_n, 4),
            u.force.to(s.high_n, 4),
            u.force.to(s.likely_n, 2),
            u.force.name
        )
    };
    if spreads.is_empty() {
        return String::new();
    }
    format!("\nTolerances of the first candidate\n{}", spreads.iter().map(line).collect::<String>())
}

fn nothing_fits(closest: &Closest, u: &Units) -> String {
    let mut out = format!(
        "Nothing fits. Closest: {}: {}\n",
        measures(&closest.rejected, u),
        u.sentence(&closest.rejected.reason.describe(|kind, v| u.show(kind, v)))
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
                format!("a maximum pressure of {}{far}", u.pressure.show(*pressure_mpa))
            }
            Relaxation::Force(points) => {
                let each = |q: &OperatingPoint| {
                    format!("{} wanted at {}", u.force.show(q.force_n.floor()), percent(q.contraction))
                };
                points.iter().map(each).collect::<Vec<_>>().join(" and ")
            }
            Relaxation::Contraction(points) => {
                let floor = |v: f64| percent((v * 1e4).floor() / 1e4);
                let each = |q: &OperatingPoint| {
                    format!("{} wanted at a contraction of {}", u.force.show(q.force_n), floor(q.contraction))
                };
                points.iter().map(each).collect::<Vec<_>>().join(" and ")
            }
            Relaxation::OuterDiameter { outer_diameter_mm, model, scaled_to } => {
                let scaled = scaled_to.as_ref().map_or_else(String::new, |m| format!(", scaled to {m} here"));
                format!(
                    "an outer diameter of {} (by the {model} model{scaled})",
                    u.length.show(*outer_diameter_mm)
                )
            }
            Relaxation::BulgedDiameter { diameter_mm } => {
                format!("a bulged diameter of {}", u.length.show((diameter_mm * 10.0).ceil() / 10.0))
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
