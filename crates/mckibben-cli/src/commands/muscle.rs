//! `muscle show`.

use crate::cli::MuscleShowArgs;
use crate::failure::Failure;
use crate::flags::{Format, PressureUnit};
use crate::output::text::{Pressures, braid_name, law_text, number, or_dash, pairs, percent, rubber_name};
use crate::output::{csv, emit, json, warn};
use crate::resolve;
use mckibben::analysis::{
    Air, air_per_stroke, blocked_force_n, burst_pressure_mpa, free_contraction, work_per_stroke_j,
};
use mckibben::answer::check_range;
use mckibben::model::Workspace;
use mckibben::muscle::{Bulk, EndFactor, Muscle};
use mckibben::rubber::{RubberLaw, library};
use mckibben::units::Dimension;
use serde_json::{Map, Value, json};

/// Shows a muscle.
pub fn show(args: &MuscleShowArgs) -> Result<u8, Failure> {
    let mut flags = args.muscle.clone();
    flags.muscle = args.file.clone().or(flags.muscle);
    let muscle = resolve::muscle(&flags)?;
    let does = match resolve::quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)? {
        Some(p) => Some(characteristics(args, &muscle, p)?),
        None => None,
    };
    let mut value = as_json(&muscle);
    if let (Some(map), Some(does)) = (value.as_object_mut(), &does) {
        map.insert("characteristics".into(), does.as_json());
    }
    let text = match args.output.format {
        Format::Json => json::print(&value),
        Format::Csv => csv::rows(&[flat(&value)])?,
        Format::Text => {
            for warning in library::warnings(&muscle.tube().rubber) {
                warn(warning);
            }
            let typed = PressureUnit::typed(args.pressure.as_deref());
            let p = Pressures(args.output.units.or(typed).unwrap_or(PressureUnit::Mpa));
            let does = does.map_or_else(String::new, |d| d.as_text(p));
            format!("{}{does}", as_text(&muscle))
        }
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(0)
}

/// What a muscle does at one pressure.
struct Characteristics {
    model: String,
    pressure_mpa: f64,
    blocked_force_n: f64,
    free_contraction: Option<f64>,
    work_j: Option<f64>,
    air: Option<Air>,
    burst_pressure_mpa: Option<f64>,
}

fn characteristics(
    args: &MuscleShowArgs,
    muscle: &Muscle,
    pressure_mpa: f64,
) -> Result<Characteristics, Failure> {
    let model = resolve::model(&args.model, muscle, (pressure_mpa, pressure_mpa))?;
    let model = model.as_ref();
    let w = &mut Workspace::new();
    let extrapolate = args.model.asking.extrapolate;
    check_range(model, pressure_mpa, 0.0, resolve::options(&args.model.asking))?;
    let blocked_force_n = blocked_force_n(model, w, pressure_mpa)?;
    let free = free_contraction(model, w, pressure_mpa, extrapolate).ok();
    Ok(Characteristics {
        model: model.name().into(),
        pressure_mpa,
        blocked_force_n,
        free_contraction: free,
        work_j: free.and_then(|e| work_per_stroke_j(model, w, pressure_mpa, 0.0, e).ok()),
        air: free.and_then(|e| air_per_stroke(model, w, pressure_mpa, e).ok()),
        burst_pressure_mpa: burst_pressure_mpa(model, w, 0.0).ok().flatten(),
    })
}

impl Characteristics {
    fn as_json(&self) -> Value {
        json!({
            "model": self.model,
            "pressure_mpa": self.pressure_mpa,
            "blocked_force_n": self.blocked_force_n,
            "free_contraction": self.free_contraction,
            "work_j": self.work_j,
            "volume_mm3": self.air.map(|a| a.volume_mm3),
            "air_normal_litres": self.air.map(|a| a.normal_litres),
            "burst_pressure_mpa": self.burst_pressure_mpa,
        })
    }

    fn as_text(&self, p: Pressures) -> String {
        let burst = or_dash(self.burst_pressure_mpa, |v| p.show(v));
        let list = [
            ("blocked force", format!("{} N", number(self.blocked_force_n, 5))),
            ("free contraction", or_dash(self.free_contraction, percent)),
            ("work of a free stroke", or_dash(self.work_j, |v| format!("{} J", number(v, 4)))),
            ("cavity at its end", or_dash(self.air, |a| format!("{} cm³", number(a.volume_mm3 * 1e-3, 4)))),
            (
                "air of a free stroke",
                or_dash(self.air, |a| format!("{} normal litres", number(a.normal_litres, 4))),
            ),
            ("strands break at", if self.burst_pressure_mpa.is_some() { burst } else { "not stated".into() }),
        ];
        format!("\nAt {}, model {}\n{}", p.show(self.pressure_mpa), self.model, pairs(&list))
    }
}

