//! `check` as rows.

use super::{Row, estimated};
use crate::{
    Characteristics, CheckAnswer, PressureLimits, Units, number, percent, words::air, words::braid_name,
    words::law_text, words::rubber_name,
};
use mckibben::muscle::{Bulk, EndFactor, Muscle};
use mckibben::{analysis::SAFETY, rubber::RubberLaw};

/// A heading and its rows.
pub type Sheet = (&'static str, Vec<Row>);

/// What was understood of a muscle, what follows from it, and how to build it.
pub fn muscle_sheets(answer: &CheckAnswer, u: &Units) -> [Sheet; 3] {
    [
        ("Muscle", understood(answer, u)),
        ("Derived", derived(answer, u)),
        ("Build sheet", build_rows(answer, u)),
    ]
}

/// Values at one pressure.
pub fn characteristic_rows(c: &Characteristics, u: &Units) -> Vec<Row> {
    let or_dash = |v: Option<f64>, show: &dyn Fn(f64) -> String| v.map_or_else(|| "–".into(), show);
    let blocked = match c.blocked_force_uncertainty_n {
        Some(half) => {
            let value = u.force.within(c.blocked_force_n, Some(half));
            format!("{value} ± {} {}", u.force.half_width(half), u.force.name)
        }
        None => u.force.show(c.blocked_force_n),
    };
    let mut rows = vec![
        ("blocked force", blocked),
        ("free contraction", or_dash(c.free_contraction, &percent)),
        ("work of a free stroke", or_dash(c.work_j, &|v| format!("{} J", number(v, 4)))),
        ("cavity at its end", or_dash(c.volume_mm3, &|v| u.volume.show(v))),
        ("air of a free stroke", or_dash(c.air_normal_litres, &air)),
    ];
    let limits = limit_rows(&c.limits, "", u);
    rows.extend(if limits.is_empty() { vec![("burst pressure", "not stated".into())] } else { limits });
    rows
}

/// What the muscle bears.
pub fn limit_rows(limits: &PressureLimits, estimate: &str, u: &Units) -> Vec<Row> {
    let burst = limits.burst_pressure_mpa.map(|p| {
        let by = limits.burst_by.map(|by| format!("; there {by}")).unwrap_or_default();
        ("burst pressure", u.pressure.show(p) + &by + estimate)
    });
    let allowed = limits.allowed_pressure_mpa.map(|p| {
        let why = match limits.allowed_by {
            Some(by) => format!("safety factor {} where {by}", number(SAFETY * by.share(), 3)),
            None => "the fittings are rated for it".into(),
        };
        ("allowed pressure", format!("{}; {why}", u.pressure.show(p)))
    });
    burst.into_iter().chain(allowed).collect()
}

/// How far the muscle stretches its rubber, and how far the rubber is known.
fn reach(m: &Muscle) -> String {
    let known = m.tube().rubber.fitted_to_stretch;
    let known = known.map_or_else(String::new, |end| format!(", fitted up to {}", number(end, 3)));
    let place = if m.is_extensile() { "along the tube" } else { "at the bore" };
    format!("{} {place}{known}", number(m.reach(), 3))
}

fn understood(answer: &CheckAnswer, u: &Units) -> Vec<Row> {
    let m = &answer.muscle;
    let mm = |v: f64| u.length.show(v);
    let rubber = &m.tube().rubber;
    let bulk = match rubber.bulk {
        Bulk::Incompressible => "incompressible".to_owned(),
        Bulk::Modulus(k) => format!("{} MPa", number(k, 4)),
    };
    let stiffness = match m.family_stiffness_n_per_mm() {
        Some(k) => format!("{} ({} a strand family)", braid_name(m), u.stiffness().show(k)),
        None => "inextensible".into(),
    };
    let mut rows = vec![
        ("outer diameter D0", mm(m.outer_diameter_mm())),
        ("wall s", mm(m.wall_mm())),
        ("length L0", mm(m.length_mm())),
        ("braid angle θ0", format!("{}°", number(m.braid().angle_deg, 5))),
        ("rubber", rubber_name(m)),
        ("law", law_text(&rubber.law)),
        ("largest stretch", reach(m)),
        ("shear modulus", format!("{} MPa", number(rubber.law.shear_modulus_mpa(), 4))),
        ("bulk modulus", bulk),
        ("braid", stiffness),
        ("strands in compression", if m.braid().compression { "carry load" } else { "go slack" }.into()),
    ];
    let factor = m.braid().stiffness_factor;
    if factor > 1.0 {
        rows.push(("stiffness known within", format!("a factor of {}", number(factor, 3))));
    }
    if let Some(s) = m.braid().strands {
        let estimate = estimated(&answer.summary);
        rows.push(("strands", format!("{}{estimate}", s.count)));
        rows.extend(s.strength_n.map(|strength| ("strand strength", u.force.show(strength) + estimate)));
    }
    match m.terminals().end_factor {
        Some(EndFactor::Constant(k)) => rows.push(("end factor", number(k, 4))),
        Some(EndFactor::OfPressure { a, b }) => {
            rows.push(("end factor", format!("{} e^(−P/bar) + {}", number(a, 4), number(b, 4))));
        }
        None => {}
    }
    let stated = answer.stated.iter().filter(|(measure, _)| measure.is_shown);
    rows.extend(stated.map(|(measure, v)| (measure.label(), u.show(measure.dimension, v))));
    if let Some(f) = m.friction() {
        let rule = format!("± {} · (P/MPa)^{}", u.force.show(f.coefficient), number(f.exponent, 3));
        let contact = format!("of the strands' contact, μw {}", mm(f.lever_mm));
        rows.push((
            "friction",
            match (f.coefficient > 0.0, f.lever_mm > 0.0) {
                (true, true) => format!("{rule}, and {contact}"),
                (false, true) => contact,
                _ => rule,
            },
        ));
    }
    rows
}

fn derived(answer: &CheckAnswer, u: &Units) -> Vec<Row> {
    let m = &answer.muscle;
    let mm = |v: f64| u.length.show(v);
    let mut rows = vec![
        ("kind", m.kind().to_string()),
        ("inner diameter", mm(m.inner_diameter_mm())),
        ("strand length", mm(m.strand_length_mm())),
        ("turns of a strand", number(m.turns(), 4)),
        ("strand length per turn", mm(m.strand_length_per_turn_mm())),
        ("largest ideal contraction", percent(m.max_ideal_contraction())),
        ("cavity at rest", u.volume.show(answer.derived.volume_mm3)),
    ];
    let mass = |g: f64| ("mass of the rubber", format!("{} g, without braid and terminals", number(g, 4)));
    let both = |g: f64| ("mass of tube and sleeve", format!("{} g, without terminals", number(g, 4)));
    rows.extend(answer.summary.mass_g.map(both).or(answer.summary.rubber_mass_g.map(mass)));
    rows
}

/// What to cut and clamp.
fn build_rows(answer: &CheckAnswer, u: &Units) -> Vec<Row> {
    let m = &answer.muscle;
    let mm = |v: f64| u.length.show(v);
    let sheet = &answer.build_sheet;
    let assumed = if m.terminals().insertion_mm.is_none() { ", assumed" } else { "" };
    let fit = if m.terminals().plug_diameter_mm.is_none() { ", and what a tight fit adds" } else { "" };
    let clamp = mm(m.terminals().insertion_mm()) + assumed;
    vec![
        ("tube to cut", format!("{} ({clamp} on each plug)", mm(sheet.tube_cut_mm))),
        ("braid to cut", format!("{} at {}°", mm(sheet.braid_cut_mm), number(m.braid().angle_deg, 4))),
        ("strand in the braid", mm(sheet.strand_cut_mm)),
        ("plug diameter", mm(sheet.plug_diameter_mm) + fit),
        (
            "strands",
            sheet
                .strands
                .map_or_else(|| "not stated".into(), |n| format!("{n}{}", estimated(&answer.summary))),
        ),
        ("rubber", u.volume.show(sheet.rubber_volume_mm3)),
    ]
}
