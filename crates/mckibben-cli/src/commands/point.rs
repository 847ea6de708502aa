//! `force`, `pressure`, `contraction`: one point.

use crate::failure::Failure;
use crate::flags::{LoadFlag, ModelFlags, MuscleFlags, OutputFlags};
use crate::format::Format;
use crate::output::loaded::loaded;
use crate::output::text::{Units, number, pairs, percent};
use crate::output::{burst_first, show};
use crate::progress::Bar;
use crate::quantities::{contraction as contraction_ratio, quantity};
use crate::shown;
use clap::Args;
use mckibben::answer::Answer;
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
    /// Both branches of the friction hysteresis, and the band between them
    #[arg(long)]
    pub both: bool,
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
    /// Required pull
    #[arg(short = 'F', long, value_name = "FORCE", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Contraction ratio ΔL/L0 [0]
    #[arg(short = 'e', long, value_name = "RATIO", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Both branches of the friction hysteresis, and the band between them
    #[arg(long)]
    pub both: bool,
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
    /// Required pull [0N: free contraction]
    #[arg(short = 'F', long, value_name = "FORCE", allow_hyphen_values = true)]
    pub force: Option<String>,
    #[command(flatten)]
    pub load: LoadFlag,
    /// Gauge pressure
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Both branches of the friction hysteresis, and the band between them
    #[arg(long)]
    pub both: bool,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// F(P, ε).
pub fn force(args: &ForceArgs, format: Format) -> Result<u8, Failure> {
    let answer = mckibben_app::force(
        &ForceRequest {
            muscle: args.muscle.fields()?,
            model: args.model.fields()?,
            asking: args.model.asking.fields(),
            pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
            contraction: contraction_ratio("--contraction", args.contraction.as_deref())?,
            both: args.both,
        },
        &Bar::hidden(),
    )?;
    print(&answer, Asked::Force, format, &args.output)
}

/// P(F, ε).
pub fn pressure(args: &PressureArgs, format: Format) -> Result<u8, Failure> {
    let answer = mckibben_app::pressure(
        &PressureRequest {
            muscle: args.muscle.fields()?,
            model: args.model.fields()?,
            asking: args.model.asking.fields(),
            force_n: quantity("--force", args.force.as_deref(), Dimension::Force)?,
            contraction: contraction_ratio("--contraction", args.contraction.as_deref())?,
            both: args.both,
        },
        &Bar::hidden(),
    )?;
    print(&answer, Asked::Pressure, format, &args.output)
}

/// ε(F, P).
pub fn contraction(args: &ContractionArgs, format: Format) -> Result<u8, Failure> {
    let answer = mckibben_app::contraction(
        &ContractionRequest {
            muscle: args.muscle.fields()?,
            model: args.model.fields()?,
            asking: args.model.asking.fields(),
            force_n: quantity("--force", args.force.as_deref(), Dimension::Force)?,
            load: args.load.fields()?,
            pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
            both: args.both,
        },
        &Bar::hidden(),
    )?;
    print(&answer, Asked::Contraction, format, &args.output)
}

fn print(answer: &PointAnswer, asked: Asked, format: Format, output: &OutputFlags) -> Result<u8, Failure> {
    let text = || burst_first(&answer.point.warnings) + &text(answer, asked, &shown::units());
    show(answer, format, "", text, output.target())?;
    Ok(0)
}

/// What a command finds.
#[derive(Debug, Clone, Copy)]
enum Asked {
    Force,
    Pressure,
    Contraction,
}

impl Asked {
    fn of(self, answer: &Answer) -> f64 {
        match self {
            Self::Force => answer.response.force_n,
            Self::Pressure => answer.response.pressure_mpa,
            Self::Contraction => answer.response.contraction,
        }
    }

    fn show(self, value: f64, u: &Units) -> String {
        match self {
            Self::Force => u.force.show(value),
            Self::Pressure => u.pressure.show(value),
            Self::Contraction => percent(value),
        }
    }
}