fn as_json(m: &Muscle) -> Value {
    let sheet = m.build_sheet();
    let law = &m.tube().rubber.law;
    let constants: Map<String, Value> =
        law.constants().into_iter().map(|(name, value, _)| (name, json!(value))).collect();
    let mut out = json::muscle(m);
    let more = json!({
        "law": law.name(),
        "constants_mpa": constants,
        "shear_modulus_mpa": law.shear_modulus_mpa(),
        "bulk_modulus_mpa": match m.tube().rubber.bulk { Bulk::Incompressible => Value::Null, Bulk::Modulus(k) => json!(k) },
        "stiffness_n_per_mm": m.family_stiffness_n_per_mm(),
        "derived": {
            "inner_diameter_mm": m.inner_diameter_mm(),
            "strand_length_mm": m.strand_length_mm(),
            "turns": m.turns(),
            "strand_length_per_turn_mm": m.strand_length_per_turn_mm(),
            "max_ideal_contraction": m.max_ideal_contraction(),
            "volume_mm3": m.rest_volume_mm3(),
        },
        "build_sheet": {
            "tube_cut_mm": sheet.tube_cut_mm,
            "braid_cut_mm": sheet.braid_cut_mm,
            "plug_diameter_mm": sheet.plug_diameter_mm,
            "strand_cut_mm": sheet.strand_cut_mm,
            "strands": sheet.strands,
            "rubber_volume_mm3": sheet.rubber_volume_mm3,
        },
        "warnings": library::warnings(&m.tube().rubber).iter().map(ToString::to_string).collect::<Vec<_>>(),
    });
    if let (Some(out), Value::Object(more)) = (out.as_object_mut(), more) {
        out.extend(more);
    }
    out
}

/// Nested objects laid flat, for one CSV row.
fn flat(value: &Value) -> Value {
    let mut out = Map::new();
    for (key, value) in value.as_object().into_iter().flatten() {
        match value.as_object() {
            Some(inner) => out.extend(inner.clone()),
            None => drop(out.insert(key.clone(), value.clone())),
        }
    }
    Value::Object(out)
}

fn as_text(m: &Muscle) -> String {
    let mm = |v: f64| format!("{} mm", number(v, 5));
    let rubber = &m.tube().rubber;
    let bulk = match rubber.bulk {
        Bulk::Incompressible => "incompressible".to_owned(),
        Bulk::Modulus(k) => format!("{} MPa", number(k, 4)),
    };
    let stiffness = match m.family_stiffness_n_per_mm() {
        Some(k) => format!("{} ({} N/mm a strand family)", braid_name(m), number(k, 4)),
        None => "inextensible".into(),
    };
    let mut understood = vec![
        ("outer diameter D0", mm(m.outer_diameter_mm())),
        ("wall s", mm(m.wall_mm())),
        ("length L0", mm(m.length_mm())),
        ("braid angle θ0", format!("{}°", number(m.braid().angle_deg, 5))),
        ("rubber", rubber_name(m)),
        ("law", law_text(&rubber.law)),
        ("shear modulus", format!("{} MPa", number(rubber.law.shear_modulus_mpa(), 4))),
        ("bulk modulus", bulk),
        ("braid", stiffness),
        ("strands in compression", if m.braid().compression { "carry it" } else { "go slack" }.into()),
    ];
    if let Some(s) = m.braid().strands {
        understood.push(("strands", s.count.to_string()));
        if let Some(strength) = s.strength_n {
            understood.push(("strand strength", format!("{} N", number(strength, 4))));
        }
    }
    match m.terminals().end_factor {
        Some(EndFactor::Constant(k)) => understood.push(("end factor", number(k, 4))),
        Some(EndFactor::OfPressure { a, b }) => {
            understood.push(("end factor", format!("{} e^(−P/bar) + {}", number(a, 4), number(b, 4))));
        }
        None => {}
    }
    if let Some(f) = m.friction() {
        let text = format!("± {} N · (P/MPa)^{}", number(f.coefficient, 4), number(f.exponent, 3));
        understood.push(("friction", text));
    }
    let derived = [
        ("inner diameter", mm(m.inner_diameter_mm())),
        ("strand length", mm(m.strand_length_mm())),
        ("turns of a strand", number(m.turns(), 4)),
        ("strand length per turn", mm(m.strand_length_per_turn_mm())),
        ("largest ideal contraction", percent(m.max_ideal_contraction())),
        ("cavity at rest", format!("{} cm³", number(m.rest_volume_mm3() * 1e-3, 4))),
    ];
    let sheet = m.build_sheet();
    let clamp = number(m.terminals().insertion_mm, 4);
    let build = [
        ("tube to cut", format!("{} ({clamp} mm on each plug)", mm(sheet.tube_cut_mm))),
        ("braid to cut", format!("{} at {}°", mm(sheet.braid_cut_mm), number(m.braid().angle_deg, 4))),
        ("strand in it", mm(sheet.strand_cut_mm)),
        ("plug diameter", mm(sheet.plug_diameter_mm)),
        ("strands", sheet.strands.map_or_else(|| "not stated".into(), |n| n.to_string())),
        ("rubber", format!("{} cm³", number(sheet.rubber_volume_mm3 * 1e-3, 4))),
    ];
    format!(
        "Understood\n{}\nDerived\n{}\nBuild sheet\n{}",
        pairs(&understood),
        pairs(&derived),
        pairs(&build)
    )
}
