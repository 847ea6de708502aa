//! `mckibben`: design McKibben pneumatic muscles from the command line.
//!
//! `main` parses and dispatches; a command parses its flags (`flags`), resolves them into a muscle and a model
//! (`resolve`), asks the library, and hands the result to `output` and `figure`.

mod cli;
mod commands;
mod failure;
mod figure;
mod flags;
mod kind;
mod output;
mod resolve;
mod simulated;

use clap::Parser;
use failure::Failure;
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = match cli::Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() && json_wanted() => {
            return report(&Failure::usage(&error), true);
        }
        Err(error) => {
            let code = if error.use_stderr() { 2 } else { 0 };
            // Nothing better can be done if the terminal is gone.
            let _ = error.print();
            return ExitCode::from(code);
        }
    };
    match commands::run(cli.command) {
        Ok(code) => ExitCode::from(code),
        Err(failure) => report(&failure, json_wanted()),
    }
}

/// Whether `--format json` stands on the command line: errors are then JSON as well, even those of the parser.
fn json_wanted() -> bool {
    let args: Vec<_> = std::env::args_os().skip(1).collect();
    args.iter().any(|a| a == "--format=json") || args.windows(2).any(|w| w[0] == "--format" && w[1] == "json")
}

fn report(failure: &Failure, json: bool) -> ExitCode {
    if failure.is_broken_pipe() {
        return ExitCode::SUCCESS;
    }
    let text = if json { failure.to_json() } else { failure.to_text() };
    let _ = writeln!(std::io::stderr(), "{text}");
    ExitCode::from(failure.exit)
}
