//! The commands. Each command's flags stand in its own file; help, completions and parsing come from there.

use crate::commands;
use crate::commands::compare::CompareArgs;
use crate::commands::curve::CurveArgs;
use crate::commands::design::DesignArgs;
use crate::commands::identify::IdentifyArgs;
use crate::commands::models::ModelsArgs;
use crate::commands::muscle::MuscleShowArgs;
use crate::commands::point::{ContractionArgs, ForceArgs, PressureArgs};
use crate::commands::rubber::{RubberListArgs, RubberShowArgs};
use crate::commands::rubber_fit::RubberFitArgs;
use crate::commands::schema::SchemaArgs;
use crate::commands::simulate::SimulateArgs;
use crate::commands::validate::ValidateArgs;
use crate::flags::Format;
use clap::{Parser, Subcommand};

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
    /// What is printed: text for people, json or csv for programs
    #[arg(long, value_enum, global = true, default_value_t = Format::Text, help_heading = "Output")]
    pub format: Format,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// From a specification to ranked muscles (the main job)
    #[command(after_help = commands::design::EXAMPLES)]
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
    #[command(after_help = commands::curve::EXAMPLES)]
    Curve(Box<CurveArgs>),
    /// One finite-element test with everything it knows: curves, shape, strands, stretches, sensitivities
    #[command(after_help = commands::simulate::EXAMPLES)]
    Simulate(Box<SimulateArgs>),
    //B     /// Many finite-element tests from a plan, resumable, into Parquet
    //B     #[command(after_help = campaign::CAMPAIGN_EXAMPLES)]
    //B     Campaign(Box<CampaignArgs>),
    /// Verification against exact values and validation against measured muscles
    #[command(after_help = commands::validate::EXAMPLES)]
    Validate(ValidateArgs),
    /// Several models, and measured points, on one figure with their errors
    #[command(after_help = commands::compare::EXAMPLES)]
    Compare(Box<CompareArgs>),
    /// Constants of rubber, braid and friction from measured or published curves, with their uncertainty
    #[command(after_help = commands::identify::EXAMPLES)]
    Identify(Box<IdentifyArgs>),
    //B     /// From a table of finite-element points to a formula, with its errors and where it holds
    //B     #[command(after_help = FIT_EXAMPLES)]
    //B     Fit(Box<FitArgs>),
    //B     /// Fitted formulas
    //B     #[command(subcommand)]
    //B     Formula(FormulaCommand),
    /// What was understood of a muscle, what follows from it, and a build sheet
    #[command(subcommand)]
    Muscle(MuscleCommand),
    /// Named rubbers
    #[command(subcommand)]
    Rubber(RubberCommand),
    /// The force models: what they are, their source, and where they hold
    #[command(after_help = "Example:\n  mckibben models")]
    Models(ModelsArgs),
    /// JSON Schema of requests and answers
    #[command(after_help = "Examples:\n  mckibben schema force\n  mckibben schema")]
    Schema(SchemaArgs),
    /// Shell completions, written to standard output
    #[command(after_help = "Example:\n  mckibben completions bash")]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

// Lines of at most 78 characters, continued by a backslash: the help is wrapped to the terminal, and a wrapped command
// cannot be pasted.
//B const FIT_EXAMPLES: &str = "Examples:
//B   mckibben fit data/campaign/paper.csv --method paper --hold-out 35 \\
//B     -o formula.json --tables tables --plots plots
//B   mckibben fit data/campaign/paper.csv --method global --hold-out 35 \\
//B     -o global.json
//B   mckibben force -D 35 -s 2 -p 2bar -e 10% --model global.json
//B   mckibben fit --report";

//B const FORMULA_EXAMPLES: &str = "Examples:
//B   mckibben fit data/campaign/paper.csv --method global -o formula.json
//B   mckibben formula show formula.json
//B   mckibben formula show formula.json --latex";

/// `muscle …`.
#[derive(Debug, Subcommand)]
pub enum MuscleCommand {
    /// Show a muscle: what was understood, derived quantities, build sheet
    #[command(
        after_help = "Examples:\n  mckibben muscle show examples/prototype.toml\n  mckibben muscle show -D 40 -s 2 --rubber dragon-skin-30"
    )]
    Show(Box<MuscleShowArgs>),
}

//B /// `formula …`.
//B #[derive(Debug, Subcommand)]
//B pub enum FormulaCommand {
//B     /// Show a formula: its terms, where it holds, its errors, where it comes from
//B     #[command(after_help = FORMULA_EXAMPLES)]
//B     Show(FormulaShowArgs),
//B }
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
    #[command(after_help = commands::rubber_fit::EXAMPLES)]
    Fit(Box<RubberFitArgs>),
}
