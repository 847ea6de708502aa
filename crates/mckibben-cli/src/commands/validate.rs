//! `validate`: verification and validation, each with its table.

use crate::{Bar, Context, NO_ANSWER, Output, Plot, Problem, examples::examples, output::width};
use mckibben_app::{
    MeasuredFolder, MeasuredRequest, ProblemKind, ValidateRequest, measured_folder,
};
use mckibben_core::joined;
use mckibben_fit::validation::built_in::built_in;
use std::path::{Path, PathBuf};

/// Where tables are as wide, they have the sources of the cases.
const WITH_SOURCES: usize = 160;

/// Verification and validation.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "validate",
    "validate --measured --only dmsp-20-300",
    "validate --measured --only dmsp-10-hose --model thick-wall",
    "validate --measured --only rubber-treloar"
]))]
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
    pub fn run(self, context: &Context) -> Result<u8, Problem> {
        if let Some(folder) = self.measured {
            let cases = folder.map_or_else(|| Ok(built_in()), |folder| folders(&folder))?;
            let request = MeasuredRequest {
                cases: chosen(cases, &self.only)?,
                model: self.model,
                figure: self.plot.wanted(context),
            };
            let mut answer = mckibben_app::measured(&request, &Bar::new("fits"))?;
            self.plot.save(context, &mut answer.figure)?;
            return self.output.print(context, &answer);
        }
        if self.plot.plot.is_some() {
            let message = "--plot draws the measured muscles: it requires --measured";
            let hint = "mckibben validate --measured --plot FILE.svg";
            return Err(Problem::usage(message, hint));
        }
        let mut answer = mckibben_app::validate(&self.request, &Bar::new("groups of cases"))?;
        answer.has_sources = width::of_result(self.output.output.as_deref())
            .is_some_and(|width| width >= WITH_SOURCES);
        self.output.print(context, &answer)?;
        Ok(if answer.ok() { 0 } else { NO_ANSWER })
    }
}

/// The measured muscle or rubber of a folder, or those of the folders in it.
fn folders(folder: &Path) -> Result<Vec<MeasuredFolder>, Problem> {
    let unread =
        |e: std::io::Error| ProblemKind::File.problem(format!("{}: {e}", folder.display()));
    if folder.join("case.toml").is_file() {
        return Ok(vec![measured_folder(folder)?]);
    }
    let entries = std::fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let list = entries
        .map_err(unread)?
        .into_iter()
        .map(|entry| entry.path())
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
        return Err(ProblemKind::Usage.problem(format!(
            "there is no measured muscle or rubber \"{name}\"; there are {}",
            joined(all.iter().map(|c| c.name.as_str()), ", ")
        )));
    }
    Ok(all
        .into_iter()
        .filter(|c| only.is_empty() || only.contains(&c.name))
        .collect())
}
