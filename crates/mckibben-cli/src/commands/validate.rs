//! `validate`: verification and validation, each with its table.

use crate::{
    Bar, Format, NO_ANSWER, Output, Plot, Problem, Units, headed, listed, number, output::width,
    pairs, tabled, value,
};
use mckibben::verification::{CaseKind, Measure, VerificationRow};
use mckibben_app::{
    MeasuredAnswer, MeasuredBranch, MeasuredCase, MeasuredFolder, MeasuredRequest, MeasuredResult,
    MeasuredRubber, MeasuredRubberFit, MeasuredStress, ProblemKind, ValidateAnswer,
    ValidateRequest, in_one_line, measured_folder,
};
use mckibben_fit::validation::case::built_in;
use std::path::{Path, PathBuf};

/// Verification and validation.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben validate
  mckibben validate --measured --only dmsp-20-300
  mckibben validate --measured --only dmsp-10-hose --model thick-wall
  mckibben validate --measured --only rubber-treloar")]
pub struct Validate {
    #[command(flatten)]
    request: ValidateRequest,
    /// Validation report of measured muscles and rubbers: known data, fitted constants, errors at
    /// fitted points and at predicted points
    ///
    /// Cases of DIR, one folder each [the built-in cases].
    #[arg(long, value_name = "DIR", num_args = 0..=1, conflicts_with = "all")]
    measured: Option<Option<PathBuf>>,
    /// Only these cases, by folder name
    #[arg(
        long,
        value_name = "NAME,…",
        value_delimiter = ',',
        requires = "measured"
    )]
    only: Vec<String>,
    /// Model of the measured muscles [fe]
    #[arg(long, value_name = "NAME", requires = "measured")]
    model: Option<String>,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Validate {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        if let Some(folder) = self.measured {
            let cases = folder.map_or_else(|| Ok(built_in()), |folder| folders(&folder))?;
            let request = MeasuredRequest {
                cases: chosen(cases, &self.only)?,
                model: self.model,
                figure: self.plot.wanted(),
            };
            let mut answer = mckibben_app::measured(&request, &Bar::new("fits"))?;
            self.plot.save(&mut answer.figure)?;
            let rows = if answer.results.is_empty() {
                "stresses"
            } else {
                "results"
            };
            return self.output.show(format, &answer, rows, measured_text);
        }
        if self.plot.plot.is_some() {
            let message = "--plot draws the measured muscles: it requires --measured";
            let hint = "mckibben validate --measured --plot FILE.svg";
            return Err(Problem::new(ProblemKind::Usage, message, hint));
        }
        let answer = mckibben_app::validate(&self.request, &Bar::new("groups of cases"))?;
        self.output.show(format, &answer, "cases", as_text)?;
        Ok(if answer.ok() { 0 } else { NO_ANSWER })
    }
}

/// The cases of one kind, and what they are.
const KINDS: [(&str, CaseKind, Measure, &str); 4] = [
    (
        "verification",
        CaseKind::Verification,
        Measure::Value,
        "Verification: are the equations solved right?",
    ),
    (
        "measured pulls",
        CaseKind::Validation,
        Measure::Rms,
        "Validation: are they the right equations? Root mean square of the differences from \
         measured pulls in N, over the largest or blocked one",
    ),
    (
        "other measured quantities",
        CaseKind::Validation,
        Measure::Value,
        "Validation: other measured quantities",
    ),
    (
        "± of fe",
        CaseKind::Validation,
        Measure::Share,
        "Validation: which share of measured points does the ± cover?",
    ),
];

fn as_text(answer: &ValidateAnswer, u: &Units) -> String {
    // Their sources only where the tables are wide enough.
    let source = if width::of_tables() >= 160 {
        " source"
    } else {
        ""
    };
    let (mut out, mut summary) = (String::new(), "Summary\n".to_owned());
    for (name, kind, measure, title) in KINDS {
        let is_one = |c: &&VerificationRow| {
            c.kind == kind && (kind == CaseKind::Verification || c.measure == measure)
        };
        let list: Vec<&VerificationRow> = answer.cases.iter().filter(is_one).collect();
        let keys = "ok name=case reference:9~ ours:9~ error:2~ tolerance=allowed:2~";
        out += &format!(
            "{title}\n\n{}\n",
            tabled(&list, &format!("{keys}{source}"), u)
        );
        let held = list.iter().filter(|c| c.ok).count();
        summary += &format!("  {name}: {held} of {} cases hold\n", list.len());
    }
    let failed = answer
        .cases
        .iter()
        .filter(|c| !c.ok)
        .map(|c| format!("  FAILS: {}\n", c.name));
    summary.extend(failed);
    if source.is_empty() {
        summary += "\nSources of the cases: mckibben validate --format csv\n";
    }
    out + &summary
}

