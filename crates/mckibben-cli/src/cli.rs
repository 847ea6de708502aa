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

/// The three tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TestWord {
    /// Contraction fixed, pull over pressure
    Isometric,
    /// Pull fixed, contraction over pressure
    Isotonic,
    /// Pressure fixed, pull over contraction
    Isobaric,
}

/// The studies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum StudyWord {
    /// The paper's Figure 4: walls of 1 to 5 mm, isometric and isotonic, with its findings
    Thickness,
}

/// `curve`.
#[derive(Debug, Args)]
pub struct CurveArgs {
    /// Which test
    #[arg(value_enum, required_unless_present = "study", conflicts_with = "study")]
    pub test: Option<TestWord>,
    /// A study of the paper instead
    #[arg(long, value_enum)]
    pub study: Option<StudyWord>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    /// Pressures [isobaric: 0.05..0.25:0.05, else 0..0.25:0.01]
    #[arg(short, long, value_name = "RANGE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Contraction ratios [isometric: 0..0.2:0.05, isobaric: 0..0.2:0.01]
    #[arg(short = 'e', long, value_name = "RANGE", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Pulls of an isotonic test [20,80,150N]
    #[arg(short = 'F', long, value_name = "RANGE", allow_hyphen_values = true)]
    pub force: Option<String>,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `simulate`.
#[derive(Debug, Args)]
pub struct SimulateArgs {
    /// Muscle file (TOML)
    #[arg(value_name = "FILE", conflicts_with = "muscle")]
    pub file: Option<PathBuf>,
    /// Which test
    #[arg(long, value_enum, default_value_t = TestWord::Isometric)]
    pub test: TestWord,
    /// Pressures [0.05..0.25:0.05]
    #[arg(short, long, value_name = "RANGE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Contraction ratios of an isometric or isobaric test [0..0.2:0.1]
    #[arg(short = 'e', long, value_name = "RANGE", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Contractions are shares of the free contraction at the highest pressure
    #[arg(long)]
    pub of_largest: bool,
    /// Pulls of an isotonic test [20,80,150N]
    #[arg(short = 'F', long, value_name = "RANGE", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Model: fe (axisymmetric) or fe3d (three-dimensional)
    #[arg(long, value_name = "NAME", default_value = "fe")]
    pub model: String,
    /// Mesh of fe: elements along the half length, or through the wall x along, or with :grading; of fe3d: bricks around
    /// the quarter, or through x around, or through x around x along [chosen]
    #[arg(long, value_name = "N or MxN:G")]
    pub mesh: Option<String>,
    /// What fe3d keeps where bricks with strands at ±θ0 do not fill the length
    #[arg(long = "match", value_enum, value_name = "WHAT", default_value_t)]
    pub keep: MatchWord,
    /// Terminal of fe3d: none (a rigid plane), rigid or aluminium (a plug), with :insertion and :radius of its nose [none]
    #[arg(long, value_name = "WORD:MM:MM")]
    pub terminal: Option<String>,
    /// Negative force instead of slack where the muscle would have to push
    #[arg(long)]
    pub two_sided: bool,
    /// Write the deformed muscle, point by point, into a folder that ParaView opens (muscle.pvd)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub vtu: Option<PathBuf>,
    /// Write all of the muscle there, not the eighth that fe3d computes; fe always does
    #[arg(long, requires = "vtu", help_heading = "Output")]
    pub whole: bool,
    /// Write mesh, material, loads and steps of an isometric test with fe3d as an input deck for CalculiX and Abaqus
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub export_inp: Option<PathBuf>,
    /// Draw the deformed muscle of the last point that has an answer: a file ending in .png or .svg
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub picture: Option<PathBuf>,
    /// What colours the picture, e.g. hoop_stretch, stress_hoop_mpa
    #[arg(
        long,
        value_name = "NAME",
        default_value = "max_stretch",
        requires = "picture",
        help_heading = "Output"
    )]
    pub show: String,
    /// Cut a quarter out of the picture, so that wall and bore show
    #[arg(long, requires = "picture", help_heading = "Output")]
    pub cut: bool,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `validate`.
