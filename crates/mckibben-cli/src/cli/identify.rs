//! Flags of `identify`.

use crate::flags::{Format, MuscleFlags, PlotFlag, PressureUnit};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

pub const IDENTIFY_EXAMPLES: &str = "Examples:
  mckibben identify examples/bench.toml --data examples/bench.csv
  mckibben identify examples/tondu2012.toml \\
    --data data/tondu2012/static_force_20deg.csv --model thick-wall \\
    --free mu,terminals.end_factor,friction.c,friction.beta \\
    --plot fit.svg -o found.toml
  mckibben identify --formula paper -D 50 -s 1 -p 0.05..0.25:0.05 \\
    -e 0..0.2:0.05 --free c10,braid.stiffness=600:100:5000";

/// How residuals count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum LossWord {
    /// By their squares
    #[default]
    Squares,
    /// Those far off less (Huber)
    Huber,
    /// The largest most (sixth powers)
    Largest,
}

/// What is done with the branches of the hysteresis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum BranchesWord {
    /// Both, with the friction between them
    #[default]
    Both,
    /// Their mean
    Mean,
}

/// `identify`.
#[derive(Debug, Args)]
pub struct IdentifyArgs {
    /// Muscle file (TOML) with a value for everything; flags override it
    #[arg(value_name = "MUSCLE.toml", conflicts_with = "muscle")]
    pub file: Option<PathBuf>,
    /// Points (CSV: pressure_mpa, contraction, force_n, and more); may be repeated
    #[arg(long, value_name = "FILE.csv", help_heading = "Data")]
    pub data: Vec<PathBuf>,
    /// A published formula as data: a model's name or a formula's JSON, at -p and -e (-D and -s may be lists)
    #[arg(long, value_name = "NAME or FILE.json", help_heading = "Data")]
    pub formula: Option<String>,
    /// Pressures of --formula [0.05..0.25:0.05]
    #[arg(
        short,
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        requires = "formula",
        help_heading = "Data"
    )]
    pub pressure: Option<String>,
    /// Contraction ratios of --formula [0..0.2:0.05]
    #[arg(
        short = 'e',
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        requires = "formula",
        help_heading = "Data"
    )]
    pub contraction: Option<String>,
    /// How much each --data counts, then --formula [1,1,...]
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help_heading = "Data"
    )]
    pub weights: Vec<String>,
    /// What is done with the branches of the hysteresis
    #[arg(long, value_enum, default_value_t = BranchesWord::Both, help_heading = "Data")]
    pub branches: BranchesWord,
    /// Forces of zero and below are measurements; else the muscle was slack there
    #[arg(long, help_heading = "Data")]
    pub two_sided: bool,
    /// What is free: NAME, NAME=START or NAME=START:LOW:HIGH [modulus, and stiffness and friction where the data tell them]
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help_heading = "Parameters"
    )]
    pub free: Vec<String>,
    /// What is held: NAME=VALUE
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help_heading = "Parameters"
    )]
    pub fix: Vec<String>,
    /// Bounds of what is free: NAME=LOW:HIGH
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help_heading = "Parameters"
    )]
    pub bounds: Vec<String>,
    /// How residuals count
    #[arg(long, value_enum, default_value_t = LossWord::Squares, help_heading = "Parameters")]
    pub loss: LossWord,
    /// The same as --loss huber
    #[arg(long, conflicts_with = "loss", help_heading = "Parameters")]
    pub robust: bool,
    /// Force model
    #[arg(long, value_name = "NAME", default_value = "fe", help_heading = "Model")]
    pub model: String,
    /// Mesh of `fe`, as for the other commands [chosen]
    #[arg(long, value_name = "N or MxN:G", help_heading = "Model")]
    pub mesh: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    /// What is printed: text for people, json, or csv (one row a point, with its residual)
    #[arg(long, value_enum, default_value_t = Format::Text, help_heading = "Output")]
    pub format: Format,
    /// Unit of pressures in figures [MPa]
    #[arg(long, value_enum, value_name = "UNIT", help_heading = "Output")]
    pub units: Option<PressureUnit>,
    #[command(flatten)]
    pub plot: PlotFlag,
    /// Write the muscle with what was found as a muscle file
    #[arg(short, long, value_name = "FILE.toml", help_heading = "Output")]
    pub output: Option<PathBuf>,
}
