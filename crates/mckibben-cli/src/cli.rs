//! The commands and their flags. One table: help, completions and parsing come from here.

mod campaign;
mod identify;

pub use campaign::{CampaignArgs, CampaignCommand, CampaignMergeArgs, CampaignRunArgs, CampaignShowArgs};

pub use identify::{BranchesWord, IdentifyArgs, LossWord};

use crate::commands::fit::{FitArgs, FormulaShowArgs};
use crate::commands::rubber_fit::RubberFitArgs;
use crate::flags::{AskFlags, MatchWord, ModelFlags, MuscleFlags, OutputFlags, PlotFlag};
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

const ABOUT: &str = "Design McKibben pneumatic muscles: from a specification to a muscle one can build.

Quantities carry a unit (30mm, 2.5bar, 0.25MPa, 36psi, 28deg, 300N, 10%); a bare number is mm, MPa, N, degrees, \
or a ratio. Ranges are low..high:step (0..2.5:0.1bar), lists are 1,2,3.";

/// The command line.
#[derive(Debug, Parser)]
#[command(name = "mckibben", version, about = ABOUT, disable_help_subcommand = true, max_term_width = 110)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// From a specification to ranked muscles (the main job)
    #[command(after_help = DESIGN_EXAMPLES)]
    Design(Box<DesignArgs>),
    /// Pull at a pressure and contraction: F(P, ε)
    #[command(after_help = "Example:\n  mckibben force -D 50 -s 1 -p 0.25 -e 0.1 --model paper")]
    Force(Box<ForceArgs>),
    /// Pressure that gives a pull at a contraction: P(F, ε)
    #[command(after_help = "Example:\n  mckibben pressure -D 40 -s 2 -F 300N -e 10% --units bar")]
    Pressure(Box<PressureArgs>),
    /// Contraction at which a pressure gives a pull: ε(F, P)
    #[command(after_help = "Example:\n  mckibben contraction -D 40 -s 2 -F 600N -p 2.5bar")]
    Contraction(Box<ContractionArgs>),
    /// A family of curves: isometric, isotonic or isobaric
    #[command(after_help = CURVE_EXAMPLES)]
    Curve(Box<CurveArgs>),
    /// One finite-element test with everything it knows: curves, shape, strands, stretches, sensitivities
    #[command(after_help = SIMULATE_EXAMPLES)]
    Simulate(Box<SimulateArgs>),
    /// Many finite-element tests from a plan, resumable, into Parquet
    #[command(after_help = campaign::CAMPAIGN_EXAMPLES)]
    Campaign(Box<CampaignArgs>),
    /// Verification against exact values and validation against measured muscles
    #[command(after_help = VALIDATE_EXAMPLES)]
    Validate(ValidateArgs),
    /// Several models, and measured points, on one figure with their errors
    #[command(after_help = COMPARE_EXAMPLES)]
    Compare(Box<CompareArgs>),
    /// Constants of rubber, braid and friction from measured or published curves, with their uncertainty
    #[command(after_help = identify::IDENTIFY_EXAMPLES)]
    Identify(Box<IdentifyArgs>),
    /// From a table of finite-element points to a formula, with its errors and where it holds
    #[command(after_help = FIT_EXAMPLES)]
    Fit(Box<FitArgs>),
    /// Fitted formulas
    #[command(subcommand)]
    Formula(FormulaCommand),
    /// What was understood of a muscle, what follows from it, and a build sheet
    #[command(subcommand)]
    Muscle(MuscleCommand),
    /// Named rubbers
    #[command(subcommand)]
    Rubber(RubberCommand),
    /// The force models: what they are, their source, and where they hold
    #[command(after_help = "Example:\n  mckibben models")]
    Models(ModelsArgs),
    /// Shell completions, written to standard output
    #[command(after_help = "Example:\n  mckibben completions bash")]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

// Lines of at most 78 characters, continued by a backslash: the help is wrapped to the terminal, and a wrapped command
// cannot be pasted.
const DESIGN_EXAMPLES: &str = "Examples:
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar
  mckibben design --at 700N@15%,1200N@5% --max-pressure 2.5bar \\
    --max-bulged-diameter 80mm --plot muscle.svg
  mckibben design -F 300N --stroke 40mm --length 285 --max-pressure 3bar \\
    -D 20..40:5 -s 1,1.5,2 --rubber dragon-skin-30
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar \\
    --tolerance wall=0.1mm,pressure=0.1bar -o winner.toml";

