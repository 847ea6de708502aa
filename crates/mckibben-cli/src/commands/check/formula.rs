//! `check` of a formula's file.

use crate::{Asked, Failure, Format, commands::fit::formula_text, emit, files};
use mckibben_app::{CheckFormulaRequest, Model, ProblemKind, check_formula};

/// Shows a formula: a file, or one that is built in.
pub(super) fn show(word: &str, asked: &Asked) -> Result<u8, Failure> {
    let built_in = Model::is_taken(word);
    let file = if built_in { None } else { files::formula(word)? };
    if file.is_none() && !built_in {
        let message = format!("{word}: cannot be read: there is no such file");
        return Err(Failure::input(ProblemKind::Formula, message, "`mckibben fit` writes such files"));
    }
    if asked.text("pressure_mpa").is_some() {
        return Err(Failure::input(ProblemKind::Usage, "--pressure is of a muscle, not of a formula", ""));
    }
    let latex = asked.is("latex");
    let answer =
        check_formula(&CheckFormulaRequest { file, name: built_in.then(|| word.to_owned()), latex })?;
    match answer.latex.as_ref().filter(|_| asked.format == Format::Text) {
        Some(latex) => emit(latex, asked.path("output").as_deref()).map(|()| 0),
        None => asked.show(&answer, "terms", || formula_text(&answer.formula, true)),
    }
}
