//! One file a command.

mod campaign;
mod compare;
mod curve;
mod design;
pub mod fit;
mod formula;
mod identify;
mod models;
mod muscle;
mod rubber;
pub mod rubber_fit;
mod simulate;
mod study;
mod validate;
mod value;

use crate::cli::{Cli, Command, FormulaCommand, MuscleCommand, RubberCommand};
use crate::failure::Failure;
use crate::output::emit;
use clap::CommandFactory;

/// Runs a command; the exit code where it ends well.
pub fn run(command: Command) -> Result<u8, Failure> {
    match command {
        Command::Design(args) => design::run(&args),
        Command::Force(args) => value::force(&args),
        Command::Pressure(args) => value::pressure(&args),
        Command::Contraction(args) => value::contraction(&args),
        Command::Curve(args) if args.study.is_some() => study::run(&args),
        Command::Curve(args) => curve::run(&args),
        Command::Simulate(args) => simulate::run(&args),
        Command::Campaign(args) => campaign::run(&args),
        Command::Validate(args) => validate::run(&args),
        Command::Compare(args) => compare::run(&args),
        Command::Identify(args) => identify::run(&args),
        Command::Fit(args) => fit::run(&args),
        Command::Formula(FormulaCommand::Show(args)) => formula::show(&args),
        Command::Muscle(MuscleCommand::Show(args)) => muscle::show(&args),
        Command::Rubber(RubberCommand::List(args)) => rubber::list(&args),
        Command::Rubber(RubberCommand::Show(args)) => rubber::show(&args),
        Command::Rubber(RubberCommand::Fit(args)) => rubber_fit::run(&args),
        Command::Models(args) => models::run(&args),
        Command::Completions { shell } => {
            // Into memory first: clap_complete panics where it cannot write.
            let mut script = vec![];
            clap_complete::generate(shell, &mut Cli::command(), "mckibben", &mut script);
            emit(&String::from_utf8_lossy(&script), None)?;
            Ok(0)
        }
    }
}
