//! `muscle show`.

use crate::failure::Failure;
use crate::flags::{ModelFlags, MuscleFlags, OutputFlags};
use crate::format::Format;
use crate::output::text::{Units, braid_name, law_text, number, or_dash, pairs, percent, rubber_name};
use crate::output::{FLAT, burst_first, show as print};
use crate::quantities::quantity;
use crate::shown;
use clap::Args;
use mckibben::muscle::{Bulk, EndFactor, Muscle};
use mckibben::rubber::RubberLaw;
use mckibben::units::Dimension;
use mckibben_app::{Characteristics, MuscleShowAnswer, MuscleShowRequest, muscle_show};

/// `muscle show`.
#[derive(Debug, Args)]
pub struct MuscleShowArgs {
    /// Also show its values at this pressure: blocked force, free contraction, work, air, burst
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// Shows a muscle.
pub fn show(args: &MuscleShowArgs, format: Format) -> Result<u8, Failure> {
    let answer = muscle_show(&MuscleShowRequest {
        muscle: args.muscle.fields()?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
        muscle_file: false,
    })?;
    let path = args.output.target();
    let text = || {
        let burst = burst_first(&answer.warnings);
        let u = shown::units();
        let does = answer.characteristics.as_ref().map(|c| characteristics(c, &u));
        burst + &as_text(&answer, &u) + &does.unwrap_or_default()
    };
    print(&answer, format, FLAT, text, path)?;
    Ok(0)
}

fn characteristics(c: &Characteristics, u: &Units) -> String {
    let list = [
        ("blocked force", u.force.show(c.blocked_force_n)),
        ("free contraction", or_dash(c.free_contraction, percent)),
        ("work of a free stroke", or_dash(c.work_j, |v| format!("{} J", number(v, 4)))),
        ("cavity at its end", or_dash(c.volume_mm3, |v| u.volume.show(v))),
        ("air of a free stroke", or_dash(c.air_normal_litres, |v| format!("{} normal litres", number(v, 4)))),
        ("burst pressure", c.burst_pressure_mpa.map_or_else(|| "not stated".into(), |v| u.pressure.show(v))),
    ];
    format!("\nAt {}, model {}\n{}", u.pressure.show(c.pressure_mpa), c.model, pairs(&list))
}

/// How far the muscle stretches its rubber, and how far the rubber is known.
fn reach_text(m: &Muscle) -> String {
    let known = m.tube().rubber.fitted_to_stretch;
    let known = known.map_or_else(String::new, |end| format!(", fitted up to {}", number(end, 3)));
    format!("{} at the bore{known}", number(m.reach(), 3))
}

fn as_text(answer: &MuscleShowAnswer, u: &Units) -> String {
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
    let mut understood = vec![
        ("outer diameter D0", mm(m.outer_diameter_mm())),
        ("wall s", mm(m.wall_mm())),
        ("length L0", mm(m.length_mm())),
        ("braid angle θ0", format!("{}°", number(m.braid().angle_deg, 5))),
        ("rubber", rubber_name(m)),
        ("law", law_text(&rubber.law)),
        ("largest stretch", reach_text(m)),
        ("shear modulus", format!("{} MPa", number(rubber.law.shear_modulus_mpa(), 4))),
        ("bulk modulus", bulk),
        ("braid", stiffness),
        ("strands in compression", if m.braid().compression { "carry load" } else { "go slack" }.into()),
    ];
    if let Some(s) = m.braid().strands {
        understood.push(("strands", s.count.to_string()));
        if let Some(strength) = s.strength_n {
            understood.push(("strand strength", u.force.show(strength)));
        }
    }
    match m.terminals().end_factor {
        Some(EndFactor::Constant(k)) => understood.push(("end factor", number(k, 4))),
        Some(EndFactor::OfPressure { a, b }) => {
            understood.push(("end factor", format!("{} e^(−P/bar) + {}", number(a, 4), number(b, 4))));
        }
        None => {}
    }
    let stated = answer.stated.iter().map(|(measure, v)| (measure.label, u.show(measure.dimension, v)));
    understood.extend(stated);
    if let Some(f) = m.friction() {
        let rule = format!("± {} · (P/MPa)^{}", u.force.show(f.coefficient), number(f.exponent, 3));
        let contact = format!("of the strands' contact, μw {}", mm(f.lever_mm));
        understood.push((
            "friction",
            match (f.coefficient > 0.0, f.lever_mm > 0.0) {
                (true, true) => format!("{rule}, and {contact}"),
                (false, true) => contact,
                _ => rule,
            },
        ));
    }
    let mut derived = vec![
        ("inner diameter", mm(m.inner_diameter_mm())),
        ("strand length", mm(m.strand_length_mm())),
        ("turns of a strand", number(m.turns(), 4)),
        ("strand length per turn", mm(m.strand_length_per_turn_mm())),
        ("largest ideal contraction", percent(m.max_ideal_contraction())),
        ("cavity at rest", u.volume.show(m.rest_volume_mm3())),
    ];
    let mass = |g: f64| ("mass of the rubber", format!("{} g, without braid and terminals", number(g, 4)));
    derived.extend(answer.summary.rubber_mass_g.map(mass));
    let sheet = m.build_sheet();
    let assumed = if m.terminals().insertion_mm.is_none() { ", assumed" } else { "" };
    let clamp = mm(m.terminals().insertion_mm()) + assumed;
    let build = [
        ("tube to cut", format!("{} ({clamp} on each plug)", mm(sheet.tube_cut_mm))),
        ("braid to cut", format!("{} at {}°", mm(sheet.braid_cut_mm), number(m.braid().angle_deg, 4))),
        ("strand in the braid", mm(sheet.strand_cut_mm)),
        ("plug diameter", mm(sheet.plug_diameter_mm)),
        ("strands", sheet.strands.map_or_else(|| "not stated".into(), |n| n.to_string())),
        ("rubber", u.volume.show(sheet.rubber_volume_mm3)),
    ];
    format!("Muscle\n{}\nDerived\n{}\nBuild sheet\n{}", pairs(&understood), pairs(&derived), pairs(&build))
}
