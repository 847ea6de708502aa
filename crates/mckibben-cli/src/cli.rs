//! The commands. Each command's flags stand in its own file; help, completions and parsing come from there.

use crate::commands;
use crate::commands::build::BuildArgs;
use crate::commands::campaign::CampaignArgs;
use crate::commands::check::CheckArgs;
use crate::commands::compare::CompareArgs;
use crate::commands::curve::CurveArgs;
use crate::commands::design::DesignArgs;
use crate::commands::export::ExportArgs;
use crate::commands::fill::FillArgs;
use crate::commands::fit::FitArgs;
use crate::commands::help::{HelpArgs, ManArgs};
use crate::commands::identify::IdentifyArgs;
use crate::commands::joint::JointArgs;
use crate::commands::motion::MotionArgs;
use crate::commands::parts::{PartShowArgs, PartsListArgs};
use crate::commands::point::{ContractionArgs, ForceArgs, PressureArgs};
use crate::commands::rubber::RubberArgs;
use crate::commands::schema::SchemaArgs;
use crate::commands::serve::ServeArgs;
use crate::commands::simulate::SimulateArgs;
use crate::commands::validate::ValidateArgs;
use crate::format::Format;
use clap::{ArgAction, CommandFactory, Parser, Subcommand};

const ABOUT: &str = "Design McKibben pneumatic muscles: from a specification to a muscle that you can build.

Quantities carry a unit (30mm, 2.5bar, 0.25MPa, 36psi, 28deg, 300N, 10%); a bare number is mm, MPa, N, degrees, \
or a ratio. Ranges are low..high:step (0..2.5:0.1bar), lists are 1,2,3.";

const EXIT_CODES: &str = "Exit codes: 0 done; 1 no answer exists; 2 the input is wrong; 3 the computation did not converge; 130 ended by a signal.";

/// The command line.
#[derive(Debug, Parser)]
#[command(name = "mckibben", version, about = ABOUT, disable_help_subcommand = true, disable_help_flag = true, max_term_width = 110, after_help = EXIT_CODES)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Output format: text, json or csv [text]
    ///
    /// Text for reading: aligned, with units. For programs json, one object, or csv, one row per point; keys and columns carry their unit.
    #[arg(long, value_enum, global = true, default_value_t = Format::Text, hide_default_value = true, hide_possible_values = true, display_order = 900, help_heading = "Output")]
    pub format: Format,
    /// Overwrite existing files
    #[arg(long, global = true, hide_short_help = true, display_order = 901, help_heading = "Output")]
    pub overwrite: bool,
    /// Help: -h in short, --help with all flags
    #[arg(short, long, global = true, action = ArgAction::Help, display_order = 902, help_heading = "Output")]
    // clap answers it.
    #[allow(dead_code)]
    help: Option<bool>,
}

/// The command line: `-h` shows the first example and where the other flags are, `--help` all.
pub fn command() -> clap::Command {
    with_helps(Cli::command(), "")
}

fn with_helps(command: clap::Command, above: &str) -> clap::Command {
    let path = format!("{above}{}", command.get_name());
    let hides = |command: &clap::Command| command.get_arguments().any(clap::Arg::is_hide_short_help_set);
    let all = command.get_after_help().map(ToString::to_string);
    let command = match all {
        Some(all) if hides(&command) => {
            let short = format!("{}\n\nAll flags, with details: {path} --help", first_example(&all));
            command.after_help(short).after_long_help(all)
        }
        _ => command,
    };
    command.mut_subcommands(|inner| with_helps(inner, &format!("{path} ")))
}

