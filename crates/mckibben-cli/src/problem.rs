//! What a command ends with when it does not end well: kind, message, hint, exit code, in the words
//! of the command line.

use crate::{Context, clean, output::plain};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use mckibben_app::{Ending, Problem, ProblemKind, Units};
use mckibben_core::{
    joined,
    units::{QuantityError, RangeError},
};
use std::{error::Error, io};

/// What a flag's value is refused for.
pub fn of_value(error: &clap::Error) -> Option<Problem> {
    let source = error.source()?;
    let problem = if let Some(problem) = source.downcast_ref::<Problem>() {
        problem.clone()
    } else if let Some(error) = source.downcast_ref::<QuantityError>() {
        let hint = match error.problem.starts_with("is a range") {
            true => "`mckibben curve` takes ranges",
            false => "",
        };
        Problem::new(ProblemKind::Quantity, error.to_string(), hint)
    } else {
        let kind = match source.downcast_ref::<RangeError>()? {
            RangeError::Quantity(_) => ProblemKind::Quantity,
            RangeError::Form(_) => ProblemKind::Range,
        };
        kind.problem(source)
    };
    let flag = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(name)) => name.split(' ').next().unwrap_or_default(),
        _ => "",
    };
    // A file is named in its message, and an argument has no name.
    if problem.kind == ProblemKind::File || !flag.starts_with('-') {
        return Some(problem);
    }
    Some(Problem {
        message: format!("{flag}: {}", problem.message),
        ..problem
    })
}

/// Flags that a command had, by its name, with what is typed in their place.
const GONE: [(&str, &[&str], &str); 7] = [
    (
        "compare",
        &["--fit"],
        "`mckibben identify` finds constants from points, and `compare` takes its muscle file",
    ),
    (
        "identify",
        &["--laws"],
        "`--rubber NAME:LAW` takes a law of a rubber",
    ),
    (
        "identify",
        &["--loss"],
        "take outliers out of the table, or give their rows a smaller `weight`",
    ),
    (
        "fit",
        &["--report", "--thin-rule", "--slack-rule"],
        "`cargo study paper_rules` compares the readings of the paper's method",
    ),
    (
        "fit",
        &["--tables", "--plots", "--plots-format", "--at"],
        "`--figures DIR` writes tables, and figures of D0 30 mm or the first muscle as SVG",
    ),
    (
        "fit",
        &["--hold-out-share"],
        "`--hold-out 20%` takes a share",
    ),
    (
        "fit",
        &["--rubber", "--stiffness"],
        "`--muscle FILE` states rubber and braid of a CSV table",
    ),
];

/// A flag that a command does not have, and what to type in its place.
pub fn of_gone_flag(error: &clap::Error, context: &Context) -> Option<Problem> {
    let Some(ContextValue::String(flag)) = error.get(ContextKind::InvalidArg) else {
        return None;
    };
    if error.kind() != ErrorKind::UnknownArgument {
        return None;
    }
    let command = std::env::args_os().nth(1).unwrap_or_default();
    let mut gone = GONE.iter();
    if let Some((name, _, hint)) = gone.find(|g| command == g.0 && g.1.contains(&&**flag)) {
        return Some(Problem::usage(
            format!("`mckibben {name}` has no {flag} any more"),
            *hint,
        ));
    }
    if command == "force" && ["-F", "--force"].contains(&&**flag) {
        return Some(Problem::usage(
            "`mckibben force` gives the force at a pressure and a contraction",
            "`mckibben pressure` and `mckibben contraction` take a force",
        ));
    }
    let is_table = !flag.starts_with('-') && flag.contains('.');
    let of_table = ["--area", "--gauge-length", "--mode"].contains(&&**flag);
    let (what, hint) = if let Some(data) = context.flag_of("data").filter(|_| is_table) {
        ("a table stands behind its flag", format!("{data} {flag}"))
    } else if of_table && context.flag_of("set").is_some() {
        let name = flag[2..].replace('-', "_");
        ("it is a constant of a table", format!("--set {name}=VALUE"))
    } else {
        return None;
    };
    let thing = if is_table { "place for" } else { "flag" };
    Some(Problem::usage(
        format!("there is no {thing} {flag}: {what}"),
        format!("write {hint}"),
    ))
}

/// A command that is a study of the repository.
pub fn of_gone_command(error: &clap::Error) -> Option<Problem> {
    let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidSubcommand) else {
        return None;
    };
    (word == "validate")
        .then(|| Problem::usage("`validate` is now a study", "cargo study validation"))
}

/// A word that a command had, which is read as a file.
pub fn of_gone_word() -> Option<Problem> {
    const GONE: [([&str; 2], &str); 4] = [
        (
            ["campaign", "status"],
            "`mckibben campaign show DIR` has the shards, the rate and the summary",
        ),
        (["rubber", "fit"], "`mckibben rubber FILE` fits the laws"),
        (
            ["rubber", "list"],
            "`mckibben parts list rubbers` lists them",
        ),
        (["rubber", "show"], "`mckibben parts show NAME` shows it"),
    ];
    let words: Vec<_> = std::env::args_os().skip(1).take(2).collect();
    let ([command, word], hint) = GONE.iter().find(|(gone, _)| words == *gone)?;
    let message = format!("`mckibben {command}` has no {word} any more");
    Some(Problem::usage(message, *hint))
}