/// The measured muscle or rubber of a folder, or those of the folders in it.
fn folders(folder: &Path) -> Result<Vec<MeasuredFolder>, Problem> {
    let unread = |e: std::io::Error| {
        Problem::new(ProblemKind::File, format!("{}: {e}", folder.display()), "")
    };
    if folder.join("case.toml").is_file() {
        return Ok(vec![measured_folder(folder)?]);
    }
    let entries = std::fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let paths = entries
        .map_err(unread)?
        .into_iter()
        .map(|entry| entry.path());
    let list = paths
        .filter(|path| path.join("case.toml").is_file())
        .map(|path| measured_folder(&path));
    let mut list = list.collect::<Result<Vec<_>, _>>()?;
    list.sort_by(|a, b| a.name.cmp(&b.name));
    if list.is_empty() {
        let message = format!("{}: no folder in it contains a case.toml", folder.display());
        let hint = "a measured muscle is a folder with case.toml, muscle.toml and points.csv, a \
            measured rubber one without muscle.toml";
        return Err(Problem::new(ProblemKind::MissingInput, message, hint));
    }
    Ok(list)
}

fn chosen(all: Vec<MeasuredFolder>, only: &[String]) -> Result<Vec<MeasuredFolder>, Problem> {
    if let Some(name) = only
        .iter()
        .find(|name| !all.iter().any(|c| c.name == **name))
    {
        let known: Vec<&str> = all.iter().map(|c| c.name.as_str()).collect();
        let message = format!(
            "there is no measured muscle or rubber \"{name}\"; there are {}",
            known.join(", ")
        );
        return Err(Problem::new(ProblemKind::Usage, message, ""));
    }
    Ok(all
        .into_iter()
        .filter(|c| only.is_empty() || only.contains(&c.name))
        .collect())
}

fn measured_text(answer: &MeasuredAnswer, u: &Units) -> String {
    let head = format!(
        "Validation: {} against measured muscles. Bias is measured − computed; % is of the blocked \
         force; within ± is the share of the points inside the ±. Errors by contraction: --format \
         json\n",
        answer.model
    );
    let cases = answer
        .cases
        .iter()
        .map(|case| muscle(case, &answer.results, u));
    let rubbers = answer
        .rubbers
        .iter()
        .map(|case| rubber(case, &answer.stresses, u));
    let head = if answer.cases.is_empty() {
        None
    } else {
        Some(head)
    };
    head.into_iter().chain(cases).chain(rubbers).collect()
}

const FACTS: &str = "name=folder source terms known unknown points";
const STRESSES: &str = "rms_mpa=rms:3~ relative=of_the_measured:3%~ bias_mpa=bias:3~ \
    largest_mpa=largest:3~ points to_stretch:3 blind of fit";
const RESULTS: &str = "rms_n=rms:3 rms_of_blocked=of_the_blocked_force:3% bias_n=bias:3 \
    largest_n=largest:3 points unanswered held=within_±:3% blind of fitted_to fit";
const BRANCHES: &str = "branch points rms_n=rms:3 bias_n=bias:3 held=within_±:3% of";

fn rubber(case: &MeasuredRubber, stresses: &[MeasuredStress], u: &Units) -> String {
    let one = |f: &MeasuredRubberFit| {
        let constants = f
            .parameters
            .iter()
            .map(|p| format!("{} {} {}", p.name, number(p.value, 3), p.unit));
        let branches = f
            .prony
            .iter()
            .map(|(g, t)| format!("g {} at {} s", number(*g, 2), number(*t, 2)));
        let doubt = if f.stable {
            vec![]
        } else {
            vec!["not stable in a muscle".to_owned()]
        };
        let parts: Vec<String> = constants
            .chain(branches)
            .map(|t| t.trim().to_owned())
            .chain(doubt)
            .collect();
        (f.fit.clone(), parts.join(", "))
    };
    let fitted: Vec<(String, String)> = case.fits.iter().map(one).collect();
    let errors: Vec<_> = stresses
        .iter()
        .filter(|s| s.case == case.facts.name)
        .collect();
    let title = format!("{}; % is of the measured stress", case.facts.title);
    block(
        &title,
        &listed(&value(case), FACTS, u),
        &fitted,
        &tabled(&errors, STRESSES, u),
    )
}

fn muscle(case: &MeasuredCase, results: &[MeasuredResult], u: &Units) -> String {
    let fits = case.fits.iter().filter(|f| !f.parameters.is_empty());
    let fitted: Vec<(String, String)> = fits
        .map(|f| {
            (
                format!("{} [{}]", f.fit, f.fitted_to),
                in_one_line(&f.parameters),
            )
        })
        .collect();
    let of_case: Vec<_> = results
        .iter()
        .filter(|r| r.case == case.facts.name)
        .collect();
    let branches = of_case.iter().flat_map(|r| {
        let row = move |branch: &MeasuredBranch| {
            let mut row = value(branch);
            row["of"] = format!("{} [{}]", r.fit, r.group.of).into();
            row
        };
        r.group.by_branch.iter().map(row)
    });
    let errors = tabled(&of_case, RESULTS, u) + &headed("Branches", branches, BRANCHES, u);
    let title = format!("{}, points that pull", case.facts.title);
    block(&title, &listed(&value(case), FACTS, u), &fitted, &errors)
}

/// What is known of a case, its fitted constants, and the errors.
fn block(
    title: &str,
    facts: &[(String, String)],
    fitted: &[(String, String)],
    errors: &str,
) -> String {
    format!(
        "\n{title}\n\n{}\nFound, ± 95 %\n{}\n{errors}",
        pairs(facts),
        pairs(fitted)
    )
}
