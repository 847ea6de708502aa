//! `force`, `pressure`, `contraction`: one point.

use crate::failure::Failure;
use crate::flags::{Format, ModelFlags, MuscleFlags, OutputFlags, pressure_unit};
use crate::output::text::{PressureUnit, number, pairs, percent, plus_minus};
use crate::output::{show, warn};
use crate::quantities::{contraction as contraction_ratio, quantity};
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{ContractionRequest, ForceRequest, PointAnswer, PressureRequest};

/// `force`.
#[derive(Debug, Args)]
pub struct ForceArgs {
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    /// Gauge pressure
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Contraction ratio ΔL/L0 [0]
    #[arg(short = 'e', long, value_name = "RATIO", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `pressure`.
#[derive(Debug, Args)]
pub struct PressureArgs {
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    /// Pull wanted
    #[arg(short = 'F', long, value_name = "FORCE", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Contraction ratio ΔL/L0 [0]
    #[arg(short = 'e', long, value_name = "RATIO", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `contraction`.
#[derive(Debug, Args)]
pub struct ContractionArgs {
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    /// Pull wanted [0N: free contraction]
    #[arg(short = 'F', long, value_name = "FORCE", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Gauge pressure
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// F(P, ε).
pub fn force(args: &ForceArgs, format: Format) -> Result<u8, Failure> {
    let answer = mckibben_app::force(&ForceRequest {
        muscle: args.muscle.fields(None)?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
        contraction: contraction_ratio("--contraction", args.contraction.as_deref())?,
    })?;
    print(&answer, format, &args.output, args.pressure.as_deref())
}

/// P(F, ε).
pub fn pressure(args: &PressureArgs, format: Format) -> Result<u8, Failure> {
    let answer = mckibben_app::pressure(&PressureRequest {
        muscle: args.muscle.fields(None)?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        force_n: quantity("--force", args.force.as_deref(), Dimension::Force)?,
        contraction: contraction_ratio("--contraction", args.contraction.as_deref())?,
    })?;
    print(&answer, format, &args.output, None)
}

/// ε(F, P).
pub fn contraction(args: &ContractionArgs, format: Format) -> Result<u8, Failure> {
    let answer = mckibben_app::contraction(&ContractionRequest {
        muscle: args.muscle.fields(None)?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        force_n: quantity("--force", args.force.as_deref(), Dimension::Force)?,
        pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
    })?;
    print(&answer, format, &args.output, args.pressure.as_deref())
}

fn print(
    answer: &PointAnswer,
    format: Format,
    output: &OutputFlags,
    typed: Option<&str>,
) -> Result<u8, Failure> {
    let text = || {
        answer.point.warnings.iter().for_each(warn);
        text(answer, pressure_unit(output.units, typed))
    };
    show(answer, format, "", text, output.output.as_deref())?;
    Ok(0)
}

fn text(answer: &PointAnswer, p: PressureUnit) -> String {
    let (a, r) = (&answer.point, &answer.point.response);
    let pull = if a.slack {
        "0 N (slack: the muscle would have to push)".to_owned()
    } else {
        format!("{} N  {}", number(r.force_n, 5), plus_minus(a.uncertainty_n))
    };
    let shortening = number(r.contraction * answer.muscle.length_mm, 4);
    let mut list = vec![
        ("muscle", answer.muscle.line()),
        ("model", format!("{} ({})", a.model, answer.about.source)),
        ("pressure", p.show(r.pressure_mpa)),
        ("contraction", format!("{}  ({shortening} mm)", percent(r.contraction))),
        ("pull", pull),
    ];
    let mut add = |name, value: Option<f64>, unit: &str, digits| {
        if let Some(v) = value {
            list.push((name, format!("{} {unit}", number(v, digits)).trim_end().to_owned()));
        }
    };
    add("stiffness", r.stiffness_n_per_mm, "N/mm", 4);
    let per_unit = format!("N/{}", p.name());
    add("pull per pressure", r.force_per_pressure_mm2.map(|v| v / p.value(1.0)), &per_unit, 4);
    add("starts to pull at", a.start_pressure_mpa.map(|v| p.value(v)), p.name(), 4);
    add("free contraction", a.free_contraction.map(|v| 100.0 * v), "%", 4);
    add("bulged diameter", r.bulged_diameter_mm, "mm", 4);
    add("volume", r.volume_mm3.map(|v| v * 1e-3), "cm³", 4);
    add("tension of one strand", r.strand_tension_n, "N", 4);
    add("tension of all strands", r.braid_tension_n, "N", 4);
    add("stretch of the rubber in the middle", r.middle_stretch, "", 3);
    add("99 % of it stretched by less than", r.max_stretch, "", 3);
    if let Some(parts) = &a.uncertainty_parts_n {
        let each: Vec<String> =
            parts.named().map(|(name, part)| format!("{name} {}", number(part, 2))).collect();
        let of = each.join(", ");
        list.push((
            "the ± is",
            format!("95 %, against a measured muscle: {of} N (mckibben models {})", a.model),
        ));
    }
    pairs(&list)
}
