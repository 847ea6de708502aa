//! From the command line to the command that it names.

use crate::cli::{Command, PartsCommand, command};
use crate::commands::{
    build, campaign, check, compare, curve, design, export, fill, fit, help, identify, joint, motion, parts,
    point, rubber, schema, serve, simulate, study, validate,
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
        Command::Check(args) => check::run(&args, format),
        Command::Campaign(args) => campaign::run(&args, format),
        Command::Fit(args) => fit::run(&args, format),
        Command::Identify(args) => identify::run(&args, format),
        Command::Parts(PartsCommand::List(args)) => parts::list(&args, format),
        Command::Parts(PartsCommand::Show(args)) => parts::show(&args, format),
        Command::Rubber(args) => rubber::run(&args, format),
        Command::Build(args) => build::run(&args, format),
        Command::Export(args) => export::run(&args, format),
        Command::Schema(args) => schema::run(&args),
        Command::Serve(args) => serve::run(args, format),
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
