//! The command line: its commands, and what every command takes.

use crate::{
    Context, Format, Result,
    commands::{
        build, campaign, check, compare, curve, design, export, fill, fit, help, identify, joint,
        motion, parts, point, rubber, schema, serve, simulate,
    },
};
use clap::{Arg, ArgAction, ArgMatches, Args, CommandFactory, FromArgMatches, Parser, Subcommand};
use mckibben_core::{joined, units::NamedUnit};

const EXIT_CODES: &str = "Exit codes: 0 done; 1 no answer exists; 2 the input is wrong; 3 the \
    computation did not converge; 130 ended by a signal.";

/// Design McKibben pneumatic muscles: from a specification to a muscle that you can build.
///
/// Quantities carry a unit (30mm, 2.5bar, 0.25MPa, 36psi, 28deg, 300N, 10%); a bare number is mm,
/// MPa, N, degrees, or a ratio. Ranges are low..high:step (0..2.5:0.1bar), lists are 1,2,3.
#[derive(Parser)]
#[command(
    name = "mckibben",
    version,
    disable_help_subcommand = true,
    disable_help_flag = true,
    max_term_width = 110,
    after_help = EXIT_CODES
)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
    /// Output format: text, json or csv [text]
    ///
    /// Text for reading: aligned, with units. For programs json, one object, or csv, one row per
    /// point; keys and columns carry their unit.
    #[arg(
        long,
        value_enum,
        global = true,
        default_value_t = Format::Text,
        hide_default_value = true,
        hide_possible_values = true,
        display_order = 900,
        help_heading = "Output"
    )]
    pub format: Format,
    /// Overwrite existing files
    #[arg(
        long,
        global = true,
        hide_short_help = true,
        display_order = 901,
        help_heading = "Output"
    )]
    pub overwrite: bool,
    /// Help: -h in short, --help with all flags
    #[arg(
        short,
        long,
        global = true,
        action = ArgAction::Help,
        display_order = 902,
        help_heading = "Output"
    )]
    // clap answers it.
    #[allow(dead_code)]
    help: Option<bool>,
}

/// Every command, in the order of the help.
#[derive(Subcommand)]
#[command(defer = true)]
pub enum Command {
    /// Find muscles that meet a specification, ranked (the main command)
    Design(Flags<design::Design>),
    /// Pull at a pressure and contraction: F(P, ε)
    Force(Flags<point::Force>),
    /// Pressure that gives a pull at a contraction: P(F, ε)
    Pressure(Flags<point::Pressure>),
    /// Contraction at which a pressure gives a pull: ε(F, P)
    Contraction(Flags<point::Contraction>),
    /// Pressure, stroke and energy of a muscle that a volume of liquid is pushed into
    Fill(Flags<fill::Fill>),
    /// Family of curves: isometric, isotonic or isobaric
    Curve(Flags<curve::Curve>),
    /// Joint with one muscle and a spring, or with two opposed muscles: torque, stiffness, rest
    /// position, pressures
    Joint(Flags<joint::Joint>),
    /// Motion over time of a muscle or a joint with valves
    Motion(Flags<motion::Motion>),
    /// One finite-element test with all results: curves, shape, strands, stretches, sensitivities
    Simulate(Flags<simulate::Simulate>),
    /// What is known of a muscle, whether it is plausible, what it bears, and what to measure first;
    /// or a formula's file
    Check(Flags<check::Check>),
    /// Build a muscle: report, drawing, plugs, cut list, bill of materials, steps, test sheet
    Build(Flags<build::Build>),
    /// The muscle, or a joint, for a controller or simulator: C, Rust, Python, MuJoCo, FMI
    Export(Flags<export::Export>),
    /// Many finite-element tests from a plan into one Parquet table; an interrupted run continues
    Campaign(Flags<campaign::Campaign>),
    /// Compare models with each other or with measured points: errors and figure
    Compare(Flags<compare::Compare>),
    /// Constants of rubber, braid and friction from measured curves, with their uncertainty
    Identify(Flags<identify::Identify>),
    /// Fit a formula to a table of finite-element points, with its errors and its range
    Fit(Flags<fit::Fit>),
    /// Everything with a name: tubes, sleeves, rubbers, muscles, models
    #[command(subcommand, arg_required_else_help = true)]
    Parts(Box<parts::Parts>),
    /// Rubber laws from tension tests: constants with their errors, range of stability
    Rubber(Flags<rubber::Rubber>),
    /// Local web server: the workbench in a browser, and every command over HTTP
    Serve(Flags<serve::Serve>),
    /// JSON Schema of requests, answers and files
    Schema(Flags<schema::Schema>),
    /// Help of a command, as its flag --help prints it
    Help(Flags<help::Help>),
    /// Manual pages for `man`
    Man(Flags<help::ManPages>),
    /// Shell completions, written to standard output
    Completions(Flags<help::Completions>),
}

