//! `identify`: constants of a muscle from points.

mod text;

use crate::failure::Failure;
use crate::files;
use crate::flags::{ColumnsFlag, MuscleFlags, PlotFlag, UnitsFlag};
use crate::format::Format;
use crate::names::MODELS;
use crate::output::text::place;
use crate::output::{check_ending, save, show};
use crate::plot;
use crate::progress::Bar;
use crate::quantities::{contractions, pressures, ratio};
use crate::shown;
use crate::word::word;
use clap::Args;
use mckibben::muscle::Measure;
use mckibben::muscle::measures::{OUTER_DIAMETER, WALL};
use mckibben_app::{Branches, IdentifyRequest, MeshFields, ModelFields};
use mckibben_fit::least_squares::Loss;
use std::path::PathBuf;

pub const EXAMPLES: &str = "Examples:
  mckibben identify examples/bench.toml --data examples/bench.csv
  mckibben identify examples/tondu2012.toml \\
    --data data/tondu2012/static_force_20deg.csv --model thick-wall \\
    --free mu,terminals.end_factor,friction.c,friction.beta \\
    --plot fit.svg -o found.toml
  mckibben identify --formula paper -D 50 -s 1 -p 0.05..0.25:0.05 \\
    -e 0..0.2:0.05 --free c10,braid.stiffness=600:100:5000";

/// `identify`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct IdentifyArgs {
    /// Points: a table of pressures, contractions (or shortenings, or lengths) and forces, with units; may be repeated
    #[arg(long, value_name = "FILE.csv")]
    pub data: Vec<PathBuf>,
    #[command(flatten)]
    pub columns: ColumnsFlag,
    /// Free parameters: NAME, NAME=START or NAME=START:LOW:HIGH [modulus; stiffness and friction if the data determine them]
    #[arg(long, value_name = "LIST", value_delimiter = ',', allow_hyphen_values = true)]
    pub free: Vec<String>,
    /// Fix a parameter: NAME=VALUE
    #[arg(long, value_name = "LIST", value_delimiter = ',', allow_hyphen_values = true)]
    pub fix: Vec<String>,
    /// Bounds of free parameters: NAME=LOW:HIGH
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true,
        hide_short_help = true
    )]
    pub bounds: Vec<String>,
    /// Fit every rubber law with its constants free, and show which law fits the points best
    #[arg(long)]
    pub laws: bool,
    /// A published formula as data: a model's name or a formula's JSON, at -p and -e (-D and -s may be lists)
    #[arg(long, value_name = "NAME or FILE.json")]
    pub formula: Option<String>,
    /// Pressures of --formula [0.05..0.25:0.05]
    #[arg(short, long, value_name = "RANGE", allow_hyphen_values = true, requires = "formula")]
    pub pressure: Option<String>,
    /// Contraction ratios of --formula [0..0.2:0.05]
    #[arg(short = 'e', long, value_name = "RANGE", allow_hyphen_values = true, requires = "formula")]
    pub contraction: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    /// Force model [fe]
    #[arg(long, value_name = "NAME", value_parser = MODELS, hide_possible_values = true, help_heading = "Advanced")]
    pub model: Option<String>,
    /// Mesh of `fe`, as for the other commands [automatic]
    #[arg(long, value_name = "N or MxN:G", hide_short_help = true, help_heading = "Advanced")]
    pub mesh: Option<String>,
    /// Weight of each --data, then of --formula [1,1,...]
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true,
        hide_short_help = true,
        help_heading = "Advanced"
    )]
    pub weights: Vec<String>,
    /// Treatment of the branches of the hysteresis
    #[arg(long, value_parser = word::<Branches>(), default_value = "both", hide_short_help = true, help_heading = "Advanced")]
    pub branches: Branches,
    /// Use points with a force of zero or below as measurements; by default the muscle counts as slack there
    #[arg(long, hide_short_help = true, help_heading = "Advanced")]
    pub two_sided: bool,
    /// Loss function of the residuals
    #[arg(long, value_parser = word::<Loss>(), default_value = "squares", hide_short_help = true, help_heading = "Advanced")]
    pub loss: Loss,
    /// The same as --loss huber
    #[arg(long, conflicts_with = "loss", hide_short_help = true, help_heading = "Advanced")]
    pub robust: bool,
    #[command(flatten)]
    pub units: UnitsFlag,
    #[command(flatten)]
    pub plot: PlotFlag,
    /// Write the muscle with the identified values as a muscle file
    #[arg(short, long, value_name = "FILE.toml", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

pub fn run(args: &IdentifyArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    let target = args.output.as_deref();
    check_ending(target, &["toml"])?;
    let mut answer = mckibben_app::identify(&request(args)?, &Bar::new("points"))?;
    plot::save(answer.figure.take(), &args.plot)?;
    save(target, answer.muscle_file.as_bytes())?;
    let text = || {
        let mut text = text::of(&answer, &shown::units());
        if let Some(path) = &args.output {
            text.push_str(&format!("\nThe muscle is in {}.\n", place(path)));
        }
        text
    };
    show(&answer, format, "points", text, None)?;
    Ok(0)
}

fn request(args: &IdentifyArgs) -> Result<IdentifyRequest, Failure> {
    // -D and -s may be lists of a formula's muscles.
    let mut muscle = args.muscle.clone();
    let mut list = |measure: &'static Measure| -> Result<Option<Vec<f64>>, Failure> {
        if args.formula.is_none() { Ok(None) } else { muscle.take_list(measure, 4) }
    };
    let (outer_diameters_mm, walls_mm) = (list(&OUTER_DIAMETER)?, list(&WALL)?);
    let words = [&args.model, &args.formula].into_iter().flatten();
    let formulas = words.map(|word| files::formula(word)).collect::<Result<Vec<_>, _>>()?;
    let weight = |text: &String| Ok(ratio("--weights", Some(text))?.unwrap_or(1.0));
    Ok(IdentifyRequest {
        muscle: muscle.fields()?,
        model: ModelFields {
            model: args.model.clone(),
            formulas: formulas.into_iter().flatten().collect(),
            mesh: MeshFields { mesh: args.mesh.clone(), ..MeshFields::default() },
        },
        data: args.data.iter().map(|path| files::table(path)).collect::<Result<_, _>>()?,
        columns: args.columns.fields()?,
        formula: args.formula.clone(),
        pressures_mpa: pressures(args.pressure.as_deref(), 5)?,
        contractions: contractions(args.contraction.as_deref())?,
        outer_diameters_mm,
        walls_mm,
        weights: args.weights.iter().map(weight).collect::<Result<_, Failure>>()?,
        branches: args.branches,
        two_sided: args.two_sided,
        free: args.free.clone(),
        fix: args.fix.clone(),
        bounds: args.bounds.clone(),
        laws: args.laws,
        loss: if args.robust { Loss::Huber } else { args.loss },
        figure: args.plot.plot.as_ref().map(|_| shown::units()),
    })
}
