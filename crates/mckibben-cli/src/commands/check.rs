//! `check`: what is known of a muscle, whether it is plausible, what is not known, and what to
//! measure first; or a formula's file.

use crate::{Args, Format, Problem, commands::fit::formula_text, emit, files};
use mckibben_app::{CheckFormulaRequest, Model, ProblemKind, check, check_formula};
use std::path::Path;

/// Whether a word is a formula in place of a muscle.
fn is_formula(word: &str) -> bool {
    ["universal", "universal-small"].contains(&word)
        || Path::new(word)
            .extension()
            .is_some_and(|end| end.eq_ignore_ascii_case("json"))
}

pub fn run(args: &Args) -> Result<u8, Problem> {
    let word = args.text("file").or_else(|| args.text("muscle"));
    if let Some(word) = word.filter(|word| is_formula(word)) {
        return show_formula(&word, args);
    }
    if args.is("latex") {
        let message = "--latex is of a formula, not of a muscle";
        return Err(Problem::new(
            ProblemKind::Usage,
            message,
            "`mckibben check formula.json --latex`",
        ));
    }
    args.output(&check(&args.request()?)?)
}

/// Shows a formula: a file, or one that is built in.
fn show_formula(word: &str, args: &Args) -> Result<u8, Problem> {
    let built_in = Model::is_taken(word);
    let file = if built_in {
        None
    } else {
        files::formula(word)?
    };
    if file.is_none() && !built_in {
        let message = format!("{word}: cannot be read: there is no such file");
        return Err(Problem::new(
            ProblemKind::Formula,
            message,
            "`mckibben fit` writes such files",
        ));
    }
    if args.text("pressure_mpa").is_some() {
        return Err(Problem::new(
            ProblemKind::Usage,
            "--pressure is of a muscle, not of a formula",
            "",
        ));
    }
    let latex = args.is("latex");
    let answer = check_formula(&CheckFormulaRequest {
        file,
        name: built_in.then(|| word.to_owned()),
        latex,
    })?;
    match answer
        .latex
        .as_ref()
        .filter(|_| args.format == Format::Text)
    {
        Some(latex) => emit(latex, args.path("output").as_deref()).map(|()| 0),
        None => args.show(&answer, "terms", |answer, _| {
            formula_text(&answer.formula, true)
        }),
    }
}
