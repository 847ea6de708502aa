//! `design`: the main job.

use crate::{
    Asked, Bar, Failure, Format, NO_ANSWER, Units, burst_first, check_ending, emit, in_flags, listed, number,
    pairs, percent, place, save, shown, tabled, value,
};
use mckibben::{analysis::FailureMode, liquid::Liquid};
use mckibben_app::{
    CandidateAnswer, ClosestAnswer, DemandAnswer, DesignAnswer, OperatingPoint, RejectedAnswer,
    SearchedAnswer, TorqueWanted,
};
use mckibben_design::{CandidatePoint, Limit, Relaxation, Spread};
use serde_json::Value;
use std::path::Path;

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let target = asked.path("output");
    check_ending(target.as_deref(), &["toml"])?;
    let mut answer = mckibben_app::design(&asked.request()?, &Bar::new("muscles"))?;
    let winner = answer.muscle_files.first();
    if let Some(winner) = winner {
        save(target.as_deref(), winner.text.as_bytes())?;
    }
    let text = || burst_first(&answer.warnings) + &as_text(&answer, target.as_deref(), &shown::units());
    asked.print(&answer, "candidates", text)?;
    if let (Some(path), Some(_), Format::Text) = (&target, winner, asked.format) {
        emit(format!("\nThe winner is in {}.\n", place(path)), None)?;
    }
    asked.draw(&mut answer.figure)?;
    Ok(if answer.candidates.is_empty() { NO_ANSWER } else { 0 })
}

/// The design for people.
fn as_text(answer: &DesignAnswer, file: Option<&Path>, u: &Units) -> String {
    let searched = &answer.searched;
    let wanted = wanted(answer, u);
    let level = searched.guaranteed.map_or_else(String::new, |level| {
        format!(", guaranteed: the lower end of the ± ({}) meets it", percent(level))
    });
    let supply = u.pressure.show(answer.max_pressure_mpa);
    let each = searched.bundle.filter(|n| *n > 1);
    let each = each.map_or_else(String::new, |n| format!(" of each of {n} muscles"));
    let filled = answer.liquid.as_ref().map_or_else(String::new, |l| format!(" of {}", liquid(l)));
    let mut out = format!("Required{each}: {wanted} with at most {supply}{filled}{level}\n");
    let other = Some(&answer.searched_with).filter(|with| **with != answer.model);
    let with = other.map_or_else(String::new, |with| format!(", searched with {with}"));
    let length = searched.length_mm.map_or_else(String::new, |mm| format!("L0 {}, ", u.length.show(mm)));
    let (looked_at, fit, model) = (answer.looked_at, answer.fitting, &answer.model);
    let (rubber, braid, safety) = (&searched.rubber, &searched.braid, safety(searched));
    out += &format!(
        "Model {model}{with}; {looked_at} muscles examined, {fit} fit; {length}{rubber}, {braid}\n{safety}"
    );
    let assumed = answer.assumptions.iter().map(|sentence| format!("Assumed: {}.\n", in_flags(sentence)));
    out.extend(assumed);
    out.push('\n');
    if let Some(closest) = &answer.closest {
        out.push_str(&nothing_fits(closest, u));
        out.push_str(&too_weak(answer));
        if let Some(hint) = &closest.hint {
            out.push_str(&format!("{}\n", in_flags(hint)));
        }
    } else {
        out += &candidates(&answer.candidates, searched.length_mm.is_none(), u);
        let words = answer.uncertainty_words.as_ref();
        out.extend(words.and_then(|w| w.text_in(u)).map(|text| format!("± of the first: {text}.\n")));
        out += &doubt(answer, u);
        out.extend(words.and_then(|w| w.bench_in(u)).map(|text| format!("{text}.\n")));
        let parts = [bundle(answer, u), joint(answer, file, u), verified(answer, u)];
        out.extend(parts.into_iter().chain([spread_text(&answer.tolerance, u)]));
    }
    out.push_str(&bought(answer, u));
    if !answer.rejected.is_empty() && answer.closest.is_none() {
        out.push_str("\nNear misses\n");
    } else if answer.rejected.len() > 1 {
        out.push_str("\nNext closest\n");
    }
    let skip = usize::from(answer.closest.is_some());
    for r in answer.rejected.iter().skip(skip) {
        let by = r.misses_by.filter(|share| *share < 1.0);
        let by = by.map_or_else(String::new, |share| format!(" (misses by {})", percent(thousandth(share))));
        out.push_str(&format!("  {}: {}{by}\n", measures_of(r, u), u.sentence(&r.reason)));
    }
    out
}

/// `water`, `water with 1 % of gas`.
fn liquid(liquid: &Liquid) -> String {
    let gas = Some(liquid.gas_share).filter(|share| *share > 0.0);
    let gas = gas.map_or_else(String::new, |share| format!(" with {} of gas", percent(share)));
    format!("{}{gas}", liquid.name)
}

