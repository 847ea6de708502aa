//! `mckibben`: design McKibben pneumatic muscles from the command line.
//!
//! clap reads the command line (`cli`) into a request of the application layer, whose answer a command
//! turns into text, JSON or CSV (`output`) and files (`plot`).

mod clean;
mod cli;
mod commands;
mod display_units;
mod format;
mod output;
mod plot;
mod problem;
mod progress;
mod quantities;
mod quotes;
mod typed;

use clap::FromArgMatches;
use format::Format;
use mckibben_app::{Problem, guarded, panics_are_problems};
use mckibben_core::threads;
use output::{
    Output, check_ending, emit, ending, overwrite, print_page, save, save_all, save_inside,
    text::path_on_one_line, warn,
};
use plot::Plot;
use problem::{NO_ANSWER, NOT_CONVERGED, exit_code, unprinted};
use progress::Bar;
use std::{borrow::Cow, env::args_os, io::Write, process::ExitCode};

fn main() -> ExitCode {
    panics_are_problems();
    let args: Vec<String> = args_os()
        .map(|arg| arg.to_string_lossy().into_owned())
        .collect();
    if let Err(problem) = quotes::check_quotes(&args) {
        return report(problem, asked_format());
    }
    progress::no_signal_for_long_files();
    let mut root = cli::command();
    let parsed = root
        .try_get_matches_from_mut(args_os())
        .and_then(|matches| cli::Cli::from_arg_matches(&matches).map(|cli| (cli, matches)));
    let (cli, matches) = match parsed {
        Ok(parsed) => parsed,
        Err(error) => {
            typed::take(&root, &args, None);
            return unparsed(&error);
        }
    };
    let format = cli.format;
    let done = guarded(|| {
        let _entered = progress::cancel().enter();
        typed::take(&root, &args, Some(&matches));
        display_units::take();
        // A server ends by itself, when its requests have ended.
        if !matches!(cli.command, cli::Command::Serve(_)) {
            progress::watched();
        }
        let continues = matches!(cli.command, cli::Command::Campaign(_));
        output::check_named(continues, cli.overwrite)?;
        cli.command.run(format)
    });
    threads::shortage().into_iter().for_each(output::warn);
    match progress::last_word(done) {
        Ok(code) => ExitCode::from(code),
        Err(problem) => report(problem, format),
    }
}

/// A command line that clap refuses: a problem where a value is wrong or JSON is asked for; else
/// clap's own words.
fn unparsed(error: &clap::Error) -> ExitCode {
    let format = asked_format();
    let gone = || problem::of_gone_flag(error).or_else(|| problem::of_gone_command(error));
    if let Some(problem) = problem::of_value(error).or_else(gone) {
        return report(problem, format);
    }
    if error.use_stderr() && format == Format::Json {
        return report(problem::unparsed(error), format);
    }
    let text = error.render().to_string();
    // Nothing better can be done if the terminal is gone.
    let _ = match clean::lines(&text) {
        Cow::Borrowed(_) => error.print(),
        Cow::Owned(text) => std::io::stderr().write_all(text.as_bytes()),
    };
    ExitCode::from(if error.use_stderr() { 2 } else { 0 })
}

/// The format of a command line that could not be parsed.
fn asked_format() -> Format {
    let args: Vec<_> = args_os().skip(1).collect();
    let json = args.iter().any(|a| a == "--format=json")
        || args
            .windows(2)
            .any(|w| w[0] == "--format" && w[1] == "json");
    if json { Format::Json } else { Format::Text }
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
