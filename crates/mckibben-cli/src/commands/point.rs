//! `force`, `pressure`, `contraction`: one point.

use crate::failure::Failure;
use crate::flags::{LoadFlag, ModelFlags, MuscleFlags, OutputFlags};
use crate::format::Format;
use crate::output::loaded::loaded;
use crate::output::text::pairs;
use crate::output::{burst_first, show};
use crate::progress::Bar;
use crate::quantities::{contraction as contraction_ratio, quantity};
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::rows::point_rows;
use mckibben_app::{ContractionRequest, ForceRequest, PointAnswer, PointQuantity, PressureRequest};

/// `force`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct ForceArgs {
    /// Gauge pressure
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Contraction ratio ΔL/L0 [0]
    #[arg(short = 'e', long, value_name = "RATIO", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Both branches of the friction hysteresis
    ///
    /// The band between them is printed as well.
    #[arg(long)]
    pub both: bool,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `pressure`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct PressureArgs {
    /// Required pull
    #[arg(short = 'F', long, value_name = "FORCE", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Contraction ratio ΔL/L0 [0]
    #[arg(short = 'e', long, value_name = "RATIO", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Both branches of the friction hysteresis
    ///
    /// The band between them is printed as well.
    #[arg(long)]
    pub both: bool,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `contraction`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct ContractionArgs {
    /// Gauge pressure
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Required pull [0N: free contraction]
    #[arg(short = 'F', long, value_name = "FORCE", allow_hyphen_values = true)]
    pub force: Option<String>,
    #[command(flatten)]
    pub load: LoadFlag,
    /// Both branches of the friction hysteresis
    ///
    /// The band between them is printed as well.
    #[arg(long)]
    pub both: bool,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
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
    print(&answer, PointQuantity::Force, format, &args.output)
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
    print(&answer, PointQuantity::Pressure, format, &args.output)
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
    print(&answer, PointQuantity::Contraction, format, &args.output)
}

fn print(
    answer: &PointAnswer,
    asked: PointQuantity,
    format: Format,
    output: &OutputFlags,
) -> Result<u8, Failure> {
    let text = || {
        let u = shown::units();
        let load = answer.loaded.as_ref().map_or_else(String::new, |load| loaded(load, &u));
        burst_first(&answer.point.warnings) + &pairs(&point_rows(answer, asked, &u)) + &load
    };
    show(answer, format, "", text, output.target())?;
    Ok(0)
}