/// Examples up to the second one.
fn first_example(all: &str) -> String {
    let starts = |line: &&str| line.starts_with("  mckibben ");
    if all.lines().filter(starts).count() < 2 {
        return all.to_owned();
    }
    let mut seen = 0;
    let lines = all.lines().take_while(|line| {
        seen += usize::from(starts(line));
        seen < 2
    });
    lines.collect::<Vec<_>>().join("\n").replacen("Examples:", "Example:", 1)
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Find muscles that meet a specification, ranked (the main command)
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
    /// Pressure, stroke and energy of a muscle that a volume of liquid is pushed into
    #[command(after_help = commands::fill::EXAMPLES)]
    Fill(Box<FillArgs>),
    /// Family of curves: isometric, isotonic or isobaric
    #[command(after_help = commands::curve::EXAMPLES)]
    Curve(Box<CurveArgs>),
    /// Joint with one muscle and a spring, or with two opposed muscles: torque, stiffness, rest position, pressures
    #[command(after_help = commands::joint::EXAMPLES)]
    Joint(Box<JointArgs>),
    /// Motion over time of a muscle or a joint with valves
    #[command(after_help = commands::motion::EXAMPLES)]
    Motion(Box<MotionArgs>),
    /// One finite-element test with all results: curves, shape, strands, stretches, sensitivities
    #[command(after_help = commands::simulate::EXAMPLES)]
    Simulate(Box<SimulateArgs>),
    /// What is known of a muscle, whether it is plausible, what it bears, and what to measure first; or a formula's file
    #[command(after_help = commands::check::EXAMPLES)]
    Check(Box<CheckArgs>),
    /// Build a muscle: report, drawing, plugs, cut list, bill of materials, steps, test sheet
    #[command(after_help = commands::build::EXAMPLES)]
    Build(Box<BuildArgs>),
    /// The muscle for a controller or simulator: C, Python, MuJoCo, FMI, OpenSim
    #[command(after_help = commands::export::EXAMPLES)]
    Export(Box<ExportArgs>),
    /// Many finite-element tests from a plan into one Parquet table; an interrupted run continues
    #[command(after_help = commands::campaign::EXAMPLES)]
    Campaign(Box<CampaignArgs>),
    /// Verification against exact values and validation against measured muscles
    #[command(after_help = commands::validate::EXAMPLES)]
    Validate(ValidateArgs),
    /// Compare models with each other or with measured points: errors and figure
    #[command(after_help = commands::compare::EXAMPLES)]
    Compare(Box<CompareArgs>),
    /// Constants of rubber, braid and friction from measured or published curves, with their uncertainty
    #[command(after_help = commands::identify::EXAMPLES)]
    Identify(Box<IdentifyArgs>),
    /// Fit a formula to a table of finite-element points, with its errors and its range
    #[command(after_help = commands::fit::EXAMPLES)]
    Fit(Box<FitArgs>),
    /// Everything with a name: tubes, sleeves, rubbers, muscles, models
    #[command(subcommand)]
    Parts(PartsCommand),
    /// Rubber laws from tension tests: constants with their errors, range of stability
    #[command(after_help = commands::rubber::EXAMPLES)]
    Rubber(Box<RubberArgs>),
    /// Local web server: the workbench in a browser, and every command over HTTP
    #[command(after_help = commands::serve::EXAMPLES)]
    Serve(ServeArgs),
    /// JSON Schema of requests, answers and files
    #[command(
        after_help = "Examples:\n  mckibben schema force\n  mckibben schema --file muscle -o muscle.schema.json"
    )]
    Schema(SchemaArgs),
    /// Help of a command, as its flag --help prints it
    #[command(after_help = commands::help::EXAMPLES)]
    Help(HelpArgs),
    /// Manual pages for `man`
    #[command(after_help = commands::help::MAN_EXAMPLES)]
    Man(ManArgs),
    /// Shell completions, written to standard output
    #[command(after_help = "Example:\n  mckibben completions bash")]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

// Lines of at most 78 characters, continued by a backslash: the help is wrapped to the terminal, and a wrapped command
// cannot be pasted.
/// `parts …`.
#[derive(Debug, Subcommand)]
pub enum PartsCommand {
    /// All of them, or those of one kind
    #[command(after_help = "Example:\n  mckibben parts list tubes")]
    List(PartsListArgs),
    /// What has a name: its data, source and terms
    #[command(after_help = commands::parts::EXAMPLES)]
    Show(PartShowArgs),
}
