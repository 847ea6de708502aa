//! From the command line to the command that it names.

use crate::cli::{
    BraidCommand, Command, FormulaCommand, LibraryCommand, MuscleCommand, PartsCommand, RubberCommand,
    command,
};
use crate::commands::{
    braid, build, campaign, compare, curve, design, doctor, export, fill, fit, formula, help, identify,
    joint, library, life, mcp, models, motion, muscle, parts, point, report, rubber, rubber_fit, schema,
    serve, simulate, study, validate,
};
use crate::failure::Failure;
use crate::format::Format;
use crate::output::emit;

/// Runs a command; the exit code where it ends well.
pub fn run(asked: Command, format: Format) -> Result<u8, Failure> {
    match asked {
        Command::Design(args) => design::run(&args, format),
        Command::Force(args) => point::force(&args, format),
        Command::Pressure(args) => point::pressure(&args, format),
        Command::Contraction(args) => point::contraction(&args, format),
        Command::Fill(args) => fill::run(&args, format),
        Command::Curve(args) if args.study.is_some() => study::run(&args, format),
        Command::Curve(args) => curve::run(&args, format),
        Command::Joint(args) => joint::run(&args, format),
        Command::Motion(args) => motion::run(&args, format),
        Command::Simulate(args) => simulate::run(&args, format),
        Command::Validate(args) => validate::run(&args, format),
        Command::Compare(args) => compare::run(&args, format),
        Command::Doctor(args) => doctor::run(&args, format),
        Command::Life(args) => life::run(&args, format),
        Command::Campaign(args) => campaign::run(&args, format),
        Command::Fit(args) => fit::run(&args, format),
        Command::Formula(FormulaCommand::Show(args)) => formula::show(&args, format),
        Command::Identify(args) => identify::run(&args, format),
        Command::Muscle(MuscleCommand::Show(args)) => muscle::show(&args, format),
        Command::Parts(PartsCommand::List(args)) => parts::list(&args, format),
        Command::Parts(PartsCommand::Show(args)) => parts::show(&args, format),
        Command::Library(LibraryCommand::List(args)) => library::list(&args, format),
        Command::Library(LibraryCommand::Show(args)) => library::show(&args, format),
        Command::Library(LibraryCommand::Check(args)) => library::check(&args, format),
        Command::Muscle(MuscleCommand::Measures(args)) => muscle::measures(&args, format),
        Command::Braid(BraidCommand::List(args)) => braid::list(&args, format),
        Command::Braid(BraidCommand::Show(args)) => braid::show(&args, format),
        Command::Rubber(RubberCommand::List(args)) => rubber::list(&args, format),
        Command::Rubber(RubberCommand::Show(args)) => rubber::show(&args, format),
        Command::Rubber(RubberCommand::Fit(args)) => rubber_fit::run(&args, format),
        Command::Build(args) => build::run(&args, format),
        Command::Export(args) => export::run(&args, format),
        Command::Report(args) => report::run(&args, format),
        Command::Models(args) => models::run(&args, format),
        Command::Schema(args) => schema::run(&args),
        Command::Serve(args) => serve::run(args, format),
        Command::Mcp(args) => mcp::run(&args, &command()),
        Command::Help(args) => help::run(&args, command()),
        Command::Man(args) => help::man(&args, command()),
        Command::Completions { shell } => {
            // Into memory first: clap_complete panics where it cannot write.
            let mut script = vec![];
            clap_complete::generate(shell, &mut command(), "mckibben", &mut script);
            emit(&script, None)?;
            Ok(0)
        }
    }
}
