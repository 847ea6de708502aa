//! `check`: what is known of a muscle, whether it is plausible, what is not known, and what to
//! measure first; or a formula's file.

use crate::{
    Args, FLAT, Format, Problem, Units, burst_first, commands::fit::formula_text, emit, files,
    pairs, shown,
};
use mckibben::warning::is_of_burst;
use mckibben_app::rows::{characteristic_rows, muscle_sheets};
use mckibben_app::{
    CheckAnswer, CheckFormulaRequest, FindingKind, Model, ProblemKind, check, check_formula,
};
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
    let answer = check(&args.request()?)?;
    args.show(&answer, FLAT, text)
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