#[derive(Debug, Args)]
pub struct ValidateArgs {
    /// The finest meshes as well (some seconds more)
    #[arg(long, conflicts_with = "sweep")]
    pub all: bool,
    /// Instead: ask so many random muscles one question each, and say which share is answered
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub sweep: Option<u32>,
    /// Seed of the random muscles
    #[arg(long, default_value_t = 1, requires = "sweep")]
    pub seed: u64,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// Which measured branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum BranchWord {
    /// The mean of both, where both were measured
    #[default]
    Mean,
    /// The branch of shortening
    Contraction,
    /// The branch of lengthening
    Elongation,
}

/// `compare`.
#[derive(Debug, Args)]
pub struct CompareArgs {
    /// Models, by name [fe,paper,thick-wall,ideal]
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub models: Vec<String>,
    /// One model, as --models
    #[arg(long, value_name = "NAME", conflicts_with = "models")]
    pub model: Option<String>,
    /// Measured points (CSV: pressure_mpa, contraction, force_n, branch)
    #[arg(long, value_name = "FILE.csv")]
    pub data: Option<PathBuf>,
    /// Which branch of measured hysteresis
    #[arg(long, value_enum, default_value_t = BranchWord::Mean)]
    pub branch: BranchWord,
    /// Constants to fit to the points, for each model: modulus, end-factor, stiffness
    #[arg(long, value_name = "LIST", value_delimiter = ',', requires = "data")]
    pub fit: Vec<String>,
    /// Pressures, without --data [0.05..0.25:0.05]
    #[arg(short, long, value_name = "RANGE", allow_hyphen_values = true, conflicts_with = "data")]
    pub pressure: Option<String>,
    /// Contraction ratios, without --data [0..0.2:0.01]
    #[arg(short = 'e', long, value_name = "RANGE", allow_hyphen_values = true, conflicts_with = "data")]
    pub contraction: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub asking: AskFlags,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// What is ranked first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum ObjectiveWord {
    /// Smallest outer diameter at rest
    #[default]
    Diameter,
    /// Lowest pressure needed
    Pressure,
    /// Least air per stroke
    Air,
    /// Most pull to spare at the maximum pressure
    Margin,
}

/// What the winner of a design is checked with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum VerifyWord {
    /// Axisymmetric finite elements; a matter of milliseconds
    #[default]
    Fe,
    /// Nothing
    None,
}