const CURVE_EXAMPLES: &str = "Examples:
  mckibben curve isobaric -D 50 -s 1 -p 0.05..0.25:0.05 -e 0..0.2:0.01 \\
    --plot f.svg
  mckibben curve isometric -p 0..2.5:0.1bar -e 0,10%,20% --format csv
  mckibben curve isotonic -F 20,80,150N --model thick-wall
  mckibben curve --study thickness --model thick-wall --plot study.svg";

const SIMULATE_EXAMPLES: &str = "Examples:
  mckibben simulate examples/prototype.toml -e 10% -p 0..0.25:0.05 --vtu out/
  mckibben simulate -D 40 -s 2 --test isotonic -F 150N -p 0.5..2.5:0.5bar \\
    --plot shape.svg
  mckibben simulate -e 15% -p 0.25 --picture muscle.png --show stress_hoop_mpa --cut
  mckibben simulate --model fe3d --match angle -e 10% -p 0.01..0.25:0.01 \\
    --export-inp muscle.inp
  mckibben simulate --model fe3d --terminal aluminium:20mm:3mm -e 10% \\
    -p 0.25 --picture plug.png --cut
  mckibben simulate --of-largest -e 0,45%,90% -p 0.25 --format csv";

const VALIDATE_EXAMPLES: &str = "Examples:
  mckibben validate
  mckibben validate --sweep 50";

const FIT_EXAMPLES: &str = "Examples:
  mckibben fit data/campaign/paper.csv --method paper --hold-out 35 \\
    -o formula.json --tables tables --plots plots
  mckibben fit data/campaign/paper.csv --method global --hold-out 35 \\
    -o global.json
  mckibben force -D 35 -s 2 -p 2bar -e 10% --model global.json
  mckibben fit --report";

const FORMULA_EXAMPLES: &str = "Examples:
  mckibben fit data/campaign/paper.csv --method global -o formula.json
  mckibben formula show formula.json
  mckibben formula show formula.json --latex";

const COMPARE_EXAMPLES: &str = "Examples:
  mckibben compare --models ideal,paper,thick-wall -p 1,2bar
  mckibben compare --models ideal,thick-wall --muscle examples/tondu2012.toml \\
    --data data/tondu2012/static_force_20deg.csv --fit modulus,end-factor";

const RUBBER_FIT_EXAMPLES: &str = "Examples:
  mckibben rubber fit data/treloar/tension.csv --law yeoh --relative
  mckibben rubber fit data/silicones/dragon_skin_30.csv --up-to 200% \\
    --plot rubber.svg -o silicone.toml
  mckibben force --muscle silicone.toml -p 2bar -e 10%";

/// `muscle …`.
#[derive(Debug, Subcommand)]
pub enum MuscleCommand {
    /// Show a muscle: what was understood, derived quantities, build sheet
    #[command(
        after_help = "Examples:\n  mckibben muscle show examples/prototype.toml\n  mckibben muscle show -D 40 -s 2 --rubber dragon-skin-30"
    )]
    Show(Box<MuscleShowArgs>),
}

/// `formula …`.
#[derive(Debug, Subcommand)]
pub enum FormulaCommand {
    /// Show a formula: its terms, where it holds, its errors, where it comes from
    #[command(after_help = FORMULA_EXAMPLES)]
    Show(FormulaShowArgs),
}

/// `rubber …`.
#[derive(Debug, Subcommand)]
pub enum RubberCommand {
    /// All named rubbers
    #[command(after_help = "Example:\n  mckibben rubber list")]
    List(RubberListArgs),
    /// One rubber: its laws, constants, source and terms
    #[command(after_help = "Example:\n  mckibben rubber show dragon-skin-30")]
    Show(RubberShowArgs),
    /// Laws from tension tests: constants with their errors, and where they are stable
    #[command(after_help = RUBBER_FIT_EXAMPLES)]
    Fit(Box<RubberFitArgs>),
}