/// An argument whose letters are not those of a text.
pub fn of_letters(error: &clap::Error) -> Option<Problem> {
    if error.kind() != ErrorKind::InvalidUtf8 {
        return None;
    }
    let arg = std::env::args_os().find(|arg| arg.to_str().is_none())?;
    let message = format!("the argument \"{}\" is not UTF-8", arg.to_string_lossy());
    Some(Problem::usage(message, "rename the file"))
}

/// A command line that clap refuses.
pub fn unparsed(error: &clap::Error) -> Problem {
    let text = error.render().to_string();
    // The sentence and the indented lines below it; usage follows after an empty line.
    Problem::usage(
        joined(
            text.lines()
                .take_while(|l| !l.trim().is_empty())
                .map(str::trim),
            " ",
        )
        .trim_start_matches("error: "),
        "see `mckibben --help`",
    )
}

/// Standard output that cannot be written. Where only its reader went away (`| head`) there is
/// nothing to say.
pub fn unprinted(error: &io::Error) -> Problem {
    let message = match error.kind() {
        io::ErrorKind::BrokenPipe => String::new(),
        _ => format!("cannot write to standard output: {error}"),
    };
    ProblemKind::Output.problem(message)
}

/// A problem in the words of the command line: flags in place of fields, and what to do where the
/// layers below do not say it. A note on the unit of a pressure comes first, unless a text was not
/// understood.
pub fn in_words(mut problem: Problem, context: &Context) -> Problem {
    // What is in backquotes there are keys of a file.
    if !matches!(problem.kind, ProblemKind::File | ProblemKind::Formula) {
        problem.message = context.in_flags(&problem.message);
    }
    let flag = problem.field.as_deref().and_then(|f| context.flag_of(f));
    if let Some(flag) = flag.filter(|flag| !problem.message.starts_with(flag)) {
        problem.message = format!("{flag}: {}", problem.message);
    }
    problem.hint = match (&*problem.hint, problem.kind) {
        ("", ProblemKind::Rubber) => "`mckibben parts list rubbers` shows all names".into(),
        ("", ProblemKind::Braid) => "`mckibben parts list sleeves` shows all sleeves".into(),
        ("", ProblemKind::Model) => "`mckibben parts list models` shows them".into(),
        ("", ProblemKind::Formula) => "`mckibben fit` writes such files".into(),
        ("", ProblemKind::Parameter) => "`mckibben identify --help` shows the forms".into(),
        (hint, _) => context.in_flags(hint),
    };
    let is_understood = !matches!(
        problem.kind,
        ProblemKind::Usage | ProblemKind::Quantity | ProblemKind::File
    );
    if let Some(note) = context.unit_note.as_deref().filter(|_| is_understood) {
        problem.hint = match &*problem.hint {
            "" => note.into(),
            hint => format!("{note}; else {hint}"),
        };
    }
    problem
}

/// `error: …` once a mistake, and the hint below it, in the units that the user reads.
pub fn as_text(problem: &Problem, units: &Units) -> String {
    let line = |start, text: &str| format!("{start}: {}", clean::line(&units.sentence(text)));
    let mut lines = Vec::from_iter(problem.messages().map(|m| line("error", m)));
    if !problem.hint.is_empty() {
        lines.push(line("  hint", &problem.hint));
    }
    lines.join("\n")
}

/// `{"error": {"kind", "message", "hint"}}` on one line.
pub fn as_json(problem: &Problem) -> String {
    plain(serde_json::json!({ "error": problem }).to_string())
}

/// The exit code of an answer that may have a problem.
pub fn exit_code(problem: Option<&Problem>) -> u8 {
    problem.map_or(0, |problem| problem.kind.ending() as u8)
}

/// Exit code where no answer exists.
pub const NO_ANSWER: u8 = Ending::NoAnswer as u8;
/// Exit code for a computation that did not converge.
pub const NOT_CONVERGED: u8 = Ending::NotConverged as u8;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_problem_with_its_exit_code() {
        let index = [1, 2].len();
        let work = || -> Result<u8, Problem> { Ok([1, 2][index]) };
        let problem = mckibben_app::guarded(work).unwrap_err();
        assert_eq!(exit_code(Some(&problem)), 4);
        let text = as_text(&problem, &Units::default());
        assert!(
            text.contains(": index out of bounds: the len is 2"),
            "{text}"
        );
        assert!(text.contains("hint: please report"), "{text}");
        let json = as_json(&problem);
        assert!(
            json.starts_with("{\"error\":{\"kind\":\"internal\""),
            "{json}"
        );
    }
}