/// What the muscles of a bundle do together.
fn bundle(answer: &DesignAnswer, u: &Units) -> String {
    let Some(b) = &answer.bundle else { return String::new() };
    let mut row = value(b);
    if b.muscles < 2 {
        row["pitch_mm"] = Value::Null;
    } else if b.touch_contraction.is_none() {
        row["touch_contraction"] = "do not touch".into();
    }
    let keys = "rest_envelope_mm=circle_around_them_at_rest:3 envelope_mm=at_the_bulge:3 row_mm=width_in_one_flat_row:3 pitch_mm=distance_of_their_axes:3 touch_contraction=neighbours_touch_at:%";
    let points = "force_n=required contraction=at:% force_at_max_pressure_n+uncertainty_n=F air_normal_litres=air:3 liquid_volume_mm3=liquid:3";
    let (sizes, points) = (pairs(&listed(&row, keys, u)), tabled(&b.points, points, u));
    format!("\nBundle of {} of the first muscle, at the maximum pressure\n{sizes}{points}", b.muscles)
}

/// The muscles as sold that would do.
fn bought(answer: &DesignAnswer, u: &Units) -> String {
    if answer.bought.is_empty() {
        return String::new();
    }
    let count =
        answer.searched.bundle.filter(|n| *n > 1).map_or_else(String::new, |n| format!(", {n} of one"));
    let keys = "product name outer_diameter_mm=D0 length_mm=L0 force_n+uncertainty_n=F wanted.contraction=at:% pressure_mpa=P wanted.force_n=required";
    format!("\nAs sold these would do{count}\n{}", tabled(&answer.bought, keys, u))
}

