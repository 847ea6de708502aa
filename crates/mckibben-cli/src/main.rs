//! `mckibben`: design McKibben pneumatic muscles from the command line.
//!
//! clap reads the command line (`cli`) into a request of the application layer, whose answer a command
//! turns into text, JSON or CSV (`output`) and files (`plot`).

mod clean;
mod cli;
mod commands;
mod context;
mod examples;
mod format;
mod output;
mod plot;
mod problem;
mod progress;
mod quantities;
mod quotes;

use clap::FromArgMatches;
use context::Context;
use format::Format;
use mckibben_app::{Problem, Result, guarded, panics_are_problems};
use mckibben_core::threads;
use output::{Output, check_ending, ending, text::path_on_one_line};
use plot::Plot;
use problem::{NO_ANSWER, NOT_CONVERGED, exit_code, unprinted};
use progress::Bar;
use std::{borrow::Cow, env::args_os, io::Write, process::ExitCode};

fn main() -> ExitCode {
    panics_are_problems();
    let args = Vec::from_iter(args_os().map(|arg| arg.to_string_lossy().into_owned()));
    let refused = Context {
        format: asked_format(&args),
        ..Context::default()
    };
    if let Err(problem) = quotes::check_quotes(&args) {
        return report(problem, &refused);
    }
    progress::no_signal_for_long_files();
    let mut root = cli::command();
    let parsed = root
        .try_get_matches_from_mut(args_os())
        .and_then(|matches| cli::Cli::from_arg_matches(&matches).map(|cli| (cli, matches)));
    let (cli, matches) = match parsed {
        Ok(parsed) => parsed,
        Err(error) => {
            let context = Context {
                format: refused.format,
                ..Context::new(&root, &args, None)
            };
            return unparsed(&error, &context);
        }
    };
    let mut context = Context {
        format: cli.format,
        overwrite: cli.overwrite,
        ..Context::new(&root, &args, Some(&matches))
    };
    let done = guarded(|| {
        let _entered = progress::cancel().enter();
        // A server ends by itself, when its requests have ended.
        if !matches!(cli.command, cli::Command::Serve(_)) {
            progress::watched();
        }
        context.check_named(matches!(cli.command, cli::Command::Campaign(_)))?;
        cli.command.run(&mut context)
    });
    threads::shortage()
        .into_iter()
        .for_each(|text| context.warn(text));
    match progress::last_word(done) {
        Ok(code) => ExitCode::from(code),
        Err(problem) => report(problem, &context),
    }
}

/// A command line that clap refuses: a problem where a value is wrong or JSON is asked for; else
/// clap's own words.
fn unparsed(error: &clap::Error, context: &Context) -> ExitCode {
    let gone = || {
        let flag = problem::of_gone_flag(error, context);
        flag.or_else(|| problem::of_gone_command(error))
            .or_else(|| problem::of_letters(error))
    };
    let word = problem::of_gone_word();
    if let Some(problem) = word.or_else(|| problem::of_value(error)).or_else(gone) {
        return report(problem, context);
    }
    if error.use_stderr() && context.format == Format::Json {
        return report(problem::unparsed(error), context);
    }
    let text = error.render().to_string();
    let printed = match clean::lines(&text) {
        Cow::Borrowed(_) => error.print(),
        Cow::Owned(text) => std::io::stderr().write_all(text.as_bytes()),
    };
    match printed {
        // Nothing better can be done if the terminal is gone.
        _ if error.use_stderr() => ExitCode::from(2),
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => report(unprinted(&error), context),
    }
}

/// The format of a command line that could not be parsed.
fn asked_format(args: &[String]) -> Format {
    let json = args.iter().any(|a| a == "--format=json")
        || args
            .windows(2)
            .any(|w| w[0] == "--format" && w[1] == "json");
    if json { Format::Json } else { Format::Text }
}

fn report(problem: Problem, context: &Context) -> ExitCode {
    if problem.message.is_empty() {
        return ExitCode::SUCCESS;
    }
    let problem = problem::in_words(problem, context);
    if context.format == Format::Json {
        let _ = writeln!(std::io::stderr(), "{}", problem::as_json(&problem));
    } else {
        output::complain(&problem::as_text(&problem, &context.units));
    }
    ExitCode::from(exit_code(Some(&problem)))
}
