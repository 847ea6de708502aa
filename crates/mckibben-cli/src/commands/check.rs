//! `check`: what is known of a muscle, whether it is plausible, what is not known, and what to
//! measure first; or a formula's file.

use crate::{Context, Format, Output, Problem, Result, examples::examples};
use mckibben_app::{CheckFormulaRequest, CheckRequest, TextFile, check, check_formula};
use std::path::Path;

/// What is known of a muscle, or of a formula.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "check examples/prototype.toml -p 2bar",
    "check -D 40 -s 2 --rubber dragon-skin-30",
    "check universal --latex",
    "check paper"
]))]
pub struct Check {
    #[command(flatten)]
    request: CheckRequest,
    /// Of a formula (FILE.json, paper, universal): print its equation with its numbers as LaTeX,
    /// and a table of its coefficients
    #[arg(long)]
    latex: bool,
    #[command(flatten)]
    output: Output,
}

impl Check {
    pub fn run(self, context: &Context) -> Result<u8> {
        let file = self.request.question.muscle.file();
        if let Some(formula) = file.and_then(formula) {
            return self.show_formula(formula, context);
        }
        if self.latex {
            return Err(Problem::usage(
                "--latex is of a formula, not of a muscle",
                "`mckibben check formula.json --latex`",
            ));
        }
        let answer = check(&self.request)?;
        self.output.print(context, &answer)
    }

    fn show_formula(self, formula: CheckFormulaRequest, context: &Context) -> Result<u8> {
        if self.request.pressure_mpa.is_some() {
            return Err(Problem::usage(
                "--pressure is of a muscle, not of a formula",
                "the prototype of the paper is the muscle of `mckibben check` without a name",
            ));
        }
        let answer = check_formula(&CheckFormulaRequest {
            latex: self.latex,
            ..formula
        })?;
        match answer
            .latex
            .as_ref()
            .filter(|_| context.format == Format::Text)
        {
            Some(latex) => context
                .emit(latex, self.output.output.as_deref())
                .map(|()| 0),
            None => self.output.print(context, &answer),
        }
    }
}

/// The formula that is named in the place of a muscle.
fn formula(file: &TextFile) -> Option<CheckFormulaRequest> {
    let mut request = CheckFormulaRequest::default();
    let built_in = ["paper", "universal"];
    if file.text.is_empty() && built_in.contains(&&*file.name) {
        request.name = Some(file.name.clone());
        return Some(request);
    }
    let end = Path::new(&file.name).extension()?;
    request.file = Some(file.clone());
    end.eq_ignore_ascii_case("json").then_some(request)
}