fn text(answer: &PointAnswer, asked: Asked, u: &Units) -> String {
    let (a, r) = (&answer.point, &answer.point.response);
    // The ± belongs to what was asked; the rest was given.
    let unknown = || "unknown".to_owned();
    let pull = match asked {
        _ if a.slack => format!("{} (slack: the muscle would have to push)", u.force.show(0.0)),
        Asked::Force => {
            let half = a.uncertainty_n.map_or_else(unknown, |e| u.force.to(e, 2));
            format!("{} ± {half} {}", u.force.within(r.force_n, a.uncertainty_n), u.force.name)
        }
        _ => u.force.show(r.force_n),
    };
    let pressure = match asked {
        Asked::Pressure => {
            let half = a.pressure_uncertainty_mpa;
            let value = u.pressure.within(r.pressure_mpa, half);
            format!("{value} ± {} {}", half.map_or_else(unknown, |v| u.pressure.to(v, 2)), u.pressure.name)
        }
        _ => u.pressure.show(r.pressure_mpa),
    };
    let half = match asked {
        Asked::Contraction => {
            let half = a.contraction_uncertainty.map_or_else(unknown, |v| number(100.0 * v, 2));
            format!(" ± {half} %")
        }
        _ => String::new(),
    };
    let ratio = match half.is_empty() {
        true => percent(r.contraction),
        false => format!("{}{half}", percent(r.contraction).trim_end_matches(" %")),
    };
    let shortening = u.length.to(r.contraction * answer.muscle.length_mm, 4);
    let mut list = vec![
        ("muscle", answer.muscle.line(u)),
        ("model", format!("{} ({})", a.model, answer.about.source)),
        ("pressure", pressure),
        ("contraction", format!("{ratio}  ({shortening} {})", u.length.name)),
        ("pull", pull),
    ];
    if let [shortening, lengthening] = &answer.branches[..] {
        let of = |branch: &Answer| match asked {
            Asked::Force if branch.slack => "slack".to_owned(),
            _ => asked.show(asked.of(branch), u),
        };
        let band = (asked.of(lengthening) - asked.of(shortening)).abs();
        list.push(("while shortening", of(shortening)));
        list.push(("while lengthening", of(lengthening)));
        list.push(("friction's band", asked.show(band, u)));
    }
    let mut add = |name, value: Option<f64>, show: &dyn Fn(f64) -> String| {
        list.extend(value.map(|v| (name, show(v))));
    };
    let (stiffness, slope) = (u.stiffness(), u.slope());
    add("stiffness", r.stiffness_n_per_mm, &|v| stiffness.show(v));
    add("pull per pressure", r.force_per_pressure_mm2, &|v| slope.show(v));
    add("starts to pull at", a.start_pressure_mpa, &|v| u.pressure.show(v));
    add("free contraction", a.free_contraction, &percent);
    add("bulged diameter", r.bulged_diameter_mm, &|v| format!("{} {}", u.length.to(v, 4), u.length.name));
    add("volume", r.volume_mm3, &|v| u.volume.show(v));
    let tension = |v| format!("{} {}", u.force.to(v, 4), u.force.name);
    add("tension of one strand", r.strand_tension_n, &tension);
    add("tension of all strands", r.braid_tension_n, &tension);
    add("burst pressure", answer.burst_pressure_mpa, &|v| u.pressure.show(v));
    add("stretch of the rubber at mid-length, inside", r.middle_stretch, &|v| number(v, 3));
    add("99 % of the rubber is stretched by less than", r.max_stretch, &|v| number(v, 3));
    if let Some(parts) = &a.uncertainty_parts_n {
        let mut named: Vec<(&str, f64)> = parts.named().collect();
        named.sort_by(|a, b| b.1.total_cmp(&a.1));
        let each: Vec<String> =
            named.into_iter().map(|(name, part)| format!("{name} {}", u.force.to(part, 2))).collect();
        let (whole, force) = (u.force.to(parts.total_n(), 2), &u.force.name);
        let of = match asked {
            Asked::Force => "",
            _ => " of the pull",
        };
        list.push((
            "uncertainty",
            format!("± {whole} {force}{of} (95 %): {} (mckibben models {})", each.join(", "), a.model),
        ));
    }
    pairs(&list) + &answer.loaded.as_ref().map_or_else(String::new, |load| loaded(load, u))
}