/// `design`.
#[derive(Debug, Args)]
pub struct DesignArgs {
    /// Pull wanted
    #[arg(
        short = 'F',
        long,
        value_name = "FORCE",
        allow_hyphen_values = true,
        help_heading = "Specification"
    )]
    pub force: Option<String>,
    /// Contraction ratio at which it is wanted
    #[arg(
        short = 'e',
        long,
        value_name = "RATIO",
        allow_hyphen_values = true,
        help_heading = "Specification"
    )]
    pub contraction: Option<String>,
    /// Several operating points: 700N@15%,1200N@5%
    #[arg(long, value_name = "F@E,…", allow_hyphen_values = true, conflicts_with_all = ["force", "contraction"], help_heading = "Specification")]
    pub at: Option<String>,
    /// Pressure of the supply
    #[arg(
        short = 'p',
        long,
        value_name = "PRESSURE",
        allow_hyphen_values = true,
        alias = "pressure",
        help_heading = "Specification"
    )]
    pub max_pressure: Option<String>,
    /// Stroke in mm: with --contraction it sets the length, with --length the contraction
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, help_heading = "Specification")]
    pub stroke: Option<String>,
    /// Largest outer diameter at the operating points
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, help_heading = "Specification")]
    pub max_bulged_diameter: Option<String>,
    /// Least ratio of burst pressure to maximum pressure (needs the strands' strength)
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true, help_heading = "Specification")]
    pub min_burst_margin: Option<String>,
    /// Largest stretch of the rubber at the operating points (2 means twice its length)
    #[arg(long, value_name = "STRETCH", allow_hyphen_values = true, help_heading = "Specification")]
    pub max_stretch: Option<String>,
    /// What to rank by
    #[arg(long, value_enum, default_value_t = ObjectiveWord::Diameter, help_heading = "Specification")]
    pub objective: ObjectiveWord,
    /// Muscle file for what is not searched; flags override it
    #[arg(long, value_name = "FILE", help_heading = "Search space")]
    pub muscle: Option<PathBuf>,
    /// Outer diameters at rest: a value, list, range or stepped range [30..50 with paper, else 5..80]
    #[arg(
        short = 'D',
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        help_heading = "Search space"
    )]
    pub outer_diameter: Option<String>,
    /// Walls [1..5 with paper, else 0.5..10]
    #[arg(
        short = 's',
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        help_heading = "Search space"
    )]
    pub wall: Option<String>,
    /// Braid angles [28deg]
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, help_heading = "Search space")]
    pub angle: Option<String>,
    /// Sleeves as sold: length of strand per turn; the diameter then sets the angle
    #[arg(
        long,
        value_name = "LIST",
        allow_hyphen_values = true,
        conflicts_with = "angle",
        help_heading = "Search space"
    )]
    pub strand_length_per_turn: Option<String>,
    /// Rubbers, by name [paper]
    #[arg(long, value_name = "LIST", value_delimiter = ',', help_heading = "Search space")]
    pub rubber: Vec<String>,
    /// Stiffness of one strand family: N/mm, `inextensible`, or `paper` [paper]
    #[arg(long, value_name = "STIFFNESS", allow_hyphen_values = true, help_heading = "Search space")]
    pub stiffness: Option<String>,
    /// Length between the terminals at rest [285mm]
    #[arg(
        short = 'L',
        long,
        value_name = "LENGTH",
        allow_hyphen_values = true,
        help_heading = "Search space"
    )]
    pub length: Option<String>,
    /// Spread of the winner's pull for ± tolerances: wall=0.1mm,diameter=0.2mm,pressure=0.1bar
    #[arg(long, value_name = "LIST", allow_hyphen_values = true, help_heading = "Search space")]
    pub tolerance: Option<String>,
    /// Force model [paper where the search stays in its box, else universal]
    #[arg(long, value_name = "NAME", help_heading = "Model")]
    pub model: Option<String>,
    /// Mesh of `fe` or `fe3d`, as for the other commands [chosen]
    #[arg(long, value_name = "N or MxN:G", help_heading = "Model")]
    pub mesh: Option<String>,
    /// Answer outside of the model's range, with a warning
    #[arg(long, help_heading = "Model")]
    pub extrapolate: bool,
    /// Compute the winner again by finite elements and show the difference
    #[arg(long, value_enum, default_value_t = VerifyWord::Fe, help_heading = "Model")]
    pub verify: VerifyWord,
    /// How many candidates to show
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000), help_heading = "Output")]
    pub top: u16,
    /// What is printed: text for people, json or csv for programs
    #[arg(long, value_enum, default_value_t = crate::flags::Format::Text, help_heading = "Output")]
    pub format: crate::flags::Format,
    /// Unit of pressures in text and figures [the one you typed, else MPa]
    #[arg(long, value_enum, value_name = "UNIT", help_heading = "Output")]
    pub units: Option<crate::flags::PressureUnit>,
    #[command(flatten)]
    pub plot: PlotFlag,
    /// No chart in the terminal
    #[arg(long, help_heading = "Output")]
    pub no_chart: bool,
    /// Write the winner as a muscle file
    #[arg(short, long, value_name = "FILE.toml", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

/// `muscle …`.
#[derive(Debug, Subcommand)]
pub enum MuscleCommand {
    /// Show a muscle: what was understood, derived quantities, build sheet
    #[command(
        after_help = "Examples:\n  mckibben muscle show examples/prototype.toml\n  mckibben muscle show -D 40 -s 2 --rubber dragon-skin-30"
    )]
    Show(Box<MuscleShowArgs>),
}

/// `muscle show`.
#[derive(Debug, Args)]
pub struct MuscleShowArgs {
    /// Muscle file (TOML)
    #[arg(value_name = "FILE", conflicts_with = "muscle")]
    pub file: Option<PathBuf>,
    /// Also what it does at this pressure: blocked force, free contraction, work, air, burst
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub output: OutputFlags,
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

/// `rubber list`.
#[derive(Debug, Args)]
pub struct RubberListArgs {
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `rubber show`.
#[derive(Debug, Args)]
pub struct RubberShowArgs {
    /// Name, or NAME:LAW
    pub name: String,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `models`.
#[derive(Debug, Args)]
pub struct ModelsArgs {
    #[command(flatten)]
    pub output: OutputFlags,
}