/// What the muscle must do.
fn wanted(answer: &DesignAnswer, u: &Units) -> String {
    let load = answer.load.as_deref().unwrap_or_default();
    match &answer.wanted {
        DemandAnswer::Points { points } => {
            let one =
                |q: &OperatingPoint| format!("{} at {}", u.force.show(q.force_n), percent(q.contraction));
            points.iter().map(one).collect::<Vec<_>>().join(", ")
        }
        DemandAnswer::Stroke { stroke_mm } => format!("{load} lifted by {}", u.length.show(*stroke_mm)),
        DemandAnswer::Contraction { contraction } => format!("{load} lifted to {}", percent(*contraction)),
        DemandAnswer::Joint { torques, .. } => {
            let one =
                |t: &TorqueWanted| format!("{} N m at ±{}°", number(t.torque_nm, 4), number(t.angle_deg, 4));
            torques.iter().map(one).collect::<Vec<_>>().join(", ")
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
        "\nThe first muscle on a pulley of radius {}, both muscles contracted by {neutral} % at the neutral angle. As a joint file, {where_to}:\n\n[joint]\nradius = \"{} mm\"\nrange = \"-{angle}..{angle} deg\"\n\n{}\n{}",
        u.length.show(j.radius_mm),
        number(j.radius_mm, 5),
        muscle(1),
        muscle(2)
    )
}

/// What keeps the muscles from breaking.
fn safety(searched: &SearchedAnswer) -> String {
    let strain = searched.max_strand_strain;
    let strain = strain.map(|v| format!("strands stretched by at most {}", percent(v)));
    let burst = match searched.min_burst_margin {
        Some(margin) if searched.burst_checked => {
            format!(
                "strands and clamps fail at {} times the maximum pressure or more, the tube at {}",
                number(margin, 4),
                number(FailureMode::Mesh.share() * margin, 4)
            )
        }
        Some(margin) => format!(
            "burst not checked (required: {} times the maximum pressure), because the strength of the strands is not stated",
            number(margin, 4)
        ),
        None => "no limit on burst".into(),
    };
    format!("Safety: {}\n", strain.into_iter().chain([burst]).collect::<Vec<_>>().join("; "))
}

fn thousandth(share: f64) -> f64 {
    (1e3 * share).ceil() / 1e3
}

/// What keeps the best from being better.
fn binds(best: &CandidateAnswer) -> String {
    let Some(limit) = best.candidate.binds else { return String::new() };
    let what = match limit {
        Limit::Force => "required pull",
        Limit::BulgedDiameter => "largest bulged diameter",
        Limit::MaxStretch => "largest stretch of the rubber",
        Limit::StrandStrain => "largest strain of the strands",
        Limit::BurstMargin => "burst pressure",
        Limit::Buckling => "load at which it buckles",
        Limit::LiquidVolume => "largest liquid volume",
    };
    format!("Limited by: {what}.\n")
}

fn measures(outer_diameter_mm: f64, wall_mm: f64, sleeve: Option<&String>, u: &Units) -> String {
    let sleeve = sleeve.map_or_else(String::new, |name| format!(" in {name}"));
    format!("D0 {}, s {}{sleeve}", u.length.to(outer_diameter_mm, 4), u.length.to(wall_mm, 3))
}

fn measures_of(RejectedAnswer { muscle: r, .. }: &RejectedAnswer, u: &Units) -> String {
    measures(r.outer_diameter_mm, r.wall_mm, r.sleeve.as_ref(), u)
}

fn candidates(list: &[CandidateAnswer], lengths: bool, u: &Units) -> String {
    let rows = list.iter().enumerate().map(|(i, c)| {
        let mut row = value(c);
        let needs: Vec<String> =
            c.candidate.points.iter().map(|q| u.pressure.to(q.response.pressure_mpa, 3)).collect();
        row["rank"] = format!("{}.", i + 1).into();
        row["needs"] = needs.join(", ").into();
        row
    });
    let rows: Vec<Value> = rows.collect();
    let any = |key: &str| rows.iter().any(|row| !row[key].is_null());
    let several = |key: &str| rows.windows(2).any(|w| w[0][key] != w[1][key]);
    let [strands, liquid, tubes, mass] = ["strand_tension_n", "liquid_volume_mm3", "tube", "mass_g"].map(any);
    let required = format!("needs={}", u.pressure.heading("P_required"));
    let required = required.replace(' ', "_");
    let keys = [
        (true, "rank=_ tube sleeve outer_diameter_mm=D0 wall_mm=s:3 angle_deg=θ0"),
        (lengths || several("length_mm"), "length_mm=L0"),
        (several("family_stiffness_n_per_mm"), "family_stiffness_n_per_mm=k:3"),
        (true, &*required),
        (true, "margin:3% blocked_force_n=F_blocked free_contraction=ε_free:3%"),
        (true, "bulged_diameter_mm=bulged_D:3 stiffness_n_per_mm=stiffness:3"),
        (true, if liquid { "liquid_volume_mm3=liquid:3" } else { "air_normal_litres=air:3" }),
        (true, if strands { "strand_tension_n=strand:3" } else { "braid_tension_n=braid:3" }),
        (true, "uncertainty_n=±:~ burst_pressure_mpa=P_burst:3"),
        (true, if mass { "mass_g=mass:3" } else { "rubber_mass_g=rubber:3" }),
        (!tubes && several("rubber"), "rubber"),
    ];
    let keys: Vec<&str> = keys.into_iter().filter(|key| key.0).map(|key| key.1).collect();
    let mut out = tabled(&rows, &keys.join(" "), u);
    out += "\nP required: the pressure of each point. margin: pull above the required pull, at the maximum pressure.\n\
        F blocked and ε free: at the maximum pressure. stiffness: at the first point. bulged D, air or liquid, strand or braid, ±: the largest of the points.\n\
        air (normal litres: at 0 °C and 1.01325 bar) and liquid: from rest to the point. k: stiffness of one strand family. strand: tension of one strand; braid: of all together.\n\
        ±: 95 % half-width of the pull, against a measured muscle.\n";
    out.push_str(&list.first().map_or_else(String::new, binds));
    if let Some(first) = list.first().map(|c| &c.candidate).filter(|c| !c.from_thick_wall.is_empty()) {
        out.push_str(&format!("From the thick-wall model: {}.\n", first.from_thick_wall.join(", ")));
    }
    out
}

/// Where the ± is larger than what is to spare: the muscle that is sure to do what is wanted.
fn doubt(answer: &DesignAnswer, u: &Units) -> String {
    let Some(first) = answer.candidates.first() else { return String::new() };
    let tight = first.candidate.points.iter().find_map(|q: &CandidatePoint| {
        let half = q.uncertainty_n?;
        (q.force_at_max_pressure_n - q.response.force_n < half).then_some(half)
    });
    let Some(half) = tight else { return String::new() };
    let half = format!("{} {}", u.force.half_width(half), u.force.name);
    let sure = match &answer.to_be_sure {
        Some(sure) => format!(
            "To be sure (--guaranteed): {} with {}.",
            measures(sure.muscle.outer_diameter_mm, sure.muscle.wall_mm, sure.muscle.sleeve.as_ref(), u),
            u.pressure.show(answer.max_pressure_mpa)
        ),
        None => "No muscle of this search meets the requirement with the lower end of its ± (--guaranteed)."
            .into(),
    };
    format!("The margin of the first muscle is smaller than its ± of {half}. {sure}\n")
}

/// What finite elements say of the first candidate.
fn verified(answer: &DesignAnswer, u: &Units) -> String {
    let (Some(verified), Some(winner)) = (&answer.verification, answer.candidates.first()) else {
        return String::new();
    };
    let holds = if verified.holds { "meets the specification" } else { "does NOT meet the specification" };
    let rows = verified.points.iter().zip(&winner.candidate.points).map(|(c, q)| {
        let mut row = value(c);
        row["difference_n"] = c.force_at_max_pressure_n.map(|f| f - q.force_at_max_pressure_n).into();
        row["cause"] = c.cause.as_deref().map(|cause| u.sentence(cause)).into();
        row
    });
    let keys = "force_n=required contraction=at:% pressure_mpa=P_required force_at_max_pressure_n=F_at_max_P difference_n=difference:3 cause=no_answer";
    let points = tabled(&rows.collect::<Vec<_>>(), keys, u);
    format!("\nBy finite elements the first muscle {holds}\n{points}")
}

fn spread_text(spreads: &[Spread], u: &Units) -> String {
    if spreads.is_empty() {
        return String::new();
    }
    let keys = "force_n=required contraction=at:% pressure_mpa=P low_n=least high_n=largest likely_n=±:~";
    let about = "least and largest: in the worst corners of the tolerances; ±: likely";
    format!("\nTolerances of the first candidate\n{}{about}\n", tabled(spreads, keys, u))
}

/// What burst has to do with it that nothing fits.
fn too_weak(answer: &DesignAnswer) -> String {
    let (count, alone) = (answer.excluded_by_burst, answer.excluded_by_burst_alone);
    let Some(margin) = answer.searched.min_burst_margin.filter(|_| count > 0) else { return String::new() };
    let rest = match alone {
        0 => "each of them also misses another limit".to_owned(),
        all if all == count => "they meet every other limit".to_owned(),
        some => format!("{some} of them meet every other limit"),
    };
    let (all, margin) = (answer.looked_at, number(margin, 4));
    format!("Of {all} muscles {count} miss the safety factor of {margin}; {rest}.\n")
}

fn nothing_fits(closest: &ClosestAnswer, u: &Units) -> String {
    let (muscle, reason) = (measures_of(&closest.rejected, u), u.sentence(&closest.rejected.reason));
    let mut out = format!("Nothing fits. Closest: {muscle}: {reason}\n");
    if closest.relaxations.is_empty() {
        out.push_str("None of the limits, relaxed alone, makes one of these muscles fit.\n");
        return out;
    }
    out.push_str("Relax one of these:\n");
    for relaxation in &closest.relaxations {
        let line = match relaxation {
            Relaxation::MaxPressure { pressure_mpa, extrapolated } => {
                let far = if *extrapolated { " (extrapolated: outside of the model's range)" } else { "" };
                format!("raise the maximum pressure to {}{far}", u.pressure.show(*pressure_mpa))
            }
            Relaxation::Force { points } => {
                let each = |q: &OperatingPoint| {
                    format!("{} at {}", u.force.show(q.force_n.trunc()), percent(q.contraction))
                };
                format!("reduce the pull to {}", points.iter().map(each).collect::<Vec<_>>().join(" and "))
            }
            Relaxation::Contraction { points } => {
                let floor = |v: f64| percent((v * 1e4).trunc() / 1e4);
                let each =
                    |q: &OperatingPoint| format!("{} for {}", floor(q.contraction), u.force.show(q.force_n));
                let each = points.iter().map(each).collect::<Vec<_>>().join(" and ");
                format!("reduce the contraction to {each}")
            }
            Relaxation::OuterDiameter { outer_diameter_mm, model, scaled_to } => {
                let scaled = scaled_to.as_ref().map_or_else(String::new, |m| format!(", scaled to {m} here"));
                let diameter = u.length.show(*outer_diameter_mm);
                format!("take an outer diameter of {diameter} (by the {model} model{scaled})")
            }
            Relaxation::MaxBulgedDiameter { bulged_diameter_mm } => {
                let diameter = (bulged_diameter_mm * 10.0).ceil() / 10.0;
                format!("allow a bulged diameter of {}", u.length.show(diameter))
            }
            Relaxation::MaxStretch { max_stretch } => {
                format!("allow a stretch of {}", number((max_stretch * 100.0).ceil() / 100.0, 3))
            }
            Relaxation::MaxStrandStrain { strand_strain } => {
                format!("allow a strand strain of {}", percent((strand_strain * 1e4).ceil() / 1e4))
            }
            Relaxation::MaxLiquidVolume { liquid_volume_mm3 } => {
                let volume = number((liquid_volume_mm3 * 0.1).ceil() / 100.0, 4);
                format!("provide {volume} mL of liquid for each muscle")
            }
            Relaxation::Guided {} => "guide the muscle, so that it cannot buckle (--guided)".into(),
            Relaxation::MinBurstMargin { burst_margin } => {
                format!("reduce the safety factor to {}", number((burst_margin * 100.0).floor() / 100.0, 3))
            }
        };
        out.push_str(&format!("  - {line}\n"));
    }
    out
}
