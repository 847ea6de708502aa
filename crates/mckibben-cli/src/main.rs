//! `mckibben`: design McKibben pneumatic muscles from the command line.
//!
//! `main` parses; the flags of a command (`spec`) become a request of the application layer (`asked`), whose answer a command turns into text,
//! JSON or CSV (`output`) and files (`plot`).

mod asked;
mod clean;
mod cli;
mod commands;
mod failure;
mod files;
mod format;
mod gone;
mod names;
mod output;
mod plot;
mod progress;
mod quantities;
mod quotes;
mod shown;
mod spec;

use asked::Asked;
use clap::FromArgMatches;
use failure::{Failure, NO_ANSWER, NOT_CONVERGED, in_flags};
use format::Format;
use mckibben::threads;
use mckibben_app::{guarded, panics_are_problems};
use output::keyed::{each, listed, said, tabled, value};
use output::text::{Units, columns, half_width, number, pairs, percent, percents, place, table, understood};
use output::{
    FLAT, burst_first, check_ending, emit, ending, overwrite, save, save_all, save_inside, streamed, warn,
};
use progress::Bar;
use quantities::{quantity, unit_hint, values};
use spec::Flag;
use std::ffi::{OsStr, OsString};
use std::{borrow::Cow, io::Write, process::ExitCode};

fn main() -> ExitCode {
    panics_are_problems();
    let args: Vec<String> = std::env::args_os().map(|arg| arg.to_string_lossy().into_owned()).collect();
    if let Err(failure) = gone::check(&args).and_then(|()| quotes::check_quotes(&args)) {
        return report(&failure, if json_wanted() { Format::Json } else { Format::Text });
    }
    progress::no_signal_for_long_files();
    let parsed = cli::command()
        .try_get_matches_from(joined(std::env::args_os()))
        .and_then(|matches| cli::Cli::from_arg_matches(&matches).map(|cli| (cli, matches)));
    let (cli, matches) = match parsed {
        Ok(parsed) => parsed,
        Err(error) if error.use_stderr() && json_wanted() => {
            return report(&Failure::usage(&error), Format::Json);
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
        let Some((name, asked, run)) = cli::asked(&matches, cli.format) else { return Ok(0) };
        shown::take(&asked);
        failure::take_flags(&asked.flags);
        // A server ends by itself, when its requests have ended.
        if name != "serve" {
            progress::watched();
        }
        output::check_named(&asked, &name, cli.overwrite)?;
        run(&asked)
    });
    threads::shortage().into_iter().for_each(output::warn);
    match progress::last_word(done) {
        Ok(code) => ExitCode::from(code),
        Err(failure) => report(&failure.with_hint(unit_hint()), cli.format),
    }
}

/// The command line with a share joined to the flag before it, which could also be without one: `--guaranteed 99%`.
fn joined(args: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut out: Vec<OsString> = vec![];
    for arg in args {
        let is_share = arg.to_str().is_some_and(|text| text.trim_end_matches('%').parse::<f64>().is_ok());
        match out.last_mut().filter(|last| is_share && *last == "--guaranteed") {
            Some(last) => last.extend([OsStr::new("="), &arg]),
            None => out.push(arg),
        }
    }
    out
}

/// Whether `--format json` stands on a command line that could not be parsed: the error is then JSON as well.
fn json_wanted() -> bool {
    let args: Vec<_> = std::env::args_os().skip(1).collect();
    args.iter().any(|a| a == "--format=json") || args.windows(2).any(|w| w[0] == "--format" && w[1] == "json")
}

fn report(failure: &Failure, format: Format) -> ExitCode {
    if failure.is_broken_pipe() {
        return ExitCode::SUCCESS;
    }
    if format == Format::Json {
        let _ = writeln!(std::io::stderr(), "{}", failure.to_json());
    } else {
        output::complain(&failure.to_text());
    }
    ExitCode::from(failure.exit())
}
