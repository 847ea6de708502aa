//! `mckibben`: design McKibben pneumatic muscles from the command line.
//!
//! `main` parses; the flags of a command (`spec`) become a request of the application layer
//! (`args`), whose answer a command turns into text, JSON or CSV (`output`) and files (`plot`).

mod args;
mod clean;
mod cli;
mod commands;
mod files;
mod format;
mod gone;
mod names;
mod output;
mod plot;
mod problem;
mod progress;
mod quantities;
mod quotes;
mod shown;
mod spec;

use args::Args;
use clap::FromArgMatches;
use format::Format;
use mckibben::threads;
use mckibben_app::{Problem, guarded, panics_are_problems};
use output::keyed::{each, headed, listed, said, tabled, value};
use output::text::{Units, number, pairs, percent, place, table, understood};
use output::{
    burst_first, check_ending, emit, ending, overwrite, save, save_all, save_inside, warn,
};
use problem::{NO_ANSWER, NOT_CONVERGED, bad_flag, exit_code, in_flags, unprinted};
use progress::Bar;
use quantities::{quantity, values};
use spec::Flag;
use std::{borrow::Cow, io::Write, process::ExitCode};

fn main() -> ExitCode {
    panics_are_problems();
    let args: Vec<String> = std::env::args_os()
        .map(|arg| arg.to_string_lossy().into_owned())
        .collect();
    if let Err(problem) = gone::check(&args).and_then(|()| quotes::check_quotes(&args)) {
        return report(
            problem,
            if json_wanted() {
                Format::Json
            } else {
                Format::Text
            },
        );
    }
    progress::no_signal_for_long_files();
    let parsed = cli::command()
        .try_get_matches()
        .and_then(|matches| cli::Cli::from_arg_matches(&matches).map(|cli| (cli, matches)));
    let (cli, matches) = match parsed {
        Ok(parsed) => parsed,
        Err(error) if error.use_stderr() && json_wanted() => {
            return report(problem::unparsed(&error), Format::Json);
        }
        Err(error) => {
            let code = if error.use_stderr() { 2 } else { 0 };
            let text = error.render().to_string();
            // Nothing better can be done if the terminal is gone.
            let _ = match clean::lines(&text) {
                Cow::Borrowed(_) => error.print(),
                Cow::Owned(text) => std::io::stderr().write_all(text.as_bytes()),
            };
            return ExitCode::from(code);
        }
    };
    let done = guarded(|| {
        let _entered = progress::cancel().enter();
        let Some((name, args, run)) = cli::typed_command(&matches, cli.format) else {
            return Ok(0);
        };
        shown::take(&args);
        problem::take_flags(&args.flags);
        // A server ends by itself, when its requests have ended.
        if name != "serve" {
            progress::watched();
        }
        output::check_named(&args, &name, cli.overwrite)?;
        run(&args)
    });
    threads::shortage().into_iter().for_each(output::warn);
    match progress::last_word(done) {
        Ok(code) => ExitCode::from(code),
        Err(problem) => report(problem, cli.format),
    }
}

/// Whether `--format json` is on a command line that could not be parsed: the error is then JSON as
/// well.
fn json_wanted() -> bool {
    let args: Vec<_> = std::env::args_os().skip(1).collect();
    args.iter().any(|a| a == "--format=json")
        || args
            .windows(2)
            .any(|w| w[0] == "--format" && w[1] == "json")
}

fn report(problem: Problem, format: Format) -> ExitCode {
    if problem.message.is_empty() {
        return ExitCode::SUCCESS;
    }
    let problem = problem::in_words(problem);
    if format == Format::Json {
        let _ = writeln!(std::io::stderr(), "{}", problem::as_json(&problem));
    } else {
        output::complain(&problem::as_text(&problem));
    }
    ExitCode::from(exit_code(Some(&problem)))
}