impl Command {
    /// Runs it; the exit code where it ends well.
    pub fn run(self, context: &mut Context) -> Result<u8> {
        match self {
            Self::Design(command) => command.0.run(context),
            Self::Force(command) => command.0.run(context),
            Self::Pressure(command) => command.0.run(context),
            Self::Contraction(command) => command.0.run(context),
            Self::Fill(command) => command.0.run(context),
            Self::Curve(command) => command.0.run(context),
            Self::Joint(command) => command.0.run(context),
            Self::Motion(command) => command.0.run(context),
            Self::Simulate(command) => command.0.run(context),
            Self::Check(command) => command.0.run(context),
            Self::Build(command) => command.0.run(context),
            Self::Export(command) => command.0.run(context),
            Self::Campaign(command) => command.0.run(context),
            Self::Compare(command) => command.0.run(context),
            Self::Identify(command) => command.0.run(context),
            Self::Fit(command) => command.0.run(context),
            Self::Parts(command) => command.run(context),
            Self::Rubber(command) => command.0.run(context),
            Self::Serve(command) => command.0.run(context),
            Self::Schema(command) => command.0.run(context),
            Self::Help(help) => help.0.run(command()),
            Self::Man(man) => man.0.run(command(), context),
            Self::Completions(completions) => completions.0.run(command(), context),
        }
    }
}

/// The command line: `-h` shows the first example and where the other flags are, `--help` all. The
/// flags of a command are made when it is asked for.
pub fn command() -> clap::Command {
    with_short_help("mckibben", Cli::command().arg_required_else_help(true))
}

/// The flags of a command, with their usual names and their short help.
pub struct Flags<T>(pub Box<T>);

impl<T: Args> Args for Flags<T> {
    fn augment_args(command: clap::Command) -> clap::Command {
        let path = format!("mckibben {}", command.get_name());
        // The sentence of the list of commands, not of the type.
        let about = command.get_about().cloned().unwrap_or_default();
        // What every command takes stands behind its own flags, in the help too.
        let of_all = Vec::from_iter(command.get_arguments().cloned());
        let flags = T::augment_args(command).about(about).long_about(None);
        let mut in_order = flags
            .get_arguments()
            .skip(of_all.len())
            .cloned()
            .chain(of_all)
            .collect::<Vec<Arg>>()
            .into_iter();
        with_short_help(&path, flags.mut_args(|arg| in_order.next().unwrap_or(arg)))
    }

    fn augment_args_for_update(command: clap::Command) -> clap::Command {
        Self::augment_args(command)
    }
}

impl<T: FromArgMatches> FromArgMatches for Flags<T> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        T::from_arg_matches(matches).map(|flags| Self(Box::new(flags)))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        self.0.update_from_arg_matches(matches)
    }
}

/// A quantity's flag is its field without the unit, and of a list in the singular: `pressures_mpa` is
/// `--pressure`. What is advanced is in the long help alone; what has no heading is the question.
fn with_usual_name(arg: Arg) -> Arg {
    let is_advanced = arg.get_help_heading() == Some("Advanced") && arg.get_id() != "model";
    let arg = if is_advanced {
        arg.hide_short_help(true)
    } else {
        arg
    };
    let arg = match arg.get_help_heading() {
        None => arg.help_heading("Question"),
        Some(_) => arg,
    };
    let id = arg.get_id().to_string();
    // Its values are a list behind one flag.
    let arg = if arg.get_value_delimiter().is_some() && id != "set" {
        arg.action(ArgAction::Set)
    } else {
        arg
    };
    let of_field = arg.get_long() == Some(&*id.replace('_', "-"));
    let Some(dimension) = NamedUnit::of_field(&id).and_then(|named| named.dimension) else {
        return arg;
    };
    let name = id
        .strip_suffix(
            &dimension
                .end_of_name()
                .map_or(String::new(), |end| format!("_{end}")),
        )
        .unwrap_or(&id)
        .replace('_', "-");
    let one = name.strip_suffix('s').filter(|one| !one.ends_with('s'));
    let arg = arg.allow_hyphen_values(true);
    let noun = dimension.noun().rsplit(' ').next().unwrap_or_default();
    let value = one.map_or_else(|| noun.to_uppercase(), |_| "RANGE".to_owned());
    let is_usual = |names: &[clap::builder::Str]| names == [&*id.to_uppercase()] || names == [&*id];
    let arg = if arg.get_value_names().is_none_or(is_usual) {
        arg.value_name(value)
    } else {
        arg
    };
    if of_field {
        arg.long(one.unwrap_or(&name).to_owned())
    } else {
        arg
    }
}

/// Gives a command and those below it the names of their flags and their short help.
fn with_short_help(path: &str, mut command: clap::Command) -> clap::Command {
    for name in command
        .get_subcommands()
        .map(clap::Command::get_name)
        .map(str::to_owned)
        .collect::<Vec<_>>()
    {
        let path = format!("{path} {name}");
        command = command.mut_subcommand(name, |sub| with_short_help(&path, sub));
    }
    command = command.mut_args(with_usual_name);
    let Some(examples) = command.get_after_long_help().map(ToString::to_string) else {
        return command;
    };
    let hides = |arg: &Arg| arg.is_hide_short_help_set() && !arg.is_global_set();
    let hides = command.get_arguments().any(hides);
    command.after_help(if hides {
        let first = first_example(&examples);
        format!("{first}\n\nAll flags, with details: {path} --help")
    } else {
        examples
    })
}

/// Examples up to the second one.
fn first_example(all: &str) -> String {
    let starts = |line: &&str| line.starts_with("  mckibben ");
    if all.lines().filter(starts).count() < 2 {
        return all.to_owned();
    }
    let mut seen = 0;
    joined(
        all.lines().take_while(|line| {
            seen += usize::from(starts(line));
            seen < 2
        }),
        "\n",
    )
    .replacen("Examples:", "Example:", 1)
}

#[cfg(test)]
mod tests;
