//! `check`: what is known of a muscle, whether it is plausible, what is not known, and what to
//! measure first; or a formula's file.

use crate::{
    FLAT, Format, Output, Problem, Units, burst_first, commands::fit::formula_text, emit, pairs,
    shown,
};
use mckibben::warning::is_of_burst;
use mckibben_app::rows::{characteristic_rows, muscle_sheets};
use mckibben_app::{
    CheckAnswer, CheckFormulaRequest, CheckRequest, FindingKind, ProblemKind, TextFile, check,
    check_formula,
};
use std::path::Path;

/// What is known of a muscle, or of a formula.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben check examples/prototype.toml -p 2bar
  mckibben check -D 40 -s 2 --rubber dragon-skin-30
  mckibben check universal --latex")]
pub struct Check {
    #[command(flatten)]
    request: CheckRequest,
    /// Of a formula (FILE.json, universal, universal-small): print its equation with its numbers as
    /// LaTeX
    #[arg(long, help_heading = "Question")]
    latex: bool,
    #[command(flatten)]
    output: Output,
}

impl Check {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        let file = self.request.question.muscle.file();
        if let Some(formula) = file.and_then(formula) {
            return self.show_formula(formula, format);
        }
        if self.latex {
            let message = "--latex is of a formula, not of a muscle";
            return Err(Problem::new(
                ProblemKind::Usage,
                message,
                "`mckibben check formula.json --latex`",
            ));
        }
        let answer = check(&self.request)?;
        self.output.show(format, &answer, FLAT, text)
    }

    fn show_formula(self, formula: CheckFormulaRequest, format: Format) -> Result<u8, Problem> {
        if self.request.pressure_mpa.is_some() {
            let message = "--pressure is of a muscle, not of a formula";
            return Err(Problem::new(ProblemKind::Usage, message, ""));
        }
        let answer = check_formula(&CheckFormulaRequest {
            latex: self.latex,
            ..formula
        })?;
        match answer.latex.as_ref().filter(|_| format == Format::Text) {
            Some(latex) => emit(latex, self.output.output.as_deref()).map(|()| 0),
            None => self.output.show(format, &answer, "terms", |answer, _| {
                formula_text(&answer.formula, true)
            }),
        }
    }
}

/// The formula that is named in the place of a muscle.
fn formula(file: &TextFile) -> Option<CheckFormulaRequest> {
    if ["universal", "universal-small"].contains(&&*file.name) {
        return Some(CheckFormulaRequest {
            name: Some(file.name.clone()),
            ..CheckFormulaRequest::default()
        });
    }
    let end = Path::new(&file.name).extension()?;
    end.eq_ignore_ascii_case("json")
        .then(|| CheckFormulaRequest {
            file: Some(file.clone()),
            ..CheckFormulaRequest::default()
        })
}

/// The kinds, each with its heading, and what is said where nothing was found.
const HEADINGS: [(FindingKind, &str, &str); 4] = [
    (
        FindingKind::Implausible,
        "Is it plausible?",
        "nothing unusual was found",
    ),
    (
        FindingKind::Unknown,
        "What is not known",
        "nothing is missing",
    ),
    (
        FindingKind::Outside,
        "Outside of the measured muscles",
        "it lies within the sizes and pressures of measured muscles",
    ),
    (
        FindingKind::Measure,
        "What to measure first",
        "no measurement would reduce the ± much",
    ),
];

fn text(answer: &CheckAnswer, u: &Units) -> String {
    let burst: Vec<&String> = answer.warnings.iter().filter(|w| is_of_burst(w)).collect();
    let sheets = muscle_sheets(answer, u).map(|(head, rows)| format!("{head}\n{}\n", pairs(&rows)));
    let mut out = burst_first(&burst) + &sheets.concat();
    if let Some(c) = &answer.characteristics {
        let at = u.pressure.show(c.pressure_mpa);
        out += &format!(
            "At {at}, model {}\n{}",
            c.model,
            pairs(&characteristic_rows(c, u))
        );
        out.extend(c.uncertainty_words.text_in(u).map(|parts| parts + "\n"));
    }
    for (kind, heading, none) in HEADINGS {
        let mut said = answer.said(kind, u);
        if said.is_empty() {
            said.push(none.into());
        }
        out += &format!("\n{heading}\n");
        out.extend(
            said.iter()
                .map(|line| format!("  - {}\n", shown::sentence(line))),
        );
    }
    out
}
