//! What a command ends with when it does not end well: kind, message, hint, exit code, in the words of the command line.

use crate::{Flag, clean, shown, spec};
use mckibben_app::{Ending, Problem, ProblemKind};
use mckibben_io::files::ReadError;
use std::{path::Path, sync::OnceLock};

/// A problem as a user of the command line meets it.
#[derive(Debug)]
pub struct Failure {
    problem: Box<Problem>,
    broken_pipe: bool,
}

/// The flags of the command that runs.
static FLAGS: OnceLock<Vec<Flag>> = OnceLock::new();

/// Takes the flags of the command that runs, for its messages.
pub fn take_flags(flags: &[Flag]) {
    FLAGS.get_or_init(|| flags.to_vec());
}

/// A sentence with flags in place of the fields that it names in backquotes.
pub fn in_flags(sentence: &str) -> String {
    spec::in_flags(sentence, FLAGS.get().map_or(&[], Vec::as_slice))
}

impl Failure {
    /// Wrong input that only the command line can meet.
    pub fn input(kind: ProblemKind, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Problem::new(kind, message, hint).into()
    }

    /// The same with what the user should mind in the first place, unless what he typed means nothing.
    pub fn with_hint(mut self, mind: Option<&str>) -> Self {
        let asked =
            !matches!(self.problem.kind, ProblemKind::Usage | ProblemKind::Quantity | ProblemKind::File);
        if let Some(mind) = mind.filter(|_| asked) {
            let before = std::mem::take(&mut self.problem.hint);
            self.problem.hint =
                if before.is_empty() { mind.into() } else { format!("{mind}; else {before}") };
        }
        self
    }

    /// A flag's value that means nothing.
    pub fn flag(flag: &str, kind: ProblemKind, error: impl std::fmt::Display) -> Self {
        Self::input(kind, format!("{flag}: {error}"), "")
    }

    /// A command line that clap refuses.
    pub fn usage(error: &clap::Error) -> Self {
        let text = error.render().to_string();
        // The sentence and the indented lines below it; usage follows after an empty line.
        let lines: Vec<&str> = text.lines().take_while(|l| !l.trim().is_empty()).map(str::trim).collect();
        let message = lines.join(" ");
        Self::input(ProblemKind::Usage, message.trim_start_matches("error: "), "see `mckibben --help`")
    }

    /// A file that is not read, whatever it holds.
    pub fn unread(path: &Path, error: &ReadError) -> Self {
        let hint = match error {
            ReadError::System(e) if e.kind() != std::io::ErrorKind::NotFound => {
                "the operating system refused to read it; it is not necessarily damaged"
            }
            _ => "",
        };
        Self::input(ProblemKind::File, format!("{} {error}", path.display()), hint)
    }

    /// A result that cannot be written.
    pub fn unwritable(path: &Path, error: &std::io::Error) -> Self {
        let hint = "nothing was written; an existing file is as it was";
        Self::input(ProblemKind::Output, format!("cannot write {}: {error}", path.display()), hint)
    }

    /// Standard output that cannot be written; a closed pipe (`| head`) is no failure.
    pub fn stdout(error: &std::io::Error) -> Self {
        let message = format!("cannot write to standard output: {error}");
        let broken_pipe = error.kind() == std::io::ErrorKind::BrokenPipe;
        Self { broken_pipe, ..Self::input(ProblemKind::Output, message, "") }
    }

    /// Whether it is only the reader of our output that went away.
    pub fn is_broken_pipe(&self) -> bool {
        self.broken_pipe
    }

    pub fn into_problem(self) -> Problem {
        *self.problem
    }

    /// Whether the program itself is at fault.
    pub fn is_internal(&self) -> bool {
        self.problem.kind == ProblemKind::Internal
    }

    pub fn exit(&self) -> u8 {
        self.problem.kind.ending() as u8
    }

    /// `error: …`, and the hint below it, in the units that the user reads.
    pub fn to_text(&self) -> String {
        let [message, hint] = [&self.problem.message, &self.problem.hint].map(|text| shown::sentence(text));
        let (message, hint) = (clean::line(&message), clean::line(&hint));
        if hint.is_empty() {
            format!("error: {message}")
        } else {
            format!("error: {message}\n  hint: {hint}")
        }
    }

    /// `{"error": {"kind", "message", "hint"}}` on one line.
    pub fn to_json(&self) -> String {
        serde_json::json!({ "error": &*self.problem }).to_string()
    }
}

impl From<Problem> for Failure {
    fn from(mut problem: Problem) -> Self {
        // What is in backquotes there are keys of a file.
        if !matches!(problem.kind, ProblemKind::File | ProblemKind::Formula) {
            problem.message = in_flags(&problem.message);
        }
        let named = |flag: &String| problem.message.starts_with(flag.as_str());
        let flags = FLAGS.get().map_or(&[][..], Vec::as_slice);
        let flag = problem.field.as_deref().and_then(|field| spec::flag_of(field, flags));
        if let Some(flag) = flag.filter(|flag| !named(flag)) {
            problem.message = format!("{flag}: {}", problem.message);
        }
        problem.hint = in_flags(&problem.hint);
        if problem.hint.is_empty() {
            problem.hint = match problem.kind {
                ProblemKind::Rubber => "`mckibben parts list rubbers` shows all names",
                ProblemKind::Braid => "`mckibben parts list sleeves` shows all sleeves",
                ProblemKind::Model => "`mckibben parts list models` shows them",
                ProblemKind::Formula => "`mckibben fit` writes such files",
                ProblemKind::Parameter => "`mckibben identify --help` shows the forms",
                _ => "",
            }
            .into();
        }
        Self { problem: Box::new(problem), broken_pipe: false }
    }
}

/// Exit code where no answer exists.
pub const NO_ANSWER: u8 = Ending::NoAnswer as u8;
/// Exit code for a computation that did not converge.
pub const NOT_CONVERGED: u8 = Ending::NotConverged as u8;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_become_flags() {
        let fields = serde_json::json!({ "pressures_mpa": {}, "two_sided": {} });
        take_flags(&spec::flags(
            "pressures_mpa=pressure two_sided",
            &serde_json::json!({ "properties": fields }),
        ));
        let problem =
            Problem::new(ProblemKind::Quantity, "`strand_length_mm` and `turns`, not `paper`", "`two_sided`");
        let failure = Failure::from(problem.in_field("pressures_mpa"));
        assert_eq!(
            failure.to_text(),
            "error: --pressure: --strand-length and --turns, not `paper`\n  hint: --two-sided"
        );
        assert_eq!(failure.exit(), 2);
        assert!(failure.to_json().contains("\"field\":\"pressures_mpa\""));
    }

    #[test]
    fn a_panic_is_a_failure_with_an_exit_code_of_its_own() {
        let index = [1, 2].len();
        let work = || -> Result<u8, Failure> { Ok([1, 2][index]) };
        let failure = mckibben_app::guarded(work).unwrap_err();
        assert_eq!(failure.exit(), 4);
        let text = failure.to_text();
        assert!(text.contains(": index out of bounds: the len is 2"), "{text}");
        assert!(text.contains("hint: please report"), "{text}");
        assert!(failure.to_json().starts_with("{\"error\":{\"kind\":\"internal\""), "{}", failure.to_json());
    }
}
